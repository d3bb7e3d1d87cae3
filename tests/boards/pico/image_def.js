// SPDX-License-Identifier: MIT
// What the boot ROM of an RP2350 needs of a flash image: a block in the first 4 KB that
// declares a secure Arm program, and vectors at the start of the image:
//
//   node tests/boards/pico/image_def.js IMAGE
//
// Prints the place of the block, stack and entry; or what is wrong, and ends with 1.
'use strict';
const fs = require('fs');

const FIRST = 0xffffded3, LAST = 0xab123579, SCANNED = 4096;
const IMAGE_TYPE = 0x42, LAST_ITEM = 0xff, SECURE_ARM_PROGRAM = 0x1021;
const FLASH = 0x10000000, BANK5 = 0x20081000;
const image = fs.readFileSync(process.argv[2]);
const word = at => at + 4 <= image.length ? image.readUInt32LE(at) : 0;

// The words of the items between the block's first word and its last item.
function itemsOf(block) {
    const items = [];
    let at = block + 4;
    while ((word(at) & 0xff) !== LAST_ITEM) {
        const words = word(at) >>> 8 & 0xff;
        if (!words || at > block + 640)
            return null;
        items.push(word(at));
        at += 4 * words;
    }
    const isWhole = (word(at) >>> 8 & 0xffff) === (at - block - 4) / 4
                 && word(at + 4) === 0 && word(at + 8) === LAST;
    return isWhole ? items : null;
}

function fault() {
    let block = 0;
    while (block < SCANNED && word(block) !== FIRST)
        block += 4;
    if (block >= SCANNED)
        return 'no block in the first 4 KB';
    const items = itemsOf(block), stack = word(0), entry = word(4);
    if (!items)
        return `the block at ${block} is not whole`;
    if (!items.some(item => (item & 0xff) === IMAGE_TYPE
                         && item >>> 16 === SECURE_ARM_PROGRAM))
        return 'the block declares no secure Arm program';
    if (stack & 7 || stack <= BANK5 || stack > BANK5 + 4096)
        return `the stack is ${stack.toString(16)}`;
    if (!(entry & 1) || entry < FLASH || entry >= FLASH + image.length)
        return `the entry is ${entry.toString(16)}`;
    console.log(`block at ${block}, stack ${stack.toString(16)},`,
                `entry ${entry.toString(16)}`);
    return null;
}

const why = fault();
if (why) {
    console.log(why);
    process.exit(1);
}
