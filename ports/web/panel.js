/* SPDX-License-Identifier: MIT */
/* The panel: a row of controls for each row of the table of parameters, in groups.
 *
 *     const panel = makePanel(engine, files, change)
 *     panel.show()            shows all values anew, after a change of scene
 *     panel.update(p)         shows the value of one row
 *     panel.refuse(p)         marks the last value as refused
 *
 * change(p, text) is called for each change by the person; it may refuse. */
'use strict';
(function (root) {
    const FIRST = ['camera', 'light', 'wave0', 'water'];     /* groups open at first */

    function make(tag, attributes, ...inside) {
        const node = document.createElement(tag);
        for (const [name, value] of Object.entries(attributes || {}))
            if (name in node && name !== 'list')
                node[name] = value;
            else
                node.setAttribute(name, value);
        node.append(...inside);
        return node;
    }

    /* -- numbers ----------------------------------------------------------------- */

    const scale = p => p.kind === 'fx' ? 65536 : 1;

    /* Returns the range of a slider.  The table's range has all possible values; the
     * slider has the useful ones: a few times the largest of value, file's value and
     * default. */
    function span(p, now, filed) {
        const [low, high, normal] = [p.low, p.high, p.normal].map(n => n / scale(p));
        const at = Math.max(Math.abs(now), Math.abs(filed), Math.abs(normal));
        if (p.unit === 'degrees' && high > 360)
            return at <= 180 ? [-180, 180] : at <= 360 ? [-360, 360] : [low, high];
        if (high - low <= 24 && high <= 8 * Math.max(at, 1))
            return [low, high];
        const most = 4 * Math.max(at, p.kind === 'int' ? 16 : 0.5);
        return [Math.max(low, low < 0 ? -most : low), Math.min(high, most)];
    }

    /* Returns a step of 1, 2 or 5 times a power of ten, about 1/200 of the range. */
    function stepOf(p, low, high) {
        const fine = (high - low) / 200, ten = 10 ** Math.floor(Math.log10(fine));
        const step = fine / ten < 2 ? ten : fine / ten < 5 ? 2 * ten : 5 * ten;
        return p.kind === 'int' ? Math.max(1, Math.round(step)) : Math.max(step, 0.0001);
    }

    const plain = (value, step) =>
        String(+value.toFixed(Math.max(0, Math.ceil(-Math.log10(step) - 1e-9))));

    /* -- controls, by kind: { nodes, set(text), get } ---------------------------- */

    function numberControl(row, p) {
        const range = make('input', { type: 'range', tabIndex: 0, 'aria-label': p.name });
        const field = make('input', { type: 'number', step: 'any', id: row.id,
                                      inputMode: 'decimal' });
        let step = 1;
        range.oninput = () => {
            field.value = plain(+range.value, step);
            row.give(field.value);
        };
        field.onchange = () => row.give(field.value);
        const set = text => {
            const [low, high] = span(p, +text, +row.filed);
            step = stepOf(p, low, high);
            Object.assign(range, { min: low, max: high, step: 'any' });
            range.value = text;
            field.value = text;
        };
        const unit = make('span', { className: 'unit' }, p.unit.replace('degrees', '°'));
        return { nodes: [range, make('span', { className: 'value' }, field, unit)],
                 set, field, keep: text => { field.value = text; } };
    }

    function choiceControl(row, options) {
        const field = make('select', { id: row.id, className: 'wide' });
        for (const [value, words] of options)
            field.append(make('option', { value }, words));
        field.onchange = () => row.give(field.value);
        return { nodes: [field], field, set: text => {
            if (![...field.options].some(o => o.value === text))
                field.append(make('option', { value: text }, text));
            field.value = text;
        } };
    }

    function plainControl(row, type, wide) {
        const field = make('input', { type, id: row.id, className: wide ? 'wide' : '' });
        const event = type === 'color' ? 'oninput' : 'onchange';
        field[event] = () => row.give(type === 'checkbox' ? field.checked ? 'on' : 'off'
                                                           : field.value);
        const nodes = [wide ? field : make('span', { className: 'wide' }, field)];
        return { nodes, field, set: text => {
            if (type === 'checkbox')
                field.checked = text === 'on';
            else
                field.value = text;
        } };
    }

    function control(row, p, files) {
        const named = ends => [['', 'none'], ...files.filter(f => f.endsWith(ends))
            .map(f => [f, f.replace(/^.*\//, '').replace(/\.\w+$/, '')])];
        switch (p.kind) {
        case 'fx': case 'int': return numberControl(row, p);
        case 'bool':    return plainControl(row, 'checkbox', false);
        case 'colour':  return plainControl(row, 'color', false);
        case 'choice':  return choiceControl(row, p.unit.split('|').map(w => [w, w]));
        case 'mesh':    return choiceControl(row, named('.obj'));
        case 'texture': case 'grey': return choiceControl(row, named('.png'));
        default:        return plainControl(row, 'text', true);
        }
    }

    /* -- rows and groups --------------------------------------------------------- */

    function range(p, engine) {
        if (p.kind === 'fx' || p.kind === 'int')
            return `${engine.number(p, p.low)} … ${engine.number(p, p.high)} ${p.unit}`;
        return p.kind === 'choice' ? p.unit.split('|').join(', ') : '';
    }

    root.makePanel = function (engine, files, change) {
        const box = document.getElementById('groups');
        const about = document.getElementById('about');
        const search = document.getElementById('search');
        const rows = [], groups = new Map();

        function tell(row) {
            const p = row.param, more = range(p, engine);
            about.replaceChildren(make('b', {}, p.name),
                                  ` ${p.help}${more ? ` (${more})` : ''}`);
        }

        function makeRow(p) {
            const row = { param: p, id: 'p-' + p.name, filed: '', text: '' };
            row.give = text => change(p, text);
            row.control = control(row, p, files);
            const undo = make('button', {
                type: 'button', className: 'undo', title: "Reset to the file's value",
                'aria-label': `Reset ${p.name}`, onclick: () => change(p, row.filed),
            }, '↺');
            row.node = make('div', { className: 'row' },
                            make('label', { htmlFor: row.id }, p.name.split('.')[1]),
                            ...row.control.nodes, undo);
            row.node.dataset.name = p.name;
            row.node.title = `${p.name}: ${p.help}`;
            row.node.addEventListener('pointerenter', () => tell(row));
            row.node.addEventListener('focusin', () => tell(row));
            return row;
        }

        function groupOf(name) {
            if (!groups.has(name)) {
                const count = make('span', { className: 'count' });
                const node = make('details', { open: FIRST.includes(name) },
                                  make('summary', {}, make('span', {}, name), count));
                node.dataset.group = name;
                groups.set(name, { name, node, count, rows: [] });
                box.append(node);
            }
            return groups.get(name);
        }

        for (const p of engine.table) {
            const group = groupOf(p.name.split('.')[0]), row = makeRow(p);
            group.rows.push(row);
            group.node.append(row.node);
            rows[p.index] = row;
        }

        /* Shows a group in a dim style if the scene does not use its feature. */
        const lacks = { wave: 'amplitude', pool: 'cols', field: 'cols', drops: 'count',
                        foam: 'cells', spray: 'count', boat: 'mesh', tank: 'kind' };
        function dress(group) {
            const changed = group.rows.filter(r => r.text !== r.filed).length;
            const key = lacks[group.name.replace(/\d+$/, '')];
            const row = key && group.rows.find(r => r.param.name.endsWith('.' + key));
            group.node.classList.toggle('unused',
                                        !!row && ['', '0', 'none'].includes(row.text));
            group.count.textContent = changed ? `${changed} changed` : '';
        }

        function mark(row) {
            row.node.classList.toggle('changed', row.text !== row.filed);
            row.control.field.removeAttribute('aria-invalid');
        }

        function update(p) {
            const row = rows[p.index];
            row.text = engine.value(p);
            mark(row);
            const focus = document.activeElement;
            if (focus?.type === 'range' && row.node.contains(focus))
                row.control.keep(row.text);     /* its slider is being dragged */
            else
                row.control.set(row.text);
            dress(groups.get(p.name.split('.')[0]));
        }

        function show() {
            for (const row of rows) {
                row.filed = engine.filed(row.param);
                row.text = engine.value(row.param);
                row.control.set(row.text);
                mark(row);
            }
            groups.forEach(dress);
        }

        function refuse(p) {
            rows[p.index].control.field.setAttribute('aria-invalid', 'true');
        }

        /* Search: every word must be in the name or in the help. */
        const none = make('p', { className: 'none', hidden: true },
                          'No parameter matches.');
        box.append(none);
        let opened = null;      /* groups open before the search */
        search.addEventListener('input', () => {
            const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
            const all = [...groups.values()];
            if (words.length && !opened)
                opened = new Set(all.filter(g => g.node.open));
            let met = 0;
            for (const group of all) {
                let here = 0;
                for (const row of group.rows) {
                    const text = `${row.param.name} ${row.param.help}`.toLowerCase();
                    const fits = words.every(w => text.includes(w));
                    row.node.hidden = !fits;
                    here += fits;
                }
                group.node.hidden = !here;
                if (opened)
                    group.node.open = words.length ? here > 0 : opened.has(group);
                met += here;
            }
            none.hidden = met > 0;
            if (!words.length)
                opened = null;
        });

        return { show, update, refuse,
                 changed: () => rows.filter(r => r.text !== r.filed) };
    };
    root.make = make;
})(globalThis);
