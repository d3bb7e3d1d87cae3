// SPDX-License-Identifier: MIT
// A panel in landscape that takes the commands of MIPI DCS: bytes of the SPI become pixels
// of a picture, with the checksum of `tidepool render --format rgb565be --hash`.
'use strict';

const CASET = 0x2a, PASET = 0x2b, RAMWR = 0x2c, MADCTL = 0x36, DISPON = 0x29, INVON = 0x21;

class Panel {
    constructor(width, height) {
        Object.assign(this, { width, height, walk: 0, isOn: false, isInverted: false,
                              bytes: 0, pixels: 0 });
        this.picture = new Uint16Array(width * height);
        this.command = 0;
        this.arguments = [];
        this.columns = [0, width - 1];
        this.rows = [0, height - 1];
        this.onPicture = () => {};
    }

    put(isData, byte) {
        this.bytes++;
        if (!isData)
            this.begin(byte);
        else if (this.command === RAMWR)
            this.pixel(byte);
        else
            this.argument(byte);
    }

    begin(command) {
        this.command = command;
        this.arguments = [];
        this.high = -1;
        [this.x, this.y] = [this.columns[0], this.rows[0]];
        if (command === DISPON)
            this.isOn = true;
        if (command === INVON)
            this.isInverted = true;
    }

    argument(byte) {
        const a = this.arguments;
        a.push(byte);
        if (this.command === MADCTL)
            this.walk = byte;
        else if (this.command === CASET && a.length === 4)
            this.columns = [a[0] << 8 | a[1], a[2] << 8 | a[3]];
        else if (this.command === PASET && a.length === 4)
            this.rows = [a[0] << 8 | a[1], a[2] << 8 | a[3]];
    }

    pixel(byte) {
        if (this.high < 0) {
            this.high = byte;
            return;
        }
        this.picture[this.y * this.width + this.x] = this.high << 8 | byte;
        this.high = -1;
        if (++this.x > this.columns[1]) {
            this.x = this.columns[0];
            this.y++;
        }
        if (++this.pixels % (this.width * this.height) === 0)
            this.onPicture();
    }

    // Each pixel counts as blue, green, red, 0, with the fields widened to 8 bits.
    crc() {
        let crc = ~0;
        for (const p of this.picture) {
            const r = p >> 11, g = p >> 5 & 63, b = p & 31;
            for (const byte of [b << 3 | b >> 2, g << 2 | g >> 4, r << 3 | r >> 2, 0]) {
                crc ^= byte;
                for (let bit = 0; bit < 8; bit++)
                    crc = crc & 1 ? crc >>> 1 ^ 0xedb88320 : crc >>> 1;
            }
        }
        return (~crc >>> 0).toString(16).padStart(8, '0');
    }
}

module.exports = { Panel };
