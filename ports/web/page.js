/* SPDX-License-Identifier: MIT */
/* The page: time, scenes, changes, actions of its buttons. */
'use strict';
(async function () {
    const $ = id => document.getElementById(id);
    const canvas = $('canvas'), context = canvas.getContext('2d', { alpha: false });
    /* Drops for a scene without drops, large enough for the sea; count comes last. */
    const SEA_DROPS = { interval: '0', radius: '0.3', y: '4', ring_speed: '2.5',
                        ring_decay: '3', ring_spread: '3', efficiency: '0.6', count: '32' };
    const LOOKS = ['free', 'orbit', 'top', 'boat'];
    const FIRST = 'three-swells';
    const TICK = 1000 / 60, AT_ONCE = 8;    /* limit per frame; if more are due, the
                                             * water slows down */

    const state = { scene: -1, width: 640, height: 480, format: 'xrgb8888', look: 0,
                    paused: false, frame: 0, steps: 0, stale: false, moved: false,
                    busy: true,             /* waiting for files */
                    built: false };         /* a world exists */
    const pending = new Map();              /* changes to apply before the next frame */
    let last = 0, owed = 0, times = [], shown = 0, engine, panel, userInput;

    /* -- messages ---------------------------------------------------------------- */

    /* Shows an error, or a note; optionally with a button: its label `offer`, its action
     * `work`. */
    function tell(text, note, offer, work) {
        $('alert').className = note ? 'note' : '';
        $('offer').hidden = !offer;
        $('offer').textContent = offer || '';
        $('offer').onclick = work;
        $('alert').firstElementChild.textContent = text;
        $('alert').hidden = !text;
    }
    $('alert').lastElementChild.onclick = () => tell('');
    const told = error => tell(error.message);

    /* -- pictures ---------------------------------------------------------------- */

    function draw() {
        const begun = performance.now();
        const pixels = engine.draw();
        const took = performance.now() - begun;
        context.putImageData(new ImageData(pixels, state.width, state.height), 0, 0);
        times.push(took);
        if (!state.paused)
            state.steps += engine.c.took(Math.round(1000 * took));
        state.stale = false;
        sum();
    }

    function sum() {
        $('sum').textContent = $('crc').checked
            ? `frame ${String(state.frame).padStart(4, '0')} crc32 ${engine.crc()}` : '';
    }

    /* Lists the steps of quality, the drawn one in bold. */
    function listSteps() {
        if (!$('ladder').open)
            return;
        const ladder = engine.ladder();
        $('board').textContent = ladder.board;
        $('steps').replaceChildren(...ladder.steps.map((text, i) =>
            make('li', { className: i === ladder.at ? 'drawn' : '' }, text)));
    }

    function rate(now) {
        if (now - shown < 500)
            return;
        listSteps();
        const middle = times.sort((a, b) => a - b)[times.length >> 1];
        const speed = Math.round(1000 * times.length / (now - shown));
        const steps = state.steps ? ` · quality ${state.steps} steps down` : '';
        const size = `${state.width} × ${state.height}${steps}`;
        $('rate').textContent = state.paused ? `paused at frame ${state.frame} · ${size}`
            : `${speed} frames/s · ${middle ? middle.toFixed(1) : '–'} ms · ${size}`;
        times = [];
        shown = now;
    }

    /* -- time -------------------------------------------------------------------- */

    function tick() {
        userInput.apply(engine.nextInput());
        state.frame = engine.step();
        state.stale = true;
    }

    function look() {
        userInput.apply(engine.nextInput());
        engine.c.turn();
        state.stale = true;
    }

    async function loop(now) {
        requestAnimationFrame(loop);
        if (state.busy || !state.built)
            return void (last = now);
        try {
            if (pending.size)
                await changes();
            const moves = userInput.movesCamera();
            state.moved = state.moved || moves;
            owed = Math.min(owed + now - last, AT_ONCE * TICK);
            for (; owed >= TICK; owed -= TICK)
                if (!state.paused)
                    tick();
                else if (userInput.movesCamera())
                    look();
            if (state.stale)
                draw();
        } catch (error) {
            tell(error.message);
        }
        last = now;
        rate(now);
    }

    function pause(on) {
        state.paused = on;
        $('pause').textContent = on ? 'Continue' : 'Pause';
        $('pause').setAttribute('aria-pressed', on);
        shown = 0;
    }

    /* -- scenes and changes ------------------------------------------------------ */

    function build(carry) {
        state.built = false;
        engine.build(state.width, state.height, FORMATS.indexOf(state.format), carry);
        state.built = true;
        state.steps = 0;        /* steps of the governor (quality.frame_ms) */
        state.frame = carry ? state.frame : 0;
        resizeCanvas();
    }

    /* Fits the canvas to the picture's size. */
    function resizeCanvas() {
        canvas.width = state.width;
        canvas.height = state.height;
        state.stale = true;
        fit();
    }

    const fit = () => fitCanvas(canvas, +$('zoom').value);

    /* Runs one task at a time; no frame is drawn while it waits for files. */
    async function alone(work) {
        state.busy = true;
        try {
            await work();
        } finally {
            state.busy = false;
        }
    }

    /* Applies a change; restores the old value if the scene cannot be built with the new
     * one. */
    async function change(p, text) {
        const before = engine.value(p);
        try {
            const result = engine.put(p, text);
            state.stale = true;
            if (result === 'done')
                return;
            try {
                await engine.load();
                build(true);
            } catch (error) {
                engine.put(p, before);
                await engine.load();
                build(true);
                throw new Error(`${p.name} = ${text}: ${error.message}`);
            }
        } catch (error) {
            tell(error.message);
            panel.update(p);
            panel.refuse(p);
            throw error;
        }
    }

    async function changes() {
        const all = [...pending];
        pending.clear();
        await alone(async () => {
            for (const [p, text] of all)
                try {
                    await change(p, text);
                    panel.update(p);
                    tell('');
                } catch (error) {
                    continue;       /* shown already */
                }
        });
    }

    /* Opens the scene of an address.  Shows the first error and applies the rest. */
    async function open(wanted) {
        let wrong = '';
        const note = error => { wrong = wrong || error.message; };
        const found = engine.scenes.findIndex(s => s.name === wanted.scene);
        if (wanted.scene && found < 0)
            note(new Error(`no scene is called ${wanted.scene}`));
        pending.clear();
        state.scene = found < 0 ? engine.scenes.findIndex(s => s.name === FIRST) : found;
        if (FORMATS.includes(wanted.format))
            state.format = wanted.format;
        if (wanted.size && wanted.size.every(n => n >= 16 && n <= 4096))
            [state.width, state.height] = wanted.size;
        else if (wanted.size)
            note(new Error('pictures are 16x16 to 4096x4096 pixels'));
        engine.choose(state.scene);
        for (const [name, text] of wanted.settings)
            try {
                const p = engine.find(name);
                if (!p)
                    throw new Error(`no parameter is called ${name}`);
                engine.put(p, text);
                if (p.name !== name)
                    note(new Error(`${name} is now called ${p.name}`));
            } catch (error) {
                note(error);
            }
        try {
            await engine.load();
            build(false);
        } catch (error) {           /* fault of a given value */
            note(error);
            engine.choose(state.scene);
            await engine.load();
            build(false);
        }
        state.moved = false;
        steer(Math.max(0, LOOKS.indexOf(wanted.look)), true);
        if (wanted.frame !== undefined) {
            while (state.frame < wanted.frame)
                state.frame = engine.step();
            pause(true);
        }
        fields();
        panel.show();
        draw();
        tell(wrong);
    }

    function fields() {
        const size = `${state.width}x${state.height}`, scene = engine.scenes[state.scene];
        $('scene').value = scene.name;
        $('format').value = state.format;
        if (![...$('size').options].some(o => o.value === size))
            $('size').append(sizeOption(size));
        $('size').value = size;
        $('scene').title = scene.description;
        document.title = `${scene.title} – Tidepool`;
    }

    const go = wanted => alone(() => open(wanted)).catch(told);

    /* Selects a camera mode, and queues the camera.follow it needs.  A freshly built
     * scene (`fresh`) in the free mode keeps its own camera.follow. */
    function steer(mode, fresh) {
        if (!engine.c.look(mode)) {
            tell(mode === 3 ? 'This scene has no boat.'
                : 'This camera mode has no target in this scene.', true);
            mode = state.look;
        }
        state.look = mode;
        $('look').value = mode;
        const p = engine.row.get('camera.follow');
        const word = p.unit.split('|')[engine.c.follow()];
        if (engine.value(p) !== word && !(fresh && !mode))
            pending.set(p, word);
        state.stale = true;
    }

    /* -- sharing ----------------------------------------------------------------- */

    /* Returns the address of the current state.  A moved camera is given by its pose,
     * since no mode describes it. */
    function address() {
        const moved = state.moved || state.look > 0;
        const settings = panel.changed().map(r => [r.param.name, r.text])
            .filter(([name]) => !moved || !share.AT.includes(name));
        if (moved)
            settings.push(...share.place(engine.camera()));
        const size = `${state.width}x${state.height}`;
        return location.href.replace(/#.*/, '') + share.write({
            scene: engine.scenes[state.scene].name, settings,
            size: size === '640x480' ? '' : size,
            format: state.format === 'xrgb8888' ? '' : state.format,
        });
    }

    const rain = (x, y) => alone(async () => {
        tell('');
        for (const [name, text] of Object.entries(SEA_DROPS)) {
            const p = engine.row.get(`drops.${name}`);
            await change(p, text);
            panel.update(p);
        }
        acts.touch(x, y, false);
    }).catch(told);

    /* -- actions ----------------------------------------------------------------- */

    const acts = {
        pause: () => pause(!state.paused),
        step: () => { pause(true); tick(); },
        restart: () => {
            build(false);
            state.moved = false;
            steer(state.look, true);
        },
        next: by => {
            const n = engine.scenes.length;
            go({ scene: engine.scenes[(state.scene + by + n) % n].name, settings: [] });
        },
        look: mode => steer(mode),
        poke: n => poked(engine.c.poke(n)),
        touch: (x, y, stir) => {
            const found = engine.c.touch(Math.floor(x * state.width),
                                         Math.floor(y * state.height), stir);
            poked(found);
            if (found === 2 && !stir)
                tell('This scene has no drops.', true, 'Add drops',
                     () => rain(x, y));
        },
        panel: () => toggle(document.body.classList.contains('closed')),
        search: () => { toggle(true); $('search').focus(); },
        crc: () => { $('crc').checked = !$('crc').checked; sum(); },
        share: () => shareSheet(address()),
        help: helpSheet,
    };

    /* Handles the result of touch or poke; 3 is FULL in web.c. */
    function poked(found) {
        if (found === 3)
            tell('Too many pokes wait: P continues the water.', true);
    }

    function act(name, ...rest) {
        if (!state.busy && state.built)
            try {
                acts[name](...rest);
            } catch (error) {
                told(error);
            }
    }

    function toggle(open) {
        document.body.classList.toggle('closed', !open);
        $('toggle').setAttribute('aria-expanded', open);
        fit();
    }

    for (const name of ['pause', 'step', 'restart', 'share', 'help'])
        $(name).onclick = () => act(name);
    $('toggle').onclick = () => act('panel');
    $('crc').onchange = sum;
    $('look').onchange = () => act('look', +$('look').value);
    $('zoom').onchange = fit;
    $('scene').onchange = () => go({ scene: $('scene').value, settings: [] });
    function resize() {
        const [width, height] = $('size').value.split('x').map(Number);
        try {
            engine.resize(width, height, FORMATS.indexOf($('format').value));
            Object.assign(state, { width, height, format: $('format').value });
            resizeCanvas();
        } catch (error) {
            tell(error.message);
            fields();
        }
    }
    $('size').onchange = $('format').onchange = resize;
    $('reset').onclick = () => {
        for (const row of panel.changed())
            pending.set(row.param, row.filed);
    };
    addEventListener('resize', fit);

    /* After a choice by mouse the canvas gets the focus; after a choice by keys the list
     * keeps it. */
    let pointed = false;
    addEventListener('pointerdown', () => { pointed = true; }, true);
    addEventListener('keydown', () => { pointed = false; }, true);
    for (const name of ['scene', 'look', 'size', 'format', 'zoom'])
        $(name).addEventListener('change', () => pointed && canvas.focus());

    /* A note disappears after a touch of the canvas. */
    canvas.addEventListener('pointerdown', () => {
        if ($('alert').className === 'note')
            tell('');
    });
    addEventListener('hashchange', () => go(share.read(location.hash)));

    /* -- begin ------------------------------------------------------------------- */

    $('format').append(...SHOWN.map(([value, text]) => make('option', { value }, text)));
    $('size').append(...SIZES.map(sizeOption));
    try {
        if (!globalThis.WebAssembly || !globalThis.DecompressionStream)
            throw new Error('the browser lacks WebAssembly or DecompressionStream');
        engine = await openEngine();
    } catch (error) {
        $('rate').textContent = '';
        return tell(`Tidepool cannot run here: ${error.message}`);
    }
    $('scene').append(...engine.scenes.map(
        s => make('option', { value: s.name, title: s.description }, s.title)));
    panel = makePanel(engine, Object.keys(TIDEPOOL.files),
                      (p, text) => pending.set(p, text));
    userInput = makeUserInput(canvas, act);
    if (matchMedia('(max-width: 760px)').matches) {
        toggle(false);
        [state.width, state.height] = uprightSize(canvas.parentElement);
    }
    await go(share.read(location.hash));
    if (matchMedia('(pointer: coarse)').matches && $('alert').hidden)
        tell('Drag turns, a tap pokes or drops, two fingers move.', true);
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
        pause(true);
        tell('Paused, because your system asks for reduced motion: P continues.', true);
    }
    requestAnimationFrame(loop);
    globalThis.tidepool = { engine, state };
})();
