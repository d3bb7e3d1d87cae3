/* SPDX-License-Identifier: MIT */
/* Converts keys, mouse and touch to the input of the next tick.
 *
 *     const userInput = makeUserInput(canvas, act)
 *     userInput.apply(input)      adds held keys and drags to the input, once a tick
 *     userInput.movesCamera()     true if the input moves the camera
 *
 * Calls act(name, ...) for single actions: "pause", or "touch" with a position, x and y
 * 0..1. */
'use strict';
(function (root) {
    /* Field indices of tp_input. */
    const AHEAD = 0, ASIDE = 1, UP = 2, TURN = 3, TILT = 4, SPHERE_X = 5, SPHERE_Z = 6,
          DROPS = 7, THROTTLE = 8, RUDDER = 9, SLOWER = 10, LIGHT_TURN = 11,
          LIGHT_TILT = 12;

    /* Per tick, as in ports/interact/input_merge.h: 1/60 of m/s (Q16.16) and degrees/s
     * (2^32 = a turn). */
    const metres = m => Math.round(m * 65536);
    const degrees = d => Math.round(d / 360 * 4294967296);
    const WALK = metres(4 / 60), RUN = metres(16 / 60), STEER = metres(1.5 / 60);
    const LIGHT = degrees(45 / 60), DRAG = degrees(0.2);
    const SAIL = metres(4), RUDDERS = metres(20);

    /* By key code (place on the keyboard).  HELD keys act while down, ONCE keys when
     * pressed. */
    const HELD = {
        KeyW: [AHEAD, 1], KeyS: [AHEAD, -1], KeyD: [ASIDE, 1], KeyA: [ASIDE, -1],
        KeyE: [UP, 1], KeyQ: [UP, -1],
        ArrowRight: [SPHERE_X, STEER], ArrowLeft: [SPHERE_X, -STEER],
        ArrowDown: [SPHERE_Z, STEER], ArrowUp: [SPHERE_Z, -STEER],
        KeyI: [THROTTLE, SAIL], KeyK: [THROTTLE, -SAIL],
        KeyL: [RUDDER, RUDDERS], KeyJ: [RUDDER, -RUDDERS],
        End: [LIGHT_TURN, LIGHT], Home: [LIGHT_TURN, -LIGHT],
        PageUp: [LIGHT_TILT, LIGHT], PageDown: [LIGHT_TILT, -LIGHT],
    };
    const ONCE = {
        KeyP: ['pause'], Period: ['step'], KeyR: ['restart'], KeyN: ['next'],
        KeyF: ['look', 0], KeyO: ['look', 1], KeyT: ['look', 2], KeyB: ['look', 3],
        Space: ['add', DROPS],
        BracketLeft: ['add', SLOWER, 1], BracketRight: ['add', SLOWER, -1],
        Digit1: ['poke', 0], Digit2: ['poke', 1], Digit3: ['poke', 2],
        Digit4: ['poke', 3], Digit5: ['poke', 4], Digit6: ['poke', 5],
        F2: ['panel'], F3: ['search'], Slash: ['search'], F1: ['help'], KeyC: ['crc'],
    };
    const TAP = 6;              /* px; a finger moving farther drags */

    root.makeUserInput = function (canvas, act) {
        const down = new Set(), fingers = new Map();
        let more = new Array(LIGHT_TILT + 1).fill(0), slipped = 0, apart = 0, stirring = false;

        /* -- keys ---------------------------------------------------------------- */

        /* True if the focused control uses the key itself. */
        function taken(event) {
            const node = event.target, kind = node.tagName;
            if (event.ctrlKey || event.metaKey || event.altKey || node.closest('dialog'))
                return true;
            if (kind === 'BUTTON' || kind === 'SUMMARY' || node.type === 'checkbox')
                return event.code === 'Space';
            if (node.type === 'range')
                return /^(Arrow|Home|End|Page)/.test(event.code);
            return /^(INPUT|SELECT)$/.test(kind);
        }

        document.addEventListener('keydown', event => {
            if (event.key === 'Escape' && event.target.closest('#panel'))
                canvas.focus();
            if (taken(event))
                return;
            if (event.key === '?')
                act('help');
            else if (HELD[event.code])
                down.add(event.code);
            else if (ONCE[event.code] && !event.repeat)
                once(event, ...ONCE[event.code]);
            else if (!ONCE[event.code])
                return;
            event.preventDefault();
        });
        document.addEventListener('keyup', event => down.delete(event.code));
        window.addEventListener('blur', () => down.clear());

        function once(event, name, ...rest) {
            if (name === 'add')
                more[rest[0]] += rest[1] || 1;
            else
                act(name, ...(name === 'next' ? [event.shiftKey ? -1 : 1] : rest));
        }

        /* -- mouse and fingers --------------------------------------------------- */

        function place(event) {
            const box = canvas.getBoundingClientRect();
            return [(event.clientX - box.left) / box.width,
                    (event.clientY - box.top) / box.height];
        }

        /* Returns the middle of two fingers and their distance. */
        function pair() {
            const [a, b] = [...fingers.values()];
            return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2,
                     far: Math.hypot(a.x - b.x, a.y - b.y) };
        }

        canvas.addEventListener('pointerdown', event => {
            canvas.setPointerCapture(event.pointerId);
            fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
            slipped = fingers.size > 1 ? Infinity : 0;
            apart = fingers.size === 2 ? pair() : null;
            stirring = event.button === 2;
            if (stirring)
                act('touch', ...place(event), false);
        });

        canvas.addEventListener('pointermove', event => {
            const at = fingers.get(event.pointerId);
            if (!at)
                return;
            const dx = event.clientX - at.x, dy = event.clientY - at.y;
            slipped += Math.hypot(dx, dy);
            Object.assign(at, { x: event.clientX, y: event.clientY });
            if (fingers.size === 2) {
                const now = pair();
                more[AHEAD] += metres((now.far - apart.far) * 0.03);
                more[ASIDE] -= metres((now.x - apart.x) * 0.02);
                more[UP] += metres((now.y - apart.y) * 0.02);
                apart = now;
            } else if (stirring) {
                act('touch', ...place(event), true);
            } else if (slipped > TAP) {
                more[TURN] += DRAG * dx;
                more[TILT] -= DRAG * dy;
            }
        });

        function lift(event) {
            if (fingers.delete(event.pointerId) && event.type === 'pointerup' && !stirring
                && slipped <= TAP)
                act('touch', ...place(event), false);
            stirring = stirring && fingers.size > 0;
        }
        canvas.addEventListener('pointerup', lift);
        canvas.addEventListener('pointercancel', lift);
        canvas.addEventListener('contextmenu', event => event.preventDefault());
        canvas.addEventListener('wheel', event => {
            more[AHEAD] -= metres(Math.max(-4, Math.min(4, event.deltaY * 0.01)));
            event.preventDefault();
        }, { passive: false });

        /* -- input --------------------------------------------------------------- */

        function apply(input) {
            const run = down.has('ShiftLeft') || down.has('ShiftRight');
            for (const code of down) {
                const [field, size] = HELD[code] || [0, 0];
                input[field] += field <= UP ? size * (run ? RUN : WALK) : size;
            }
            more.forEach((n, field) => { input[field] += n; });
            more.fill(0);
        }

        /* Shift is a held key too, without an effect of its own. */
        document.addEventListener('keydown', event => {
            if (event.key === 'Shift')
                down.add(event.code);
        });

        const movesCamera = () => more.slice(AHEAD, TILT + 1).some(Boolean)
            || [...down].some(code => HELD[code] && HELD[code][0] <= UP);

        return { apply, movesCamera };
    };

    root.HELP = [
        ['Mouse', [
            ['left drag', 'turn and tilt the camera'],
            ['click', 'poke the water, or release a drop'],
            ['right drag', 'stir the water'],
            ['wheel', 'nearer and farther']]],
        ['Fingers', [
            ['drag', 'turn and tilt'],
            ['tap', 'poke the water, or release a drop'],
            ['two', 'spread: move nearer; drag together: left, right, up, down']]],
        ['Keys', [
            ['W A S D', 'forward, left, back, right'],
            ['Q E, Shift', 'down, up; move four times as fast'],
            ['F O T B', 'look freely, orbit, from above, from the boat'],
            ['arrows, Space', 'move the sphere of drops; release a drop'],
            ['1 … 6', 'poke the pool'],
            ['I K J L', 'sail faster, slower, left, right'],
            ['Home End', 'turn the sun; PgUp, PgDn: raise and lower it'],
            ['P', 'pause; . (full stop): one picture forward'],
            ['[ ]', 'halve, double the speed of time'],
            ['R', 'restart the scene, keep your changes'],
            ['N, Shift+N', 'next scene, previous scene'],
            ['/ or F3', 'search the parameters; F2: hide or show them'],
            ['C', 'CRC of each frame']]],
    ];
})(globalThis);
