"use strict";
// The module and its memory; what the page shows is computed by it. Everything is asked for by `brdfplot`.

const brdfplot = (() => {
  const degree = Math.PI / 180;
  let compiled, wasm, about;

  function start() {
    let memory;
    const view = () => new DataView(memory.buffer);
    const calls = {
      environ_sizes_get: (count, size) => (view().setUint32(count, 0, true), view().setUint32(size, 0, true), 0),
      environ_get: () => 0,
      proc_exit: (code) => { throw new Error(`the module ended (${code})`); },
    };
    const imports = {};
    for (const { module, name } of WebAssembly.Module.imports(compiled))
      (imports[module] ??= {})[name] = calls[name] ?? (() => 52); // 52: there is no such call
    wasm = new WebAssembly.Instance(compiled, imports).exports;
    memory = wasm.memory;
    wasm._initialize();
  }

  const message = () =>
    new TextDecoder().decode(new Uint8Array(wasm.memory.buffer, wasm.message(), wasm.message_size()));

  // What ends the module (memory that there is not) is told as other errors are; the module is then made anew.
  let last = null;
  function guarded(work) {
    try {
      return work();
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError || error instanceof WebAssembly.Exception || error instanceof RangeError)) throw error;
      start();
      if (last !== null) give(last);
      throw new Error(`the computation ended: ${error.message}`);
    }
  }

  function give(text) {
    const bytes = new TextEncoder().encode(text);
    new Uint8Array(wasm.memory.buffer, wasm.text(bytes.length), bytes.length).set(bytes);
    return wasm.material() === 0;
  }

  function setMaterial(text) {
    guarded(() => {
      if (!give(text)) throw new Error(message());
      last = text;
    });
  }

  const number = (list, name) => {
    const found = list.findIndex((one) => one.name === name);
    if (found < 0) throw new Error(`there is no ${name}`);
    return found;
  };

  // Directions as [theta, phi] (radians) or, with `xyz`, [x, y, z] of each row.
  function fill(rows, directions, xyz) {
    const at = wasm.numbers(rows), numbers = new Float64Array(wasm.memory.buffer, at, 12 * rows).fill(0);
    ["o", "i", "m"].forEach((name, k) => {
      if (!directions[name]) return;
      for (let row = 0; row < rows; ++row) {
        const d = directions[name][row];
        for (let c = 0; c < d.length; ++c) numbers[(3 * k + c) * rows + row] = d[c];
      }
    });
    if (!xyz) wasm.directions();
    return at;
  }

  function results(at, rows, channels) {
    if (channels === 0) throw new Error(message());
    const all = new Float64Array(wasm.memory.buffer, at, 12 * rows);
    return Array.from({ length: channels }, (_, c) => all.slice((9 + c) * rows, (10 + c) * rows));
  }

  const rowsOf = (directions) => Object.values(directions)[0].length;

  function evaluate(name, directions, xyz = false) {
    return guarded(() => {
      const rows = rowsOf(directions), at = fill(rows, directions, xyz);
      const given = (directions.o ? 1 : 0) + (directions.i ? 2 : 0) + (directions.m ? 4 : 0);
      return results(at, rows, wasm.evaluate(number(about.quantities, name), given));
    });
  }

  function integrate(name, directions, tolerance = 1e-9) {
    return guarded(() => {
      const rows = rowsOf(directions), at = fill(rows, directions, false);
      return results(at, rows, wasm.integrate(number(about.integrals, name), tolerance));
    });
  }

  const ready = (async () => {
    const packed = Uint8Array.from(atob(document.getElementById("module").textContent), (c) => c.charCodeAt(0));
    const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    compiled = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
    start();
    wasm.describe();
    about = JSON.parse(message());
    return about;
  })();

  return { ready, setMaterial, evaluate, integrate, degree };
})();

