// What stands around the picture: what the light is, figures and notes.

function newElement(tag, text, className) {
    const made = document.createElement(tag);
    if (text !== undefined) made.textContent = text;
    if (className) made.className = className;
    return made;
}

function tableRow(cells, tags) {
    const row = newElement('tr');
    row.append(...cells.map((cell, i) => {
        const made = newElement(tags[i] ?? tags.at(-1), cell);
        if (made.tagName === 'TH') made.scope = tags.length === 1 ? 'col' : 'row';
        return made;
    }));
    return row;
}

function figureSection({ heading, note, columns, rows }) {
    const section = newElement('section');
    const table = newElement('table');
    const head = newElement('thead');
    head.append(tableRow(columns, ['th']));
    const body = newElement('tbody');
    body.append(...rows.map((row) => tableRow(row, ['th', 'td'])));
    table.append(head, body);
    const wide = newElement('div', undefined, 'wide');
    wide.tabIndex = 0; // so that keys can scroll it
    wide.setAttribute('role', 'region');
    wide.setAttribute('aria-label', heading);
    wide.append(table);
    section.append(newElement('h2', heading), newElement('p', note, 'note'), wide);
    return section;
}

function noteSection(notes) {
    const section = newElement('section');
    section.append(newElement('h2', 'Notes'), ...notes.map((note) => newElement('p', note, 'note')));
    return section;
}

function aboutText() {
    const { sizes, format, exact } = facts.specular;
    const levels = sizes.length === 1 ? '1 level' : `${sizes.length} levels`;
    const rounded = exact ? 'the texels as they are stored' : 'texels rounded to half floats';
    return `Spheres under baked light: ${sizes[0]}² in ${levels}, irradiance ${facts.irradiance.sizes[0]}², ` +
        `table ${facts.table.width}×${facts.table.height}. Drawn from ${rounded} (${format}), as an engine would.`;
}

function showFigures() {
    element('about').textContent = aboutText();
    element('figures').replaceChildren(...facts.tables.map(figureSection),
        ...(facts.notes.length > 0 ? [noteSection(facts.notes)] : []));
    element('footer').textContent = `Splitsum ${facts.version}. This file loads nothing.`;
}
