/* SPDX-License-Identifier: MIT */
/* Picture formats and sizes, the canvas's position and scale, dialogs over the page. */
'use strict';
(function (root) {
    root.FORMATS = ['xrgb8888', 'rgb565', 'rgb565be', 'p8', 'l8', 'i1'];
    root.SHOWN = [['xrgb8888', '24 bits'], ['rgb565', 'rgb565'], ['p8', '256 colours'],
                   ['l8', '256 greys'], ['i1', 'black, white']];
    root.SIZES = ['160x120', '240x320', '320x240', '480x360', '640x480', '800x600',
                  '960x540', '1280x720'];
    root.sizeOption = size => make('option', { value: size }, size.replace('x', ' × '));

    /* Scales the canvas: `zoom` device pixels per picture pixel, or as large as its
     * place, from factor 2 on by whole numbers, to keep a dither pattern even.  Aligns
     * the canvas to device pixels; otherwise it would be blurred. */
    root.fitCanvas = function (canvas, zoom) {
        const box = canvas.parentElement.getBoundingClientRect();
        const ratio = devicePixelRatio || 1;
        const most = ratio * Math.min(box.width / canvas.width,
                                      box.height / canvas.height);
        const by = (zoom || (most < 2 ? most : Math.floor(most))) / ratio;
        const width = canvas.width * by, height = canvas.height * by;
        const whole = at => Math.round(at * ratio) / ratio;
        Object.assign(canvas.style, {
            width: `${width}px`, height: `${height}px`,
            left: `${whole(box.left + (box.width - width) / 2) - box.left}px`,
            top: `${whole(box.top + Math.max(0, box.height - height) / 2) - box.top}px`,
        });
        canvas.classList.toggle('exact', zoom > 0 || by * ratio >= 2);
    };

    /* Returns the size of a picture to fill a place at a whole number of device pixels
     * per pixel; the picture has about as many pixels as 320 x 240. */
    root.uprightSize = function (place) {
        const wide = place.clientWidth * (devicePixelRatio || 1);
        const high = place.clientHeight * (devicePixelRatio || 1);
        const by = Math.max(1, Math.round(Math.sqrt(wide * high / 84000)));
        return [wide, high].map(n => Math.max(16, Math.floor(n / by)));
    };

    function openSheet(title, ...inside) {
        document.getElementById('sheet-title').textContent = title;
        document.getElementById('sheet-body').replaceChildren(...inside);
        document.getElementById('sheet').showModal();
    }

    root.shareSheet = async function (link) {
        const field = make('input', { type: 'text', readOnly: true, value: link,
                                      'aria-label': 'Link', id: 'link' });
        const said = make('p', {}, 'Opens this view: scene, changes, camera.');
        openSheet('Link to this view', said, field);
        field.select();
        try {
            await navigator.clipboard.writeText(link);
            said.textContent += ' It has been copied.';
        } catch (error) {
            said.textContent += ' Copy it from here:';
        }
    };

    root.helpSheet = function () {
        const kb = base64 => base64.length * 3 / 4000;
        const files = Object.values(TIDEPOOL.files).reduce((sum, f) => sum + kb(f), 0);
        const lists = HELP.flatMap(([title, lines]) => [
            make('h3', {}, title),
            make('dl', {}, ...lines.flatMap(([keys, does]) => [make('dt', {}, keys),
                                                               make('dd', {}, does)])),
        ]);
        openSheet('Keys, mouse, fingers', ...lists, make('p', {},
            `Program and scenes: ${Math.round(kb(TIDEPOOL.module))} KB; `
            + `pictures and boats: ${Math.round(files)} KB. `
            + 'The page loads nothing else and stores nothing.'));
    };
})(globalThis);