const byId = (id) => document.getElementById(id);
const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const { degree } = brdfplot;
const luminance = (c) => (c.length === 1 ? c[0] : c[0].map((r, k) => 0.2126 * r + 0.7152 * c[1][k] + 0.0722 * c[2][k]));
const short = (x) => (x === 0 ? "0" : Math.abs(x) >= 1e4 || Math.abs(x) < 1e-3 ? x.toExponential(1) : String(+x.toPrecision(3)));

// Panels -------------------------------------------------------------------------------------------------------------

const panels = {};
function panel(id, title, note) {
  const figure = document.createElement("figure");
  figure.innerHTML = `<h2>${title}</h2><div></div><p>${note}</p>`;
  byId("panels").append(figure);
  panels[id] = figure.querySelector("div");
}

function ticks(low, high) {
  const raw = (high - low) / 4, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((k) => k * power >= raw * 0.999);
  const out = [];
  for (let t = Math.ceil(low / step); t * step <= high * (1 + 1e-9); ++t) out.push(t * step);
  return out;
}

// Curves over degrees: [{name, x, y}]
function plot(id, curves, from, to, xLabel) {
  const [w, h, left, top, right, bottom] = [360, 230, 44, 8, 10, 48];
  let high = Math.max(...curves.flatMap((c) => [...c.y].filter(Number.isFinite)));
  if (!(high > 0)) high = 1;
  high *= 1.04;
  const X = (x) => left + ((x - from) / (to - from)) * (w - left - right);
  const Y = (y) => top + (1 - y / high) * (h - top - bottom);
  let out = `<svg viewBox="0 0 ${w} ${h}" role="img">`;
  for (const t of ticks(0, high))
    out += `<path class="axis" d="M${left} ${Y(t).toFixed(1)}H${w - right}"/><text x="${left - 5}" y="${Y(t) + 4}" text-anchor="end">${short(t)}</text>`;
  for (let t = from; t <= to; t += (to - from) / 6)
    out += `<path class="axis" d="M${X(t).toFixed(1)} ${top}V${h - bottom}"/><text x="${X(t)}" y="${h - bottom + 14}" text-anchor="middle">${t}°</text>`;
  out += `<text x="${(left + w - right) / 2}" y="${h - bottom + 29}" text-anchor="middle">${xLabel}</text>`;
  curves.forEach((c, k) => {
    let path = "", pen = "M";
    c.x.forEach((x, j) => {
      if (!Number.isFinite(c.y[j])) return void (pen = "M");
      path += `${pen}${X(x).toFixed(1)} ${Y(c.y[j]).toFixed(2)}`;
      pen = "L";
    });
    const style = `class="curve" style="stroke:var(--c${k % 4})"${c.dashed ? ' stroke-dasharray="5 5"' : ""}`;
    out += `<path ${style} d="${path}"/>`;
    const at = left + k * ((w - left) / Math.max(curves.length, 2));
    out += `<path ${style} d="M${at} ${h - 8}h16"/><text x="${at + 20}" y="${h - 4}">${c.name}</text>`;
  });
  panels[id].innerHTML = out + "</svg>";
}

function attempt(id, draw) {
  try {
    draw();
  } catch (error) {
    panels[id].innerHTML = `<p>${escaped(error.message)}</p>`;
  }
}

const range = (from, to, n) => Array.from({ length: n }, (_, k) => from + ((to - from) * k) / (n - 1));
const signed = (t) => [Math.abs(t) * degree, t < 0 ? Math.PI : 0]; // in the plane of incidence; o is at phi = pi
const viewer = (t) => [t * degree, Math.PI];

function drawMasking() {
  const x = range(0, 89.5, 180), o = x.map(viewer), m = x.map(() => [0, 0]);
  const curves = [{ name: "G1(θo, normal)", x, y: brdfplot.evaluate("g1", { o, m })[0] }];
  try {
    const lambda = brdfplot.evaluate("lambda", { o })[0];
    curves.push({ name: "1 / (1 + Λ)", dashed: true, x, y: lambda.map((l) => 1 / (1 + l)) });
  } catch { /* a masking function without Λ: the other curve stands alone */ }
  plot("masking", curves, 0, 90, "θo");
}

