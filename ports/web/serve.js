// SPDX-License-Identifier: MIT
// Serves a folder to this machine only:  node ports/web/serve.js FOLDER [PORT]
// Uses port 8080 or the next free one.  Exit codes: 2 wrong usage, 3 cannot serve.
'use strict';
const fs = require('fs'), http = require('http'), path = require('path');

const TYPES = { '.html': 'text/html; charset=utf-8', '.css': 'text/css; charset=utf-8',
                '.js': 'text/javascript; charset=utf-8' };
const folder = path.resolve(process.argv[2] || 'build/web');
const first = Number(process.argv[3] || 8080);

const stop = (code, text) => {
    console.error(text);
    process.exit(code);
};
if (process.argv.length > 4 || !(Number.isInteger(first) && first > 0 && first < 65536))
    stop(2, 'usage: node ports/web/serve.js FOLDER [PORT]');
if (!fs.existsSync(path.join(folder, 'index.html')))
    stop(3, `serve: ${folder}: no index.html; \`make web\` builds the page`);

const server = http.createServer((request, answer) => {
    const refuse = code => {
        answer.writeHead(code, { 'Content-Type': 'text/plain' });
        answer.end(`${code} ${http.STATUS_CODES[code]}\n`);
    };
    let name;
    try {
        name = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    } catch (error) {
        return refuse(400);
    }
    const file = path.join(folder, name.endsWith('/') ? name + 'index.html' : name);
    const type = TYPES[path.extname(file)];
    if (!['GET', 'HEAD'].includes(request.method))
        return refuse(405);
    if (!type || !file.startsWith(folder + path.sep))
        return refuse(404);
    fs.readFile(file, (error, bytes) => {
        if (error)
            return refuse(404);
        answer.writeHead(200, { 'Content-Type': type, 'Content-Length': bytes.length,
                                'Cache-Control': 'no-cache' });
        answer.end(request.method === 'HEAD' ? undefined : bytes);
    });
});

let port = first;
server.on('error', error => {
    if (error.code !== 'EADDRINUSE' || port >= Math.min(first + 20, 65535))
        stop(3, `serve: ${error.message}`);
    server.listen(++port, 'localhost');
});
server.on('listening', () =>
    console.log(`http://localhost:${server.address().port}/   (Ctrl+C ends it)`));
server.listen(port, 'localhost');
