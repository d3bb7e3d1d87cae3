// SPDX-License-Identifier: MIT
// An RP2040 of rp2040js with what that package leaves out: a second core, the FIFOs between
// the cores, a divider for each core, the boot ROM's part in starting a program and a core,
// and the time that a byte takes on the SPI.
//
// Cycles are those of rp2040js: a Cortex-M0+ whose memory has no wait states, neither for
// a miss of the flash's cache nor for two cores at one bank of the RAM.
'use strict';

const RAM = 0x20000000, STAGE2 = 0x20041f00;
const RAM_BYTES = 264 * 1024, SLICE = 64;       // cycles that a core runs at a time
const SIO_CPUID = 0x00, FIFO_ST = 0x50, FIFO_WR = 0x54, FIFO_RD = 0x58;
const DIV_UNSIGNED = 0x60, DIV_SIGNED = 0x68, DIV_QUOTIENT = 0x70, DIV_REMAINDER = 0x74;
const DIV_CYCLES = 8;
const FIFO_WORDS = 8, CAME = 1, ROOM = 2;
const PSM_FRCE_OFF = 4, PROC1 = 1 << 16;
const START = 3;                                // words of the start: 0 0 1 table sp entry

// The boot ROM's CRC-32: neither reflected nor inverted.
function crcOfStage2(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte << 24;
        for (let bit = 0; bit < 8; bit++)
            crc = crc & 0x80000000 ? crc << 1 ^ 0x04c11db7 : crc << 1;
    }
    return crc >>> 0;
}

const MARKS = 1 << 21;
const markIndex = address => address >>> 29 << 20 | address >>> 1 & 0xfffff;

class Chip {
    // `marks`: a byte for each halfword of flash and RAM, at markIndex(address).  Where a
    // core meets a byte n that is not 0, its cycles and instructions count as kind n - 1 of
    // `kinds` from there on: core.spent, core.done; core.flashed: of these in flash.
    constructor(package_, marks, kinds) {
        const { RP2040, ConsoleLogger, LogLevel } = package_;
        this.rp2040 = new RP2040();
        this.rp2040.logger = new ConsoleLogger(LogLevel.Error, false);
        this.cores = [this.rp2040.core, new this.rp2040.core.constructor(this.rp2040)];
        this.marks = marks;
        for (const core of this.cores)
            Object.assign(core, { kind: 0, fifo: [], divider: {}, on: false,
                                  spent: new Float64Array(kinds),
                                  done: new Float64Array(kinds),
                                  flashed: new Float64Array(kinds) });
        this.starting = 0;              // words of the start that core 1 has accepted
        this.ram32 = new Uint32Array(this.rp2040.sram.buffer);
        this.joinMemory();
        this.joinSio();
        this.joinPower();
        const spi = this.rp2040.spi[0];
        const sent = this.rp2040.clock.createAlarm(() => spi.completeTransmit(0));
        spi.onTransmit = byte => {
            this.onByte(byte);
            sent.schedule(8e9 / spi.clockFrequency);
        };
        this.onByte = () => {};
    }

    get core() { return this.rp2040.core; }

    // Aligned words of RAM without the way through the whole memory map.
    joinMemory() {
        const { rp2040, ram32 } = this;
        for (const core of this.cores) {
            core.readUint32 = at => {
                const i = at - RAM;
                return i >= 0 && i < RAM_BYTES && !(at & 3) ? ram32[i >>> 2]
                                                            : rp2040.readUint32(at);
            };
            core.writeUint32 = (at, word) => {
                const i = at - RAM;
                if (i >= 0 && i < RAM_BYTES && !(at & 3))
                    ram32[i >>> 2] = word;
                else
                    rp2040.writeUint32(at, word);
            };
        }
        rp2040.setInterrupt = (irq, value) => this.cores[0].setInterrupt(irq, value);
    }