function drawLambda() {
  const x = range(0, 85, 171);
  plot("lambda", [{ name: "Λ(θo)", x, y: brdfplot.evaluate("lambda", { o: x.map(viewer) })[0] }], 0, 90, "θo");
}

function drawNormals() {
  const x = range(0, 90, 361), m = x.map((t) => [t * degree, 0]);
  plot("normals", [{ name: "D(θm), 1/sr", x, y: brdfplot.evaluate("d", { m })[0] }], 0, 90, "θm");
}

function drawCurves() {
  const x = range(-89.5, 89.5, 359), i = x.map(signed);
  const curves = [0, 30, 60, 80].map((t) => ({
    name: `θo = ${t}°`, x, y: luminance(brdfplot.evaluate("brdf_cos", { o: x.map(() => viewer(t)), i })),
  }));
  plot("curves", curves, -90, 90, "θi, beyond the normal from o");
}

function drawLobe() {
  const theta = +byId("theta").value, x = range(-90, 90, 361);
  const r = luminance(brdfplot.evaluate("brdf_cos", { o: x.map(() => viewer(theta)), i: x.map(signed) }));
  const high = Math.max(...r, 1e-300), [w, h, radius] = [360, 200, 164];
  const at = (t, k) => `${(w / 2 + radius * k * Math.sin(t * degree)).toFixed(1)} ${(h - 16 - radius * k * Math.cos(t * degree)).toFixed(1)}`;
  let out = `<svg viewBox="0 0 ${w} ${h}" role="img">`;
  for (const k of [0.5, 1]) out += `<path class="axis" d="M${at(-90, k)}A${radius * k} ${radius * k} 0 0 1 ${at(90, k)}"/>`;
  for (const t of [-90, -60, -30, 0, 30, 60, 90]) out += `<path class="axis" d="M${at(0, 0)}L${at(t, 1)}"/>`;
  out += `<path class="curve" style="stroke:var(--c1)" stroke-dasharray="4 3" d="M${at(0, 0)}L${at(-theta, 1)}"/>`;
  out += `<path class="curve" style="stroke:var(--c0)" d="${x.map((t, k) => (k ? "L" : "M") + at(t, r[k] / high)).join("")}"/>`;
  panels.lobe.innerHTML = out + `<text x="4" y="12">rim: ${short(high)} 1/sr</text></svg>`;
}

// Viridis (van der Walt and Smith, 2015) at nine places, straight between them.
const ramp = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];
function colour(t) {
  const at = Math.min(Math.max(t, 0), 1) * (ramp.length - 1), k = Math.min(Math.floor(at), ramp.length - 2);
  return ramp[k].map((c, j) => c + (ramp[k + 1][j] - c) * (at - k));
}

function canvas(id, w, h, kind) {
  let one = panels[id].querySelector("canvas");
  if (!one) {
    panels[id].innerHTML = `<canvas class="${kind}" width="${w}" height="${h}"></canvas>`;
    one = panels[id].firstChild;
  }
  return one.getContext("2d");
}

