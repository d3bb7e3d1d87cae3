// SPDX-License-Identifier: MIT
// Draws frames with the page's module without a browser, for comparison with the
// program's frames:
//
//   node tests/web/frames.js PAGE <LIST
//
// PAGE is the output folder of `make web`; a line of LIST is "SCENE WxH FORMAT
// [NAME=VALUE]... FRAME...", frames in rising order. Prints "SCENE WxH FORMAT frame 0000 crc32 ...".
'use strict';
const fs = require('fs'), path = require('path'), vm = require('vm');

const folder = process.argv[2];
for (const name of ['files.js', 'module.js', 'png.js', 'engine.js'])
    vm.runInThisContext(fs.readFileSync(path.join(folder, name), 'utf8'), name);

const FORMATS = ['xrgb8888', 'rgb565', 'rgb565be', 'p8', 'l8', 'i1'];

async function draw(engine, line) {
    const [scene, size, format, ...rest] = line.split(' ').filter(Boolean);
    const frames = rest.filter(word => !word.includes('='));
    engine.choose(engine.scenes.findIndex(s => s.name === scene));
    for (const [name, value] of rest.map(word => word.split('=')).filter(s => s[1]))
        engine.put(engine.find(name), value);
    await engine.load();
    engine.build(...size.split('x').map(Number), FORMATS.indexOf(format), false);
    for (let n = 0, at = 0; at < frames.length; n = engine.step())
        if (n === +frames[at]) {
            engine.draw();
            console.log(`${scene} ${size} ${format} frame ${String(n).padStart(4, '0')}`
                        + ` crc32 ${engine.crc()}`);
            at++;
        }
}

(async () => {
    const engine = await openEngine();
    for (const line of fs.readFileSync(0, 'utf8').split('\n').filter(Boolean))
        await draw(engine, line);
})().catch(error => {
    console.error(error);
    process.exit(1);
});