    joinSio() {
        const sio = this.rp2040.sio, read = sio.readUint32.bind(sio);
        const write = sio.writeUint32.bind(sio);
        sio.readUint32 = offset => {
            switch (offset) {
            case SIO_CPUID: return this.cores.indexOf(this.core);
            case FIFO_ST:   return (this.core.fifo.length ? CAME : 0)
                                 | (this.other.fifo.length < FIFO_WORDS ? ROOM : 0);
            case FIFO_RD:   return this.core.fifo.shift();
            case DIV_QUOTIENT: case DIV_REMAINDER:
                return this.divided(offset === DIV_QUOTIENT);
            default:        return read(offset);
            }
        };
        sio.writeUint32 = (offset, word) => {
            if (offset === FIFO_ST)
                return;
            if (offset >= DIV_UNSIGNED && offset < DIV_QUOTIENT)
                return this.divide(offset, word);
            if (offset !== FIFO_WR)
                return write(offset, word);
            if (this.other === this.cores[1] && !this.other.on)
                this.startCore1(word >>> 0);
            else
                this.post(this.other, word);
        };
    }

    // Registers of this core's divider: unsigned and signed dividend and divisor.
    divide(offset, word) {
        const d = this.core.divider, isDivisor = !!(offset & 4);
        d[isDivisor ? 'divisor' : 'dividend'] = offset >= DIV_SIGNED ? word | 0 : word >>> 0;
        d.ready = this.core.cycles + DIV_CYCLES;
    }

    divided(isQuotient) {
        const { dividend, divisor, ready } = this.core.divider;
        if (this.core.cycles < ready || !divisor)
            throw new Error('a division by 0, or a result that is read too early');
        return isQuotient ? Math.trunc(dividend / divisor) : dividend % divisor;
    }

    get other() { return this.cores[this.core === this.cores[0] ? 1 : 0]; }

    // The event that wakes the reader belongs to SEV, which rp2040js does not execute.
    post(core, word) {
        core.fifo.push(word);
        core.eventRegistered = true;
        core.waiting = false;
    }

    joinPower() {
        const psm = this.rp2040.peripherals[0x40010], write = psm.writeUint32.bind(psm);
        psm.writeUint32 = (offset, bits) => {
            const wasOff = psm.frceOff & PROC1;
            write(offset, bits);
            if (psm.frceOff & PROC1)
                this.cores[1].on = false;
            else if (wasOff) {
                this.starting = 0;
                this.post(this.cores[0], 0);            // the boot ROM is ready
            }
        };
    }

    // Core 1 in the boot ROM: answers each word; a wrong one begins the sequence anew.
    startCore1(word) {
        const core = this.cores[1], at = this.starting;
        const fits = at === 2 ? word === 1 : at >= START || word === 0;
        this.words = at ? [...this.words, word] : [word];
        this.starting = fits ? at + 1 : 0;
        this.post(this.cores[0], fits ? word : 0);
        if (this.starting < 6)
            return;
        [, , , core.VTOR, core.SP, core.PC] = this.words;
        core.PC &= ~1;
        core.on = true;
        core.fifo.length = 0;
        core.waiting = core.eventRegistered = false;
        core.cycles = this.cores[0].cycles;
    }

    // The boot ROM: false if it refuses stage 2.
    boot(image) {
        const { rp2040 } = this, core = this.cores[0];
        rp2040.flash.set(image);
        const view = new DataView(image.buffer, image.byteOffset);
        this.crc = crcOfStage2(image.subarray(0, 252));
        if (this.crc !== view.getUint32(252, true))
            return false;
        rp2040.sram.set(image.subarray(0, 256), STAGE2 - RAM);
        core.SP = STAGE2;
        core.PC = STAGE2;
        core.cycles = 0;
        core.on = true;
        return true;
    }

    // Runs a core up to `until` cycles, or until it sleeps.
    runCore(core, until) {
        const { marks } = this, { spent, done, flashed } = core;
        this.rp2040.core = core;
        while (core.cycles < until && !core.waiting) {
            const at = core.PC, mark = marks[markIndex(at)];
            if (mark)
                core.kind = mark - 1;
            if (at < RAM)
                flashed[core.kind]++;
            const from = core.cycles;
            core.executeInstruction();
            spent[core.kind] += core.cycles - from;
            done[core.kind]++;
        }
        if (core.cycles < until)
            core.cycles = until;
    }

    run() {
        const { rp2040, cores } = this, start = cores[0].cycles;
        for (const core of cores)
            if (core.on)
                this.runCore(core, start + SLICE);
        rp2040.core = cores[0];
        rp2040.clock.tick((cores[0].cycles - start) * 1e9 / rp2040.clkSys);
    }
}

module.exports = { Chip, MARKS, RAM, markIndex };
