#include "draw/html/script.hpp"

namespace brdfplot::plot {

std::string_view page_script() {
  return R"js(
(() => {
'use strict';
const all = (selector, root = document) => [...root.querySelectorAll(selector)];
const make = (name, of = {}) => Object.assign(document.createElement(name), of);

// The CSV, which the page holds deflated.
const texts = new Map();
function csvOf(figure) {
  if (!texts.has(figure)) {
    const bytes = Uint8Array.from(atob(figure.querySelector('.csv').textContent), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
    texts.set(figure, new Response(stream).text());
  }
  return texts.get(figure);
}
function rowsOf(text) {
  const rows = [];
  for (const line of text.split('\n')) {
    if (!line) continue;
    const row = [];
    for (const [, quoted, plain] of line.matchAll(/(?:"((?:[^"]|"")*)"|([^,]*))(?:,|$)/g))
      row.push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    row.length = line.endsWith(',') ? row.length : row.length - 1;
    rows.push(row);
  }
  return rows;
}

// Axes: what stands at a place in [0, 1], and how it is told.
function axis(panel, name) {
  const [from, to, unit, scale] = panel.dataset[name].split(' ');
  const label = (panel.dataset[name + 'Label'] || name).replace(/ \((degrees|°)\)$/, '');
  return {from: +from, to: +to, unit, log: scale === 'log', label};
}
const valueAt = (a, place) => a.log ? a.from * Math.pow(a.to / a.from, place) : a.from + (a.to - a.from) * place;
const placeOf = (a, value) => a.log ? Math.log(value / a.from) / Math.log(a.to / a.from)
                                    : (value - a.from) / (a.to - a.from);
function told(a, value, exact) {
  const factor = a.unit === 'degrees' ? 180 / Math.PI : 1;
  let text;
  if (exact || a.log) {
    text = String(+(value * factor).toPrecision(exact ? 5 : 3));
  } else { // as many decimals as the drawing has
    const decimals = Math.round(Math.log10(2000 / ((a.to - a.from) * factor)));
    text = (value * factor).toFixed(Math.min(Math.max(decimals, 0), 20));
  }
  text = text.replace(/e\+?(-?\d+)$/, '·10<sup>$1</sup>').replaceAll('-', '−');
  return `${a.label} = ${text}${a.unit === 'degrees' ? '°' : a.unit === 'radians' ? ' rad' : ''}`;
}

// Curves, from the data of their paths: M, l, z and the arcs of dots.
const pieces = new WeakMap();
function piecesOf(path) {
  if (pieces.has(path)) return pieces.get(path);
  const words = path.getAttribute('d').match(/[A-Za-z]|-?(?:\d+\.?\d*|\.\d+)/g) || [];
  const out = [];
  let command = '', x = 0, y = 0;
  for (let k = 0; k < words.length;) {
    if (/[A-Za-z]/.test(words[k])) command = words[k++];
    if (command === 'M') {
      out.push([[x = +words[k++], y = +words[k++]]]);
    } else if (command === 'l') {
      out.at(-1).push([x += +words[k++], y += +words[k++]]);
    } else if (command === 'A') {
      out.at(-1)[0] = [x + +words[k], y];
      k += 7;
    }
  }
  pieces.set(path, out);
  return out;
}
function nearest(paths, p, box) {
  let best = null;
  for (const path of paths)
    for (const piece of piecesOf(path))
      for (let k = 0; k < Math.max(piece.length - 1, 1); ++k) {
        const [ax, ay] = piece[k], [bx, by] = piece[k + 1] || piece[k];
        const dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
        const t = length ? Math.min(Math.max(((p.x - ax) * dx + (p.y - ay) * dy) / length, 0), 1) : 0;
        const x = ax + t * dx, y = ay + t * dy, distance = Math.hypot(p.x - x, p.y - y);
        if (x < box.x - 1 || x > box.x + box.w + 1 || y < box.y - 1 || y > box.y + box.h + 1) continue;
        if (!best || distance < best.distance) best = {distance, x, y, path};
      }
  return best;
}

// The heat map's cell under a place: its rows in the CSV are those of the panel's name, one grid after the other.
const grids = new WeakMap();
function gridOf(panel, svg, text) {
  if (grids.has(panel)) return grids.get(panel);
  const [header, ...rows] = rowsOf(text);
  const [x, y] = panel.dataset.columns.split(',').map(name => header.indexOf(name));
  const own = rows.filter(row => row[0] === panel.dataset.panel);
  const same = all('.bp-panel', svg).filter(other => other.dataset.panel === panel.dataset.panel);
  const starts = own.flatMap((row, k) => row[x] === own[0][x] && row[y] === own[0][y] ? [k] : []);
  const nth = same.indexOf(panel);
  let value = header.length - 1;
  while (header[value] === 'name' || header[value].endsWith('_stderr')) --value;
  const grid = own.slice(starts[nth], starts[nth + 1]).map(row => [+row[x], +row[y], row[value]]);
  grids.set(panel, grid);
  return grid;
}
function cellAt(grid, ax, ay, px, py) {
  let best = null;
  for (const [x, y, value] of grid) {
    const distance = Math.max(Math.abs(placeOf(ax, x) - px), 1e-12) + Math.abs(placeOf(ay, y) - py);
    if (!best || distance < best.distance) best = {distance, x, y, value};
  }
  return best;
}

const tip = make('div', {className: 'tip', hidden: true});
tip.setAttribute('role', 'status');
function boxOf(panel) {
  const [x, y, w, h] = panel.dataset.plot.split(' ').map(Number);
  return {x, y, w, h};
}
// A label with its scripts, from a legend's text.
function markup(text) {
  return [...text.childNodes].map(node => {
    const words = make('span', {textContent: node.textContent}).innerHTML;
    const size = node.nodeType === 1 && node.hasAttribute('font-size');
    const tag = size ? (+node.getAttribute('dy') > 0 ? 'sub' : 'sup') : '';
    return tag ? `<${tag}>${words}</${tag}>` : words;
  }).join('');
}
function nameOf(path, panel, svg) {
  const key = `.bp-entry[data-key="${path.dataset.key}"]`;
  const entry = panel.querySelector(key) || all(key, svg).find(e => !e.closest('.bp-panel'));
  return entry ? all('text', entry).map(markup).join(' ') : '';
}
function readCurve(svg, panel, p) {
  const box = boxOf(panel), polar = panel.dataset.kind === 'polar';
  const paths = all('path.bp-line[data-key]', panel).filter(path => !path.closest('.bp-entry, .bp-off'));
  const at = nearest(paths, p, box);
  if (!at) return null;
  const ax = axis(panel, 'x'), ay = axis(panel, 'y'), radius = box.w / 2;
  const dx = at.x - box.x - radius, dy = at.y - box.y - radius;
  const x = polar ? Math.atan2(dx, -dy) : valueAt(ax, (at.x - box.x) / box.w);
  const y = valueAt(ay, polar ? Math.hypot(dx, dy) / radius : (box.y + box.h - at.y) / box.h);
  return {at, lines: [nameOf(at.path, panel, svg), told(ax, x), told(ay, y)]};
}
async function readCell(svg, panel, p) {
  const figure = svg.closest('figure') || enlarged.figure, box = boxOf(panel);
  const grid = gridOf(panel, svg, await csvOf(figure));
  const ax = axis(panel, 'x'), ay = axis(panel, 'y'), value = axis(panel, 'value');
  const cell = cellAt(grid, ax, ay, (p.x - box.x) / box.w, (box.y + box.h - p.y) / box.h);
  if (!cell) return null;
  const at = {x: box.x + box.w * placeOf(ax, cell.x), y: box.y + box.h * (1 - placeOf(ay, cell.y))};
  const z = cell.value === '' || cell.value === 'nan' ? value.label + ': undefined' : told(value, +cell.value, true);
  return {at, lines: [told(ax, cell.x), told(ay, cell.y), z]};
}
// A sphere's pixel: the angle from the normal there to the viewer, and the light that is shown, which sRGB encodes.
const pixels = new WeakMap();
async function pixelsOf(panel) {
  if (!pixels.has(panel)) {
    const picture = make('img', {src: panel.querySelector('image').getAttribute('href')});
    await picture.decode();
    const pen = make('canvas', {width: picture.width, height: picture.height}).getContext('2d');
    pen.drawImage(picture, 0, 0);
    pixels.set(panel, pen.getImageData(0, 0, picture.width, picture.height));
  }
  return pixels.get(panel);
}
function linear(byte) {
  const c = byte / 255;
  const light = c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  return byte === 255 ? '≥ 1' : String(+light.toPrecision(2));
}
async function readPixel(svg, panel, p) {
  const box = boxOf(panel), ax = axis(panel, 'x'), {data, width, height} = await pixelsOf(panel);
  const px = (p.x - box.x) / box.w, py = (p.y - box.y) / box.h, away = Math.hypot(valueAt(ax, px), valueAt(ax, py));
  if (away >= 1) return null;
  const first = 4 * (Math.floor(py * height) * width + Math.floor(px * width));
  const shown = [...data.slice(first, first + 3)].map(linear);
  const grey = shown[0] === shown[1] && shown[0] === shown[2];
  const angle = {from: 0, to: Math.PI / 2, unit: 'degrees', label: 'θ<sub>o</sub>'};
  return {at: p, lines: [told(angle, Math.asin(away)), `exposure × radiance: ${(grey ? [shown[0]] : shown).join(', ')}`]};
}
const readers = {heatmap: readCell, spheres: readPixel};
let last = null;
function forget() {
  last = null;
  tip.hidden = true;
  for (const mark of all('.bp-mark')) mark.remove();
}
async function read(event, svg) {
  const here = last = {};
  const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  const panel = all('.bp-panel[data-plot]', svg).find(each => {
    const b = boxOf(each);
    return p.x > b.x - 6 && p.x < b.x + b.w + 6 && p.y > b.y - 6 && p.y < b.y + b.h + 6;
  });
  const found = panel && await (readers[panel.dataset.kind] || readCurve)(svg, panel, p);
  if (here !== last) return; // the pointer has moved on
  forget();
  if (!found) return;
  const mark = document.createElementNS(svg.namespaceURI, 'circle');
  for (const [name, value] of Object.entries({class: 'bp-mark', cx: found.at.x, cy: found.at.y, r: 4}))
    mark.setAttribute(name, value);
  panel.append(mark);
  tip.innerHTML = found.lines.filter(Boolean).join('<br>');
  svg.parentNode.append(tip);
  tip.hidden = false;
  const room = document.documentElement.clientWidth - tip.offsetWidth - 4;
  tip.style.left = Math.max(Math.min(event.clientX + 14, room), 4) + 'px';
  const above = event.clientY - tip.offsetHeight - 12;
  tip.style.top = (above > 0 ? above : event.clientY + 18) + 'px';
}

// A legend's entry hides what is drawn of its series, in its panel, or where all share it in all.
function listen(entry, svg) {
  const scope = entry.closest('.bp-panel') || svg;
  entry.setAttribute('role', 'button');
  entry.setAttribute('tabindex', '0');
  entry.setAttribute('aria-pressed', 'true');
  const toggle = () => {
    const off = entry.classList.toggle('bp-faint');
    entry.setAttribute('aria-pressed', String(!off));
    for (const part of all(`[data-key="${entry.dataset.key}"]`, scope))
      if (part !== entry) part.classList.toggle('bp-off', off);
    forget();
  };
  entry.addEventListener('click', toggle);
  entry.addEventListener('keydown', event => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    toggle();
  });
}

// A figure opens large: its drawing itself moves, and comes back.
const large = make('dialog', {className: 'large'});
const close = make('button', {type: 'button', textContent: 'Close'});
const enlarged = {};
large.append(close);
document.body.append(large);
close.onclick = () => large.close();
large.onclick = event => { if (event.target === large) large.close(); };
large.onclose = () => {
  forget();
  enlarged.hole.replaceWith(enlarged.plot);
};
function enlarge(figure) {
  forget();
  const plot = figure.querySelector('.plot'), hole = make('div');
  hole.style.height = plot.offsetHeight + 'px';
  Object.assign(enlarged, {figure, plot, hole});
  plot.replaceWith(hole);
  const {width, height} = plot.querySelector('svg').viewBox.baseVal;
  plot.style.setProperty('--aspect', width / height);
  large.append(plot);
  large.showModal();
}

// Files, from what the page holds: it may have been moved away from the folder that it was made in.
function drawing(svg) {
  const copy = svg.cloneNode(true);
  for (const part of all('.bp-mark', copy)) part.remove();
  for (const part of all('.bp-off, .bp-faint', copy)) part.classList.remove('bp-off', 'bp-faint');
  for (const entry of all('.bp-entry', copy))
    for (const name of ['role', 'tabindex', 'aria-pressed']) entry.removeAttribute(name);
  copy.setAttribute('role', 'img');
  const style = document.createElementNS(svg.namespaceURI, 'style');
  style.textContent = document.getElementById('bp-style').textContent;
  copy.querySelector('desc').after(style);
  return new XMLSerializer().serializeToString(copy) + '\n';
}
const files = {
  svg: figure => [drawing(figure.querySelector('.plot svg')), 'image/svg+xml'],
  csv: async figure => [await csvOf(figure), 'text/csv'],
  json: figure => [figure.querySelector('.config pre').textContent, 'application/json'],
};
async function save(link) {
  const [text, type] = await files[link.dataset.file](link.closest('figure'));
  const url = URL.createObjectURL(new Blob([text], {type}));
  make('a', {href: url, download: link.getAttribute('href').split('/').at(-1)}).click();
  setTimeout(() => URL.revokeObjectURL(url), 60000);
}

for (const svg of all('.plot svg')) {
  const entries = all('.bp-entry[data-key]', svg);
  if (entries.length) svg.setAttribute('role', 'group');
  for (const entry of entries) listen(entry, svg);
  if (!svg.querySelector('.bp-panel[data-plot]')) continue;
  for (const name of ['pointermove', 'pointerdown']) svg.addEventListener(name, event => read(event, svg));
  svg.addEventListener('pointerleave', event => { if (event.pointerType === 'mouse') forget(); });
}
for (const link of all('a[data-file]')) {
  link.hidden = false;
  link.addEventListener('click', event => {
    event.preventDefault();
    save(link);
  });
}
for (const button of all('button[data-enlarge]')) {
  button.hidden = false;
  button.onclick = () => enlarge(button.closest('figure'));
}
})();
)js";
}

} // namespace brdfplot::plot