function drawHeat() {
  const n = 90, o = [], i = [];
  for (let row = 0; row < n; ++row)
    for (let column = 0; column < n; ++column) {
      o.push(viewer(((column + 0.5) * 90) / n));
      i.push(signed(((n - row - 0.5) * 90) / n));
    }
  const values = luminance(brdfplot.evaluate("brdf", { o, i }));
  let high = 0;
  for (const v of values) if (Number.isFinite(v) && v > high) high = v;
  const size = 360, margin = 40, side = 270, context = canvas("heat", size, 320, "");
  const image = new ImageData(n, n);
  values.forEach((v, k) => image.data.set([...(v > 0 ? colour(1 + Math.log10(v / high) / 4) : ramp[0]), 255], 4 * k));
  const cells = new OffscreenCanvas(n, n);
  cells.getContext("2d").putImageData(image, 0, 0);
  context.clearRect(0, 0, size, 320);
  context.imageSmoothingEnabled = false;
  context.drawImage(cells, margin, 6, side, side);
  context.fillStyle = getComputedStyle(document.body).color;
  context.font = "11px system-ui, sans-serif";
  for (let t = 0; t <= 90; t += 30) {
    context.fillText(`${t}°`, margin + (t / 90) * side - 6, side + 20);
    context.fillText(`${t}°`, 14, 10 + (1 - t / 90) * side);
  }
  context.fillText("θo", margin + side / 2, side + 36);
  context.fillText("θi", 0, side / 2 + 24);
  for (let k = 0; k < 100; ++k) {
    context.fillStyle = `rgb(${colour(1 - k / 100).map(Math.round)})`;
    context.fillRect(margin + side + 10, 20 + k * 2, 10, 2);
  }
  context.fillStyle = getComputedStyle(document.body).color;
  context.fillText(short(high), margin + side + 10, 14);
  context.fillText(short(high * 1e-4), margin + side + 4, 234);
}

function drawSphere() {
  const n = 128, o = [], i = [], where = [];
  const length = Math.hypot(0.5, 0.6, 0.62), l = [-0.5 / length, 0.6 / length, 0.62 / length];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  for (let row = 0; row < n; ++row)
    for (let column = 0; column < n; ++column) {
      const x = ((column + 0.5) / n) * 2.1 - 1.05, y = 1.05 - ((row + 0.5) / n) * 2.1, z2 = 1 - x * x - y * y;
      if (z2 <= 0) continue;
      const normal = [x, y, Math.sqrt(z2)], across = Math.hypot(normal[2], x) || 1;
      if (dot(l, normal) <= 0) continue;
      const t = [normal[2] / across, 0, -x / across]; // along the circle of latitude
      const b = [normal[1] * t[2] - normal[2] * t[1], normal[2] * t[0] - normal[0] * t[2], normal[0] * t[1] - normal[1] * t[0]];
      o.push([t[2], b[2], normal[2]]);
      i.push([dot(l, t), dot(l, b), dot(l, normal)]);
      where.push(row * n + column);
    }
  const value = brdfplot.evaluate("brdf_cos", { o, i }, true);
  const image = new ImageData(n, n);
  const srgb = (v) => 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
  for (let k = 0; k < n * n; ++k) image.data[4 * k + 3] = 255;
  where.forEach((at, k) => {
    for (let c = 0; c < 3; ++c) image.data[4 * at + c] = srgb(Math.min(1, Math.max(0, Math.PI * value[c % value.length][k])));
  });
  canvas("sphere", n, n, "sphere").putImageData(image, 0, 0);
}

// Integrals take longer: one angle at a time, after everything else.
let round = 0;
function drawAlbedo() {
  const own = ++round, x = [0, 10, 20, 30, 40, 50, 60, 65, 70, 75, 80, 85, 88], y = [];
  panels.albedo.innerHTML = "<p>…</p>";
  const next = () => {
    if (own !== round) return;
    attempt("albedo", () => {
      y.push(luminance(brdfplot.integrate("albedo", { o: [viewer(x[y.length])] }, 1e-6))[0]);
      plot("albedo", [{ name: "albedo", x: x.slice(0, y.length), y }], 0, 90, "θo");
      if (y.length < x.length) setTimeout(next);
    });
  };
  setTimeout(next, 150);
}

