// SPDX-License-Identifier: BSD-3-Clause
// Texts, elements and tables of the page.

const isNumber = value => typeof value === 'number' && isFinite(value);
const sum = (list, valueOf) => list.reduce((total, item) => total + (valueOf(item) || 0), 0);

// 1234567.5 becomes "1 234 567.5" with narrow spaces, -0.001 becomes "0.00".
function number(value, digits = 0) {
  if (!isNumber(value)) return '–';
  const [whole, part] = value.toFixed(digits).replace(/^-(?=[0.]+$)/, '').split('.');
  return whole.replace(/\B(?=(\d{3})+$)/g, '\u202f') + (part ? '.' + part : '');
}
const percent = share => !isNumber(share) ? '–'
  : (100 * share).toFixed(share > 0 && share < 0.0995 ? 1 : 0) + '\u00a0%';
const centimetres = metres => number(100 * metres, metres < 0.1 ? 2 : 1) + '\u00a0cm';
const closed = mesh => !mesh ? '–' : mesh.closed_manifold ? 'closed' : 'open';
// A distance as short as it is: 4 cm, 0.3 cm, 1.2 m.
const distance = metres => metres >= 1 ? metres.toFixed(1) + ' m' : +(100 * metres).toPrecision(3) + ' cm';

function make(tag, attributes, ...children) {
  const element = document.createElement(tag);
  Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
  element.append(...children);
  return element;
}

// A table of rows; each column is [heading, text of a row, 'text' for words]. On a phone, each cell has its heading.
function table(columns, rows) {
  const cells = (tag, textOf) => columns.map(column =>
    make(tag, { 'data-heading': column[0], ...column[2] && { class: column[2] } }, textOf(column)));
  const row = item => make('tr', {}, ...cells('td', column => column[1](item)));
  return make('div', { class: 'wide' }, make('table', {},
    make('thead', {}, make('tr', {}, ...cells('th', column => column[0]))), make('tbody', {}, ...rows.map(row))));
}

function fillKey(element, entries) {
  element.append(...entries.map(([colour, text]) => make('span', { class: 'entry' },
    make('span', { class: 'swatch', style: 'background:' + colour }), text)));
}
