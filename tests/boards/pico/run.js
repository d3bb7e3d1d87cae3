// SPDX-License-Identifier: MIT
// Runs a program of ports/pico in rp2040js and reads the pictures from the panel's wires:
//
//   node tests/boards/pico/run.js CLIENT IMAGE [PICTURES] <MARKS
//
// CLIENT holds node_modules; IMAGE is the flash's content; a line of MARKS is an address
// and the name of a function, as nm writes them: count_as_frame, count_as_tiles,
// count_as_tick and count_end separate kinds of work.  Pauses the water at tick 0, makes
// 60 ticks, then another, presses a button and sets the light for a third, asks for the
// state, overwrites the lowest word of core 1's stack, and prints for each picture, or for
// the first PICTURES; 0: only starts
//
//   frame 0060 crc32 9bd67c79
//   cycles frame CORE0 CORE1 tiles CORE0 CORE1 tick CORE0 CORE1
//   instructions ...
//   flash ...                           instructions in flash
//
// then the deepest use of both stacks, and the text of the serial port.
'use strict';
const fs = require('fs'), path = require('path');
const { createRequire } = require('module');
const { Chip, MARKS, markIndex } = require('./chip.js');
const { Panel } = require('./panel.js');

const [client, image, pictures] = process.argv.slice(2);
const package_ = createRequire(path.resolve(client, 'x.js'))('rp2040js');
const KINDS = ['end', 'frame', 'tiles', 'tick'];
const PIN_DC = 1 << 20, STACKS = [0x41000, 0x40000], PAINT = 0xa5a5a5a5;
const LIMIT = 4e9;                      // cycles after which the program has failed
const BUTTONS = [2, 3, 4, 5, 6], DOWN = 3, MS = 1e6;
const said = [];

function readMarks() {
    const marks = new Uint8Array(MARKS);
    for (const line of fs.readFileSync(0, 'utf8').split('\n')) {
        const [address, , name] = line.split(' ');
        const kind = KINDS.indexOf((name || '').replace(/^count_(as_)?/, ''));
        if (kind >= 0)
            marks[markIndex(parseInt(address, 16))] = kind + 1;
    }
    return marks;
}

const chip = new Chip(package_, readMarks(), KINDS.length);
const panel = new Panel(320, 240);
const after = (ms, act) => chip.rp2040.clock.createAlarm(act).schedule(ms * MS);
const press = (pin, isDown) => chip.rp2040.gpio[pin].setInputValue(!isDown);
let frame = 60, text = '', isAsked = false, isEnded = false;

function ask(line) {
    for (const byte of Buffer.from(line))
        chip.rp2040.uart[0].feedByte(byte);
}

function report() {
    console.log(`frame ${String(frame).padStart(4, '0')} crc32 ${panel.crc()}`);
    for (const [word, of] of [['cycles', 'spent'], ['instructions', 'done'],
                              ['flash', 'flashed']])
        console.log(word + KINDS.slice(1).map((kind, i) =>
            ` ${kind} ${chip.cores.map(core => core[of][i + 1]).join(' ')}`).join(''));
    for (const core of chip.cores)
        core.spent.fill(0), core.done.fill(0), core.flashed.fill(0);
    frame++;
}

chip.rp2040.uart[0].onByte = byte => {
    text += String.fromCharCode(byte);
    if (!text.endsWith('\n'))
        return;
    said.push(text);
    isEnded = pictures === '0' && text.startsWith('ok ');
    if (!isAsked && text.startsWith('ram '))
        ask('pause\rstep 60\r');
    isAsked = isAsked || text.startsWith('ram ');
    text = '';
};
chip.onByte = byte => panel.put(!!(chip.rp2040.sio.gpioValue & PIN_DC), byte);
const steps = [
    () => ask('step 1\r'),
    () => {
        press(DOWN, true);
        after(1, () => press(DOWN, false));
        after(2, () => ask('set light.elevation 50\rstep 1\r'));
    },
    () => after(1, () => ask('state\r')),
];
panel.onPicture = () => {
    report();
    if (frame - 60 < (pictures || Infinity))
        steps.shift()();
    else
        isEnded = true;
};
for (const pin of BUTTONS)
    press(pin, false);

if (!chip.boot(fs.readFileSync(image))) {
    console.log(`the boot ROM refuses stage 2: its CRC is ${chip.crc.toString(16)}`);
    process.exit(1);
}
const runUntil = words => {
    while (chip.cores[0].cycles < LIMIT && !isEnded && !words.test(said.at(-1)))
        chip.run();
};
runUntil(/fault|error|crc32/);
for (const [core, low] of STACKS.entries()) {
    const words = chip.ram32.subarray(low >> 2, (low >> 2) + 1024);
    const left = words.findIndex(word => word !== PAINT);
    console.log(`stack ${core} ${left < 0 ? 0 : 4 * (words.length - left)}`);
}
console.log(`panel walk ${panel.walk.toString(16)}`,
            panel.isInverted ? 'inverted' : 'plain', `bytes ${panel.bytes}`);
chip.ram32[STACKS[1] >> 2] = 0;
runUntil(/fault|error/);
console.log(said.join('') + text);