function redraw() {
  const start = performance.now();
  attempt("masking", drawMasking);
  attempt("lambda", drawLambda);
  attempt("normals", drawNormals);
  attempt("curves", drawCurves);
  attempt("lobe", drawLobe);
  attempt("heat", drawHeat);
  attempt("sphere", drawSphere);
  brdfplot.milliseconds = performance.now() - start;
  byId("time").textContent = `Redrawn in ${brdfplot.milliseconds.toFixed(0)} ms.`;
  drawAlbedo();
}

// The material ---------------------------------------------------------------------------------------------------------

const roles = ["distribution", "masking", "shadowing", "fresnel"];
let about, current;

function apply(text) {
  try {
    brdfplot.setMaterial(text);
  } catch (error) {
    byId("error").textContent = error.message;
    byId("error").hidden = false;
    return false;
  }
  byId("error").hidden = true;
  current = JSON.parse(text.replace(/^\uFEFF/, ""));
  history.replaceState(null, "", "#" + encodeURIComponent(JSON.stringify(current)));
  redraw();
  return true;
}

function changed() {
  const text = JSON.stringify(current, null, 2);
  byId("json").value = text;
  apply(text);
}

// Where a parameter without a default starts.
function guess(p, isAlternative) {
  if (p.kind === "choice") return p.choices[0];
  if (p.kind === "boolean") return false;
  const low = p.min ?? -Infinity, high = p.max ?? Infinity, wanted = isAlternative || high <= 1 ? 0.5 : 1.5;
  return wanted > low && wanted < high ? wanted : Number.isFinite(low) ? low + 1 : high - 1;
}

const model = (role, type) => about[role].find((one) => one.type === type);
const scalar = (p) => ["number", "number_or_rgb"].includes(p.kind);

function newModel(role, type) {
  const spec = model(role, type), first = spec.alternatives[0] ?? [], some = new Set(spec.alternatives.flat());
  const out = { type };
  for (const p of spec.parameters) {
    const shown = scalar(p) || p.kind === "choice" || p.kind === "boolean";
    if (shown && (first.includes(p.key) || (!some.has(p.key) && p.fallback === undefined))) out[p.key] = guess(p, some.has(p.key));
  }
  return out;
}

function control(role, p) {
  const div = document.createElement("div"), id = `${role}-${p.key}`;
  div.className = "parameter";
  const value = current[role][p.key] ?? p.fallback;
  const set = (v) => { current[role][p.key] = v; changed(); };
  div.innerHTML = `<label for="${id}" title="${escaped(p.doc)}">${escaped(p.key)}</label>`;
  if (p.kind === "choice" || p.kind === "boolean") {
    const choices = p.kind === "choice" ? p.choices : ["false", "true"];
    div.innerHTML += `<select id="${id}">${choices.map((c) => `<option${String(value) === c ? " selected" : ""}>${escaped(c)}</option>`).join("")}</select>`;
    div.lastChild.onchange = (e) => set(p.kind === "choice" ? e.target.value : e.target.value === "true");
    return div;
  }
  // Wide ranges in powers of ten; the number beside takes every value.
  const low = Math.max(p.min ?? -4, -1e3), high = Math.min(p.max ?? Infinity, Math.max(10, 2 * low));
  const powers = low > 0 && (p.max ?? Infinity) / low > 1e3;
  const from = powers ? Math.log10(Math.max(low, 1e-3)) : low, to = powers ? Math.log10(Math.min(high, 10)) : high;
  const shown = (v) => (powers ? Math.log10(v) : v);
  div.innerHTML += `<span class="row"><input type="range" id="${id}" min="${from}" max="${to}" step="${(to - from) / 500}" value="${shown(value)}"><input type="number" step="any" value="${value}" aria-label="${escaped(p.key)}"></span>`;
  const [slider, box] = div.querySelectorAll("input");
  slider.oninput = () => {
    const v = +(powers ? 10 ** slider.value : +slider.value).toPrecision(3);
    box.value = v;
    set(v);
  };
  box.oninput = () => {
    if (box.value === "") return;
    slider.value = shown(+box.value);
    set(+box.value);
  };
  return div;
}

