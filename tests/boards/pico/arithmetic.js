// SPDX-License-Identifier: MIT
// Calls the arithmetic of ports/pico/arithmetic.S in rp2040js with random numbers and with
// numbers at the ends of their range, and compares the results with BigInt's:
//
//   node tests/boards/pico/arithmetic.js CLIENT CODE START <SYMBOLS
//
// CODE is the section .data, START its address, SYMBOLS the output of nm.
'use strict';
const fs = require('fs'), path = require('path');
const { createRequire } = require('module');
const { Chip, MARKS, RAM } = require('./chip.js');

const [client, code, start] = process.argv.slice(2);
const chip = new Chip(createRequire(path.resolve(client, 'x.js'))('rp2040js'),
                      new Uint8Array(MARKS), 1);
const core = chip.cores[0], STACK = RAM + 0x40000, HOME = RAM + 0x3f000, ROUNDS = 20000;
const symbols = fs.readFileSync(0, 'utf8').split('\n').map(line => line.split(' '));
const ENDS = [0, 1, 2, 0xffff, 0x10000, 0x7fffffff, 0x80000000, 0xfffe0001, 0xffffffff];
let seed = 1, wrong = 0;

chip.rp2040.sram.set(fs.readFileSync(code), parseInt(start, 16) - RAM);

function draw() {
    seed = Math.imul(seed, 1664525) + 1013904223 >>> 0;
    return seed >>> 28 < 5 ? ENDS[(seed >>> 8) % ENDS.length] : Math.imul(seed, 40503) >>> 0;
}

function call(name, ...numbers) {
    numbers.forEach((number, i) => core.registers[i] = number);
    [core.SP, core.LR] = [STACK, HOME | 1];
    core.PC = parseInt(symbols.find(symbol => symbol[2] === name)[0], 16);
    while ((core.PC & ~1) !== HOME)
        core.executeInstruction();
    return [core.registers[0], core.registers[1]];
}

const wide = (low, high) => BigInt(high >>> 0) << 32n | BigInt(low >>> 0);
function expect(got, low, high) {
    if (got[0] !== low >>> 0 || got[1] !== high >>> 0)
        wrong++;
}

for (let i = 0; i < ROUNDS; i++) {
    const [a, b, c, d] = [draw(), draw(), draw(), draw() || 1];
    const product = BigInt.asUintN(64, wide(a, b) * wide(c, d));
    expect(call('__aeabi_lmul', a, b, c, d), Number(product & 0xffffffffn),
           Number(product >> 32n));
    expect(call('__aeabi_uidivmod', a, d), Math.trunc(a / d), a % d);
    expect(call('__aeabi_idivmod', a, d), Math.trunc((a | 0) / (d | 0)), (a | 0) % (d | 0));
}
console.log(`${wrong} wrong of ${3 * ROUNDS}`);
process.exit(wrong ? 1 : 0);
