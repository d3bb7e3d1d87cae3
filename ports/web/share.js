/* SPDX-License-Identifier: MIT */
/* A scene as the end of an address: only what differs from its file.
 *
 *     #scene=storm&wave0.amplitude=0.8&camera.x=3.5&size=320x240&format=rgb565
 *
 * look=orbit begins with that way to look.  frame=30 goes on to that frame and pauses
 * there; whoever has done nothing else sees the bits that `tidepool render` draws. */
'use strict';
(function (root) {
    const AT = ['camera.x', 'camera.y', 'camera.z', 'camera.heading', 'camera.pitch'];

    /* Addresses are typed by hand too: what is no code stays as it is. */
    function plain(text) {
        try {
            return decodeURIComponent(text);
        } catch (error) {
            return text;
        }
    }

    /* { scene, size: [w, h], format, look, frame, settings: [[name, text] ...] } */
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

    /* The camera's place as settings.  Five decimals tell a 16.16 number. */
    function place(camera) {
        return AT.map((name, i) => [name, String(+(camera[i] / 65536).toFixed(5))]);
    }

    root.share = { read, write, place, AT };
})(globalThis);
