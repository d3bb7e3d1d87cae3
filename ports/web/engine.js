/* SPDX-License-Identifier: MIT */
/* The WebAssembly module and its files, as base64 tables written by `make web`
 * (TIDEPOOL.module and TIDEPOOL.files): the page works from a folder as well as from a
 * server.  This file does not use the page; tests run it without one.
 *
 *     const engine = await openEngine();
 *     engine.choose(3);  await engine.load();  engine.build(640, 480, 0, false);
 *     engine.step();  engine.draw();  engine.crc(); */
'use strict';
(function (root) {
    const PICTURE = 1, GREY = 2, TEXT = 3;
    const KINDS = ['fx', 'int', 'bool', 'colour', 'choice', 'mesh', 'texture', 'grey',
                   'text'];
    const SETTING = ['done', 'anew', 'load', 'refused'];

    function bytesOf(base64) {
        const text = atob(base64), bytes = new Uint8Array(text.length);
        for (let i = 0; i < text.length; i++)
            bytes[i] = text.charCodeAt(i);
        return bytes;
    }

    class Engine {
        constructor(exports, files) {
            this.c = exports;
            this.files = files;
            this.width = this.height = 0;
            this.table = this.readTable();
            this.row = new Map(this.table.map(p => [p.name, p]));
            this.scenes = this.readScenes();
        }

        /* -- text ---------------------------------------------------------------- */

        string(at) {
            const bytes = new Uint8Array(this.c.memory.buffer);
            return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
        }

        words() { return this.string(this.c.words()); }

        say(text) {
            const bytes = new TextEncoder().encode(text);
            new Uint8Array(this.c.memory.buffer).set(bytes.subarray(0, 4096),
                                                     this.c.words());
            return Math.min(bytes.length, 4096);
        }

        /* -- tables -------------------------------------------------------------- */

        readTable() {
            const rows = [], count = this.c.param_count();
            const words = new Int32Array(this.c.memory.buffer, this.c.params(),
                                         9 * count);
            for (let i = 0; i < count; i++) {
                const [name, unit, help, kind, low, high, normal] =
                    words.subarray(9 * i, 9 * i + 7);
                rows.push({ index: i, name: this.string(name), unit: this.string(unit),
                            help: this.string(help), kind: KINDS[kind],
                            low, high, normal });
            }
            return rows;
        }

        readScenes() {
            const list = [];
            for (let at; (at = this.c.file(list.length));) {
                const text = this.string(at);
                const word = name => (text.match('\n' + name + '=(.*)') || [])[1] || '';
                list.push({ name: text.split('\n', 1)[0], title: word('title'),
                            description: word('description') });
            }
            return list;
        }

        /* -- values -------------------------------------------------------------- */

        /* Returns the row with this name, or once called so; undefined: none. */
        find(name) {
            return this.row.get(name) || this.table[this.c.find(this.say(name))];
        }

        value(p) { return this.string(this.c.value(p.index, false)); }
        filed(p) { return this.string(this.c.value(p.index, true)); }
        number(p, n) { return this.string(this.c.number(p.index, n)); }

        /* Sets a value.  Returns "done", "anew" or "load"; throws an Error with the
         * reason if refused. */
        put(p, text) {
            const result = SETTING[this.c.put(p.index, this.say(text))];
            if (result === 'refused')
                throw new Error(`${p.name} = ${text}: ${this.why(p)}`);
            return result;
        }

        why(p) {
            const words = this.words();
            if (p.kind !== 'fx' && p.kind !== 'int' || !words.includes('range'))
                return words;
            return `outside ${this.number(p, p.low)} … ${this.number(p, p.high)} `
                + p.unit;
        }

        choose(i) {
            if (this.c.choose(i))
                throw new Error(this.words());
        }

        /* -- files --------------------------------------------------------------- */

        async load() {
            try {
                for (let kind; (kind = this.c.wanted());)
                    await this.bring(kind, this.words());
            } catch (error) {
                this.c.forget();
                throw error;
            }
        }

        async bring(kind, name) {
            const packed = this.files[name];
            if (!packed)
                throw new Error(`${name}: the page has no such file`);
            const bytes = bytesOf(packed);
            if (kind === TEXT)
                this.feed(name, await png.unpack([bytes], 'gzip'));
            else
                await this.show(name, kind, bytes);
            if (this.c.given())
                throw new Error(`${name}: ${this.words()}`);
        }

        feed(name, text) {
            for (let at = 0; at < text.length; at += 65536) {
                const piece = text.subarray(at, at + 65536);
                new Uint8Array(this.c.memory.buffer).set(piece, this.c.words());
                if (this.c.feed(piece.length))
                    throw new Error(`${name}: ${this.words()}`);
            }
        }

        async show(name, kind, bytes) {
            const p = kind === GREY ? await png.greys(bytes) : await png.colours(bytes);
            const at = this.c.room(p.width, p.height);
            if (!at)
                throw new Error(`${name}: ${p.width} x ${p.height} pixels are too many`);
            new p.pixels.constructor(this.c.memory.buffer, at, p.pixels.length)
                .set(p.pixels);
        }

        /* -- pictures ------------------------------------------------------------ */

        build(width, height, format, carry) {
            if (this.c.build(width, height, format, carry))
                throw new Error(this.words());
            this.width = width;
            this.height = height;
        }

        /* Makes another picture of the same world. */
        resize(width, height, format) {
            if (this.c.resize(width, height, format))
                throw new Error(this.words());
            this.width = width;
            this.height = height;
        }

        step() { return this.c.step() >>> 0; }

        draw() {
            const at = this.c.draw();
            return new Uint8ClampedArray(this.c.memory.buffer, at,
                                         4 * this.width * this.height);
        }

        /* Returns the steps of quality as text, the plan first, the number of the drawn one,
         * and what the scene's board does; '' for no board. */
        ladder() {
            const count = this.c.ladder_steps(), steps = [];
            for (let i = 0; i < count; i++)
                steps.push(this.string(this.c.ladder_text(i)));
            return { steps, at: this.c.ladder_at(),
                     board: this.string(this.c.board_text()) };
        }

        crc() { return (this.c.crc() >>> 0).toString(16).padStart(8, '0'); }

        /* Returns the input of the next step, the fields of tp_input without its pokes. */
        nextInput() { return new Int32Array(this.c.memory.buffer, this.c.input(), 13); }

        camera() { return new Int32Array(this.c.memory.buffer, this.c.camera(), 5); }

        facts() { return new Uint32Array(this.c.memory.buffer, this.c.facts(), 4); }
    }

    root.openEngine = async function () {
        const module = await png.unpack([bytesOf(TIDEPOOL.module)], 'gzip');
        const { instance } = await WebAssembly.instantiate(module, {});
        return new Engine(instance.exports, TIDEPOOL.files);
    };
})(globalThis);
