/* SPDX-License-Identifier: MIT */
/* Decodes a PNG to exact pixels.  A canvas cannot be used: it multiplies colours by
 * alpha.
 *
 *     png.colours(bytes)  ->  { width, height, pixels }   0xAARRGGBB in a Uint32Array
 *     png.greys(bytes)    ->  the same, 0..65535 in a Uint16Array, as libpng has them
 *
 * All depths and colour types; no interlaced PNGs, since no asset is interlaced.  Both
 * functions return promises, as the browser's inflate does. */
'use strict';
(function (root) {
    const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];
    const CHANNELS = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

    async function unpack(parts, kind) {
        const stream = new Blob(parts).stream()
            .pipeThrough(new DecompressionStream(kind));
        return new Uint8Array(await new Response(stream).arrayBuffer());
    }

    function read(bytes) {
        const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
        if (SIGNATURE.some((b, i) => bytes[i] !== b))
            throw new Error('not a PNG');
        const file = { data: [], palette: null, clear: null };
        for (let at = 8; at + 12 <= bytes.length;) {
            const size = view.getUint32(at);
            const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
            const body = bytes.subarray(at + 8, at + 8 + size);
            if (name === 'IHDR') {
                file.width = view.getUint32(at + 8);
                file.height = view.getUint32(at + 12);
                [file.depth, file.type] = body.subarray(8, 10);
                if (body[12])
                    throw new Error('an interlaced PNG');
            } else if (name === 'PLTE')
                file.palette = body;
            else if (name === 'tRNS')
                file.clear = body;
            else if (name === 'IDAT')
                file.data.push(body);
            at += size + 12;
        }
        return file;
    }

    /* Undoes the filters: a row is stored as differences from the pixels left, above,
     * above left. */
    function unfilter(raw, rowBytes, height, step) {
        const rows = new Uint8Array(rowBytes * height);
        for (let y = 0; y < height; y++) {
            const kind = raw[y * (rowBytes + 1)], from = y * (rowBytes + 1) + 1;
            const to = y * rowBytes;
            for (let i = 0; i < rowBytes; i++) {
                const a = i < step ? 0 : rows[to + i - step];
                const b = y ? rows[to + i - rowBytes] : 0;
                const c = y && i >= step ? rows[to + i - rowBytes - step] : 0;
                rows[to + i] = raw[from + i] + guess(kind, a, b, c);
            }
        }
        return rows;
    }

    function guess(kind, a, b, c) {
        if (kind === 1) return a;
        if (kind === 2) return b;
        if (kind === 3) return (a + b) >> 1;
        if (kind !== 4) return 0;
        const pa = Math.abs(b - c), pb = Math.abs(a - c), pc = Math.abs(a + b - 2 * c);
        return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    }

    /* Calls take(i, r, g, b, a) for each pixel, with values 0..65535. */
    async function each(bytes, start, take) {
        const f = read(bytes), channels = CHANNELS[f.type], bits = channels * f.depth;
        const rowBytes = (f.width * bits + 7) >> 3;
        const rows = unfilter(await unpack(f.data, 'deflate'), rowBytes, f.height,
                              Math.max(1, bits >> 3));
        const most = (1 << f.depth) - 1;
        const sample = (y, n) => {
            if (f.depth === 16)
                return rows[y * rowBytes + 2 * n] << 8 | rows[y * rowBytes + 2 * n + 1];
            const bit = n * f.depth;
            return rows[y * rowBytes + (bit >> 3)] >> (8 - f.depth - (bit & 7)) & most;
        };
        const wide = v => f.depth === 16 ? v : v * (65535 / most);
        const key = c => f.clear && f.clear.length > 2 * c
            ? f.clear[2 * c] << 8 | f.clear[2 * c + 1] : -1;
        start(f.width, f.height);
        for (let y = 0, i = 0; y < f.height; y++)
            for (let x = 0; x < f.width; x++, i++) {
                const s = k => sample(y, x * channels + k);
                if (f.type === 3) {
                    const n = s(0);
                    const alpha = f.clear && n < f.clear.length ? f.clear[n] : 255;
                    take(i, f.palette[3 * n] * 257, f.palette[3 * n + 1] * 257,
                         f.palette[3 * n + 2] * 257, alpha * 257);
                } else if (f.type === 0 || f.type === 4) {
                    const v = wide(s(0)), clear = f.type === 0 && s(0) === key(0);
                    take(i, v, v, v, f.type === 4 ? wide(s(1)) : clear ? 0 : 65535);
                } else {
                    const seen = f.type === 6 ? wide(s(3))
                               : s(0) === key(0) && s(1) === key(1) && s(2) === key(2) ? 0
                               : 65535;
                    take(i, wide(s(0)), wide(s(1)), wide(s(2)), seen);
                }
            }
    }

    const byte = v => (v * 255 + 32895) >>> 16;     /* 16 bits to 8, rounded as libpng
                                                     * does */

    async function colours(bytes) {
        const p = {};
        await each(bytes, (width, height) => Object.assign(p, {
            width, height, pixels: new Uint32Array(width * height),
        }), (i, r, g, b, a) => {
            p.pixels[i] = byte(a) << 24 | byte(r) << 16 | byte(g) << 8 | byte(b);
        });
        return p;
    }

    async function greys(bytes) {
        const p = {};
        await each(bytes, (width, height) => Object.assign(p, {
            width, height, pixels: new Uint16Array(width * height),
        }), (i, r, g, b) => {
            p.pixels[i] = r === g && g === b ? r
                        : (6968 * r + 23434 * g + 2366 * b + 16384) >>> 15;
        });
        return p;
    }

    root.png = { colours, greys, unpack };
})(globalThis);
