/* SPDX-License-Identifier: MIT */
/* A scene as the fragment of an address: only the values unlike its file.
 *
 *     #scene=storm&wave0.amplitude=0.8&camera.x=3.5&size=320x240&format=rgb565
 *
 * look=orbit starts in that camera mode. frame=30 runs to that frame and pauses; without
 * other input the picture then equals the one of `tidepool render`, bit for bit. */
'use strict';
(function (root) {
    const AT = ['camera.x', 'camera.y', 'camera.z', 'camera.heading', 'camera.pitch'];

    /* Decodes %-codes.  Typed addresses may have invalid codes: the text is then used as
     * it is. */
    function plain(text) {
        try {
            return decodeURIComponent(text);
        } catch (error) {
            return text;
        }
    }

    /* Returns { scene, size: [w, h], format, look, frame, settings: [[name, text] ...]
     * }. */
    function read(fragment) {
        const found = { settings: [] };
        for (const part of fragment.replace(/^#/, '').split('&').filter(Boolean)) {
            const equals = part.indexOf('=');
            const name = plain(equals < 0 ? part : part.slice(0, equals));
            const text = equals < 0 ? '' : plain(part.slice(equals + 1));
            const size = text.match(/^(\d+)x(\d+)$/);
            if (name === 'size' && size)
                found.size = [+size[1], +size[2]];
            else if (name === 'frame')
                found.frame = Math.max(0, Math.min(20000, parseInt(text, 10) || 0));
            else if (['scene', 'format', 'look', 'size'].includes(name))
                found[name] = text;
            else
                found.settings.push([name, text.replace(/^(\.\.\/)+/, '')]);
        }
        return found;
    }

    const say = text => encodeURIComponent(text).replace(/%2F/g, '/');

    function write(state) {
        const parts = [`scene=${say(state.scene)}`];
        for (const [name, text] of state.settings)
            parts.push(`${name}=${say(text)}`);
        for (const name of ['size', 'format'])
            if (state[name])
                parts.push(`${name}=${say(state[name])}`);
        return '#' + parts.join('&');
    }

    /* Returns the camera's pose as settings.  Five decimals determine a Q16.16 number. */
    function place(camera) {
        return AT.map((name, i) => [name, String(+(camera[i] / 65536).toFixed(5))]);
    }

    root.share = { read, write, place, AT };
})(globalThis);