function controls() {
  const root = byId("controls");
  root.replaceChildren();
  if (!current?.distribution || current.terms || (current.type ?? "microfacet") !== "microfacet") {
    root.innerHTML = '<p class="note">The material has terms of its own: it is changed as JSON. <button type="button">Start from GGX</button></p>';
    root.querySelector("button").onclick = () => { current = { distribution: newModel("distribution", "ggx") }; changed(); controls(); };
    return;
  }
  for (const role of roles) {
    const chosen = current[role]?.type ?? "", label = document.createElement("label"), select = document.createElement("select");
    label.textContent = role;
    label.htmlFor = select.id = role;
    const types = about[role].map((one) => one.type);
    if (role !== "distribution") types.unshift("");
    for (const type of types) select.add(new Option(type || "(default)", type, false, type === chosen));
    select.title = chosen ? model(role, chosen)?.doc ?? "" : "";
    select.onchange = () => {
      if (select.value) current[role] = newModel(role, select.value);
      else delete current[role];
      changed();
      controls();
    };
    root.append(label, select);
    const spec = chosen && model(role, chosen);
    if (!spec) continue;
    const some = new Set(spec.alternatives.flat());
    for (const p of spec.parameters) {
      const here = p.key in current[role];
      if (scalar(p) && Array.isArray(current[role][p.key])) continue; // a colour: as JSON
      if ((scalar(p) || p.kind === "choice" || p.kind === "boolean") && (here || (!some.has(p.key) && p.fallback !== undefined)) && typeof (current[role][p.key] ?? p.fallback) !== "object")
        root.append(control(role, p));
    }
  }
}

function fromAddress() {
  let text = '{"distribution": {"type": "ggx", "alpha": 0.3}}';
  if (location.hash.length > 1) {
    try {
      text = decodeURIComponent(location.hash.slice(1));
    } catch { text = location.hash.slice(1); }
  }
  try {
    text = JSON.stringify(JSON.parse(text), null, 2);
  } catch { /* the program says what is wrong with it */ }
  byId("json").value = text;
  apply(text);
  controls();
}

panel("sphere", "Sphere", "lit by one light from the upper left, of radiance such that a white diffuser facing it is white; sRGB");
panel("lobe", "Lobe", "ρ cos θ<sub>i</sub> in the plane of incidence; dashed: towards o");
panel("curves", "BRDF", "ρ cos θ<sub>i</sub> in the plane of incidence, 1/sr; of colours the luminance");
panel("heat", "Heat map", "ρ in the plane of incidence, beyond the normal from o; four decades");
panel("normals", "Normals", "distribution of normals towards φ = 0");
panel("masking", "Masking", "of the microsurface, at its mean normal");
panel("lambda", "Λ", "Smith's auxiliary function");
panel("albedo", "Albedo", "∫ ρ cos θ<sub>i</sub>, by quadrature to 10⁻⁶, at 13 angles");

byId("json").oninput = () => apply(byId("json").value) && controls();
byId("theta").oninput = () => {
  byId("theta-value").textContent = byId("theta").value;
  attempt("lobe", drawLobe);
};
byId("copy").onclick = async () => {
  try {
    await navigator.clipboard.writeText(byId("json").value);
    byId("told").textContent = "Copied.";
  } catch {
    byId("json").select(); // a page of a file may be refused the clipboard
    byId("told").textContent = document.execCommand("copy") ? "Copied." : "Selected: copy it.";
  }
};
window.onhashchange = fromAddress;
matchMedia("(prefers-color-scheme: dark)").onchange = () => current && redraw();
brdfplot.shown = brdfplot.ready.then((described) => {
  about = described;
  byId("version").textContent = about.version;
  fromAddress();
}).catch((error) => {
  byId("error").textContent = `The page cannot start: ${error.message}`;
  byId("error").hidden = false;
});
