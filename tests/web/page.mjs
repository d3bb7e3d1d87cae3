// SPDX-License-Identifier: MIT
// Drives a browser through the page like a user, and compares the displayed picture with
// the program's frames.
//
//   node tests/web/page.mjs CLIENT PAGE PROGRAM URL ASSETS
//
// CLIENT holds node_modules, PAGE is build/web, URL is the address of the served page.
// Prints one line a case.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import vm from 'node:vm';

const [client, folder, program, url, assets] = process.argv.slice(2);
const { chromium } = createRequire(path.join(client, 'x.js'))('playwright-core');
vm.runInThisContext(fs.readFileSync(path.join(folder, 'png.js'), 'utf8'));

const index = `file://${folder}/index.html`;
let failures = 0;

function is(name, got, wanted) {
    const fits = got === wanted;
    failures += !fits;
    console.log(fits ? `ok - ${name}` : `FAILED - ${name}: '${got}' is not '${wanted}'`);
}

/* "frame 0003 crc32 xxxxxxxx" of the program. */
function told(scene, size, frame, ...settings) {
    return execFileSync(program, ['render', scene, '--size', size, '--frames',
        `${frame}:${frame}`, '--hash', ...settings.flatMap(s => ['--set', s])],
    { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim();
}

/* CRC of the pixels 0x__RRGGBB, the program's sum. */
function crcOf(pixels) {
    let crc = -1;
    for (const pixel of pixels)
        for (const byte of [pixel & 255, pixel >> 8 & 255, pixel >> 16 & 255, 0]) {
            crc ^= byte;
            for (let i = 0; i < 8; i++)
                crc = crc & 1 ? crc >>> 1 ^ 0xedb88320 : crc >>> 1;
        }
    return (~crc >>> 0).toString(16).padStart(8, '0');
}

/* -- parts of the page ----------------------------------------------------------- */

const complaints = [], asked = [];

async function open(context, address) {
    const page = await context.newPage();
    page.setDefaultTimeout(20000);
    page.on('console', said => {
        if (['error', 'warning'].includes(said.type()))
            complaints.push(said.text());
    });
    page.on('pageerror', error => complaints.push(error.message));
    page.on('request', r => asked.push(r.url()));
    await page.goto(address);
    await page.waitForFunction(() => globalThis.tidepool);
    return page;
}

const idle = page => page.waitForFunction(
    () => !tidepool.state.busy && !tidepool.state.stale);
const sum = page => page.textContent('#sum');
const alertOf = page => page.evaluate(() => {
    const node = document.getElementById('alert');
    return node.hidden ? '' : node.firstElementChild.textContent;
});
const field = name => `[id="p-${name}"]`;
const value = (page, name) => page.inputValue(field(name));
const frame = page => page.evaluate(() => tidepool.state.frame);
const camera = page => page.evaluate(() => [...tidepool.engine.camera()].join(' '));

/* Waits until a change has reached the picture. */
async function settle(page) {
    await page.evaluate(() => new Promise(done =>
        requestAnimationFrame(() => requestAnimationFrame(done))));
    await idle(page);
}

/* True if the camera moves while a key is held. */
async function held(page, key) {
    const before = await camera(page);
    await page.locator('#canvas').focus();
    await page.keyboard.down(key);
    const moved = await page.waitForFunction(
        at => [...tidepool.engine.camera()].join(' ') !== at, before)
        .then(() => true, () => false);
    await page.keyboard.up(key);
    await settle(page);
    return moved;
}

async function type(page, name, text) {
    await page.evaluate(id => {
        document.getElementById(id).closest('details').open = true;
    }, `p-${name}`);
    await page.fill(field(name), text);
    await page.press(field(name), 'Enter');
    await settle(page);
}

async function pick(page, id, text) {
    await page.selectOption(id, text);
    await settle(page);
}

/* -- cases ----------------------------------------------------------------------- */

async function moves(page) {
    const before = await frame(page);
    await page.waitForFunction(n => tidepool.state.frame > n + 3, before);
    is('it moves as soon as it is open', await alertOf(page), '');
    await page.click('#pause');
    const stood = await frame(page);
    await page.waitForTimeout(120);
    is('a click on Pause stops it', await frame(page), stood);
    await page.click('#step');
    await settle(page);
    is('and Step goes one picture on', await frame(page), stood + 1);
    await page.check('#crc');
    is('the CRC that it shows is the program\'s', await sum(page),
       told('three-swells', '640x480', stood + 1));
}

async function exact(page) {
    await pick(page, '#size', '160x120');
    await pick(page, '#zoom', '1');
    const at = String(await frame(page)).padStart(4, '0');
    const crc = told('three-swells', '160x120', +at);
    is('in another size the same water goes on', await sum(page), crc);
    const pixels = await page.evaluate(() => {
        const canvas = document.getElementById('canvas');
        const data = canvas.getContext('2d').getImageData(0, 0, 160, 120).data, all = [];
        for (let i = 0; i < data.length; i += 4)
            all.push(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
        return all;
    });
    is('and so are the pixels of its canvas', `frame ${at} crc32 ${crcOf(pixels)}`, crc);
    const shot = await page.locator('#canvas').screenshot();
    const seen = await png.colours(new Uint8Array(shot));
    is('and those of a screenshot', `frame ${at} crc32 ${crcOf(seen.pixels)}`, crc);
}

async function scenes(page) {
    const names = await page.$$eval('#scene option', all => all.map(o => o.value));
    const memory = () => page.evaluate(() => tidepool.engine.facts()[3]);
    const wrong = [];
    for (const name of names) {
        await pick(page, '#scene', name);
        if (await sum(page) !== told(name, '160x120', 0) || await alertOf(page))
            wrong.push(name);
    }
    is(`every one of the ${names.length} scenes is picked, and is the program's`,
       wrong.join(' '), '');
    const before = await memory();
    for (const name of ['storm', 'tank', names[names.length - 1]])
        await pick(page, '#scene', name);
    is('scenes that were shown before take no more memory', await memory(), before);
}

async function values(page) {
    await pick(page, '#scene', 'storm');
    await type(page, 'wave0.amplitude', '0.8');
    await page.focus('#crc');
    await page.keyboard.press('r');
    await settle(page);
    is('a number that is typed is drawn', await sum(page),
       told('storm', '160x120', 0, 'wave0.amplitude=0.8'));
    await type(page, 'wave0.amplitude', '999');
    is('one out of its range is refused in words', await alertOf(page),
       'wave0.amplitude = 999: outside 0 … 16 m');
    is('and the old one stays', await value(page, 'wave0.amplitude'), '0.8');
    await page.click('.row[data-name="wave0.amplitude"] .undo');
    await settle(page);
    is('a value is reset', await value(page, 'wave0.amplitude'), '1.05');

    await type(page, 'grid.vertices', '600');
    await page.click('.row[data-name="grid.vertices"] .undo');
    await page.evaluate(() => ['layer0', 'water', 'tank', 'quality'].forEach(name => {
        document.querySelector(`[data-group="${name}"]`).open = true;
    }));
    await pick(page, field('layer0.texture'), 'textures/sand.png');
    await page.fill(field('water.colour'), '#804020');
    await page.uncheck(field('tank.sea'));
    await pick(page, field('quality.shading'), 'quick');
    await page.click('#restart');
    await settle(page);
    is('a picture, a colour, a switch and a choice are drawn', await sum(page),
       told('storm', '160x120', 0, `layer0.texture=${assets}/textures/sand.png`,
            'water.colour=#804020', 'tank.sea=off', 'quality.shading=quick'));

    const slider = page.locator('.row[data-name="light.elevation"] input[type=range]');
    await slider.scrollIntoViewIfNeeded();
    const box = await slider.boundingBox(), before = await value(page, 'light.elevation');
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.8, box.y + box.height / 2, { steps: 3 });
    await page.mouse.up();
    await settle(page);
    const after = await value(page, 'light.elevation');
    const taken = await page.evaluate(
        () => +tidepool.engine.value(tidepool.engine.row.get('light.elevation')));
    is('a slider that is dragged sets its value',
       `${after !== before} ${+after === taken}`, 'true true');
    await page.click('#reset');
    await settle(page);
    await page.click('#restart');
    await settle(page);
    is('all is reset', await sum(page), told('storm', '160x120', 0));
}

async function searching(page) {
    await page.keyboard.press('Escape');
    await page.locator('#canvas').focus();
    await page.keyboard.press('/');
    await page.keyboard.type('sharp crest');
    const names = await page.$$eval('#groups .row', all =>
        all.filter(r => r.offsetParent).map(r => r.dataset.name));
    is('a search finds what has its words',
       `${names.length > 0} ${names.every(n => /steepness|exponent|wind|surf/.test(n))}`,
       'true true');
    await page.fill('#search', 'xyzzy');
    is('or says that nothing has', await page.isVisible('.none'), true);
    await page.fill('#search', '');
    await page.hover('.row[data-name="camera.fov"]');
    is('what a value does is told', (await page.textContent('#about')).slice(0, 16),
       'camera.fov angle');
}

/* The steps of quality, and a board's picture. */
async function quality(page) {
    const size = '160x120', set = 'quality.board=stm32f405';
    await pick(page, '#size', size);
    await page.click('#ladder summary');
    await page.waitForFunction(() => document.querySelector('#steps li.drawn'));
    is('the steps of quality are listed, the plan is drawn',
       (await page.textContent('#steps li.drawn')).slice(-8), 'the plan');
    is('there are several', await page.locator('#steps li').count() > 4, true);
    await pick(page, '#scene', 'storm');
    await page.evaluate(() => {
        document.getElementById('p-quality.board').closest('details').open = true;
    });
    await pick(page, field('quality.board'), 'stm32f405');
    await page.click('#restart');
    await settle(page);
    is('a board draws what the program draws for it', await sum(page),
       told('storm', size, 0, set, 'quality.mesh=full'));
    await page.waitForFunction(() => document.getElementById('board').textContent);
    is('and what it does is told',
       (await page.textContent('#board')).slice(0, 11), 'stm32f405: ');
    await page.click('#reset');
    await settle(page);
    await page.click('#ladder summary');
}

async function userInput(page) {
    const box = await page.locator('#canvas').boundingBox();
    const at = (x, y) => [box.x + box.width * x, box.y + box.height * y];
    await pick(page, '#scene', 'tank');
    const still = await camera(page);
    await page.mouse.move(...at(0.5, 0.5));
    await page.mouse.down();
    await page.mouse.move(...at(0.7, 0.4), { steps: 3 });
    await page.mouse.up();
    await settle(page);
    is('a drag turns the camera while the water stands',
       `${await camera(page) !== still} ${await frame(page)}`, 'true 0');
    await page.click('#restart');
    await settle(page);
    const press = async (what, ...rest) => {
        await page.click('#restart');
        await settle(page);
        await what(...rest);
        await page.click('#step');
        await page.click('#step');
        await settle(page);
        return sum(page);
    };
    const alone = await press(async () => {});
    is('untouched it is the program\'s', alone, told('tank', '160x120', 2));
    const poked = await press(() => page.mouse.click(...at(0.5, 0.55)));
    is('a click pokes the water', poked !== alone, true);
    is('and so does the right button', await press(
        () => page.mouse.click(...at(0.5, 0.55), { button: 'right' })), poked);
    const placed = await camera(page);
    const stirred = await press(async () => {
        await page.mouse.move(...at(0.5, 0.55));
        await page.mouse.down({ button: 'right' });
        await page.mouse.move(...at(0.6, 0.5), { steps: 2 });
        await page.mouse.up({ button: 'right' });
    });
    is('which stirs it where it is drawn, and turns nothing',
       `${stirred !== poked && stirred !== alone} ${await camera(page) === placed}`,
       'true true');
    is('and a key', await press(() => page.keyboard.press('5')) !== alone, true);
    is('a click beside the water does nothing',
       await press(() => page.mouse.click(...at(0.02, 0.03))), alone);
    is('W moves the camera', await held(page, 'w'), true);
    await page.keyboard.press('p');
    await page.waitForFunction(n => tidepool.state.frame > n, await frame(page));
    await page.keyboard.press('p');
    is('P starts and stops it', await page.evaluate(() => tidepool.state.paused), true);
    await page.keyboard.press('?');
    const sheet = await page.textContent('#sheet');
    is('? lists the keys and tells the size',
       /Keys.*Program and scenes: \d+ KB/s.test(sheet), true);
    await page.keyboard.press('Escape');
    await pick(page, '#scene', 'raindrops');
    await page.mouse.click(...at(0.5, 0.8));
    await page.click('#step');
    await settle(page);
    is('a click lets a drop fall',
       await sum(page) !== told('raindrops', '160x120', 1), true);
    await pick(page, '#scene', 'minimal');
    await page.mouse.click(...at(0.5, 0.8));
    is('water that takes no drop says so', (await alertOf(page)).slice(0, 12),
       'This scene h');
    await page.click('#offer');
    await settle(page);
    await page.click('#step');
    await settle(page);
    const falling = told('minimal', '160x120', 1, 'drops.count=32', 'drops.interval=0',
                         'drops.radius=0.3', 'drops.y=4');
    const dry = told('minimal', '160x120', 1), crc = await sum(page);
    is('or lets drops fall there all the same',
       `${await value(page, 'drops.count')} ${await alertOf(page)} `
       + `${crc !== dry && crc !== falling}`, '32  true');
    await pick(page, '#scene', 'minimal');
    await pick(page, '#look', '3');
    is('and that there is no boat', await alertOf(page), 'This scene has no boat.');
}

const settingsOf = link => link.replace(/^.*#/, '').split('&')
    .filter(part => part.includes('.')).map(decodeURIComponent);

async function sharing(context, page) {
    await pick(page, '#scene', 'storm');
    await type(page, 'wave0.amplitude', '0.8');
    await page.fill(field('water.colour'), '#336644');
    await settle(page);
    await held(page, 'd');
    await page.click('#share');
    const link = await page.inputValue('#link');
    await page.keyboard.press('Escape');
    is('a link names what was changed alone',
       link.replace(/^.*#/, '').replace(/=[^&]*/g, ''),
       'scene&water.colour&wave0.amplitude&camera.x&camera.y&camera.z&camera.heading'
       + '&camera.pitch&size');
    const other = await open(context, `${link}&frame=2`);
    await other.check('#crc');
    const places = (await camera(page)).split(' ');
    const there = (await camera(other)).split(' ');
    is('it opens with the values', `${await value(other, 'wave0.amplitude')} `
       + await value(other, 'water.colour'), '0.8 #336644');
    is('with the camera', places.every((n, i) => Math.abs(n - there[i]) <= 2), true);
    is('and with the bits that the program draws of them', await sum(other),
       told('storm', '160x120', 2, ...settingsOf(link)));
    await pick(page, '#look', '3');
    await page.click('#share');
    const deck = await page.inputValue('#link');
    await page.keyboard.press('Escape');
    await other.goto(`${deck}&frame=1`);
    await idle(other);
    is('a link from the deck opens on it', await sum(other),
       told('storm', '160x120', 1, ...settingsOf(deck)));
    is('which the camera follows', await value(other, 'camera.follow'), 'boat');
    await other.goto(`${index}#scene=nowhere&wave0.height=2`);
    await other.waitForFunction(() => !document.getElementById('alert').hidden);
    is('a link to nothing says so', await alertOf(other), 'no scene is called nowhere');
    await other.goto(`${index}#scene=tank&pool.poke=0.3`);
    await other.waitForFunction(() => !document.getElementById('alert').hidden);
    is('a link with an old name sets the parameter',
       `${await value(other, 'pool.splash_height')} ${await alertOf(other)}`,
       '0.3 pool.poke is now called pool.splash_height');
    await other.close();
}

/* -- a phone --------------------------------------------------------------------- */

async function fingers(cdp, kind, ...points) {
    await cdp.send('Input.dispatchTouchEvent', {
        type: kind, touchPoints: points.map(([x, y], id) => ({ x, y, id })),
    });
}

async function phone(browser) {
    const context = await browser.newContext({
        viewport: { width: 360, height: 640 }, isMobile: true, hasTouch: true,
        deviceScaleFactor: 2, colorScheme: 'dark',
    });
    const page = await open(context, `${index}#scene=tank&frame=0`);
    const cdp = await context.newCDPSession(page);
    const fits = () => page.evaluate(
        () => `${innerWidth} ${document.documentElement.scrollWidth}`);
    is('it fits a phone', await fits(), '360 360');
    is('whose drawer is shut', await page.isVisible('#panel'), false);
    await page.check('#crc');
    await page.tap('#toggle');
    is('it tells what fingers do', (await alertOf(page)).slice(0, 10), 'Drag turns');
    is('and opens by a tap, within the screen',
       `${await page.isVisible('#search')} ${await fits()}`, 'true 360 360');
    await page.tap('#toggle');
    const size = await page.evaluate(
        () => `${tidepool.state.width}x${tidepool.state.height}`);
    await settle(page);
    is('it draws the program\'s bits', await sum(page), told('tank', size, 0));

    const box = await page.locator('#canvas').boundingBox();
    const middle = [box.x + box.width / 2, box.y + box.height * 0.52];
    const beside = (x, y) => [middle[0] + x, middle[1] + y];
    await page.touchscreen.tap(...middle);
    await page.tap('#step');
    await settle(page);
    is('a tap pokes the water', await sum(page) !== told('tank', size, 1), true);
    let still = await camera(page);
    await fingers(cdp, 'touchStart', middle);
    await fingers(cdp, 'touchMove', beside(30, 10));
    await fingers(cdp, 'touchEnd');
    await settle(page);
    const turned = (await camera(page)).split(' ');
    is('a finger turns the camera and leaves it where it is',
       `${turned.slice(0, 3).join(' ') === still.split(' ').slice(0, 3).join(' ')} `
       + `${turned[3] !== still.split(' ')[3]}`, 'true true');
    await fingers(cdp, 'touchStart', beside(-20, 0), beside(20, 0));
    await fingers(cdp, 'touchMove', beside(-60, 0), beside(60, 0));
    await fingers(cdp, 'touchEnd');
    await settle(page);
    still = (await camera(page)).split(' ');
    is('two fingers move it and do not turn it',
       `${turned[0] !== still[0]} ${turned[3] === still[3]}`, 'true true');
    await context.close();
}

/* -- run of all cases ------------------------------------------------------------ */

async function named(page) {
    const without = await page.$$eval(
        'button:not([hidden]), input, select', all => all.filter(node =>
        !(node.ariaLabel || node.title || node.textContent.trim() || node.labels?.length))
        .map(node => node.outerHTML.slice(0, 60)));
    is('every control has a name', without.join(' '), '');
}

async function slow(browser) {
    const context = await browser.newContext({ reducedMotion: 'reduce' });
    const page = await open(context, url);
    const paused = await page.evaluate(() => tidepool.state.paused);
    is('served, and asked for less motion, it stands still',
       `${paused} ${(await alertOf(page)).slice(0, 15)}`, 'true Paused, because');
    await context.close();
}

const browser = await chromium.launch({
    executablePath: '/usr/bin/chromium', headless: true,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
           '--disable-background-networking', '--disable-component-update',
           '--disable-sync'],
});
try {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 },
                                               offline: true });
    const page = await open(context, index);
    await moves(page);
    await exact(page);
    await named(page);
    await scenes(page);
    await values(page);
    await searching(page);
    await quality(page);
    await userInput(page);
    await sharing(context, page);
    await context.close();
    await phone(browser);
    const elsewhere = asked.filter(address => !address.startsWith(`file://${folder}/`)
                                   && !address.startsWith('data:'));
    is('nothing but the folder was asked for', elsewhere.join(' '), '');
    await slow(browser);
    is('nothing complained', complaints.join('; '), '');
} finally {
    await browser.close();
}
process.exit(failures ? 1 : 0);
