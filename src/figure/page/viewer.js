"use strict";
// One self-contained viewer: several meshes, one camera. No network, no library.
const data = JSON.parse(document.getElementById("data").textContent);
const stage = document.getElementById("stage");
const tip = document.getElementById("tip");
const names = document.getElementById("names");
const DEFAULTS = { az: -60, el: 28, zoom: 1, sx: 0, sy: 0, z: 1, d: 0, top: 0, circles: 1 };
const state = { ...DEFAULTS };

// ---- state in the address ----
function readAddress() {
  for (const part of location.hash.slice(1).split("&")) {
    const [key, value] = part.split("=");
    if (key in DEFAULTS && Number.isFinite(Number(value))) state[key] = Number(value);
  }
}
function writeAddress() {
  const changed = Object.keys(DEFAULTS).filter((k) => state[k] !== DEFAULTS[k]);
  const hash = changed.map((k) => `${k}=${+state[k].toFixed(4)}`).join("&");
  history.replaceState(null, "", hash ? "#" + hash : location.pathname + location.search);
}

// ---- geometry ----
// Each view is centred and scaled to the unit ball before the motion of the sliders.
function prepare(mesh) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const p of mesh.points) for (let i = 0; i < 3; i++) {
    low[i] = Math.min(low[i], p[i]);
    high[i] = Math.max(high[i], p[i]);
  }
  const center = [0, 1, 2].map((i) => (low[i] + high[i]) / 2);
  let radius = 0;
  for (const p of mesh.points) radius = Math.max(radius, Math.hypot(...p.map((x, i) => x - center[i])));
  return { center, scale: radius > 0 ? 1 / radius : 1 };
}
const frames = data.meshes.map(prepare);
const hasOffset = data.meshes.some((m) => m.gauss);

function moved(n) {
  const mesh = data.meshes[n], { center, scale } = frames[n], gauss = mesh.gauss;
  const out = new Float32Array(mesh.points.length * 3);
  mesh.points.forEach((p, i) => {
    const q = gauss ? p.map((x, k) => x + state.d * gauss[i][k]) : p;
    const [x, y, z] = q.map((x, k) => (x - center[k]) * scale);
    out.set([x, y, state.z * (z + state.sx * x + state.sy * y)], 3 * i);
  });
  return out;
}
function camera() {
  const az = (state.az * Math.PI) / 180, el = state.top ? Math.PI / 2 : (state.el * Math.PI) / 180;
  const turn = state.top ? -Math.PI / 2 : az;
  const [c, s] = [Math.cos(turn), Math.sin(turn)], [ce, se] = [Math.cos(el), Math.sin(el)];
  return { right: [-s, c, 0], up: [-se * c, -se * s, ce], towards: [ce * c, ce * s, se] };
}
const dot = (a, p, o) => a[0] * p[o] + a[1] * p[o + 1] + a[2] * p[o + 2];

// The boxes of the views, side by side, in pixels of the page.
function boxes() {
  const [w, h, n] = [stage.clientWidth, stage.clientHeight, data.meshes.length];
  const columns = Math.max(1, Math.min(n, Math.round(Math.sqrt((n * w) / h))));
  const rows = Math.ceil(n / columns);
  return data.meshes.map((_, i) => {
    const [cw, ch] = [w / columns, h / rows];
    const [x, y] = [(i % columns) * cw, Math.floor(i / columns) * ch];
    return { x, y, w: cw, h: ch, unit: 0.44 * state.zoom * Math.min(cw, ch) };
  });
}
function project(points, box, eye) {
  const n = points.length / 3, out = new Float32Array(n * 3);
  for (let i = 0; i < n; i++) {
    out[3 * i] = box.x + box.w / 2 + box.unit * dot(eye.right, points, 3 * i);
    out[3 * i + 1] = box.y + box.h / 2 - box.unit * dot(eye.up, points, 3 * i);
    out[3 * i + 2] = dot(eye.towards, points, 3 * i);
  }
  return out;
}

// ---- colours ----
const LOW = [42, 93, 160], ZERO = [246, 244, 239], HIGH = [185, 58, 44], FRONT = [127, 171, 220], BACK = [227, 181, 124];
const mix = (a, b, t) => a.map((x, i) => x + (b[i] - x) * t);
function faceColor(mesh, f) {
  const v = mesh.values && mesh.values[f];
  if (v === null || v === undefined) return null;
  return mix(ZERO, v < 0 ? LOW : HIGH, Math.min(1, Math.abs(v)));
}

// ---- drawing: WebGL2, or a painter on a plain canvas ----
const canvas = document.createElement("canvas");
stage.append(canvas);
const wantsPainter = location.search.includes("canvas");
const gl = wantsPainter ? null : canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
const paint2d = gl ? null : canvas.getContext("2d");
const overlay = document.createElement("canvas");
stage.append(overlay);
const over = overlay.getContext("2d");

function program(vertex, fragment) {
  const p = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, "#version 300 es\nprecision highp float;\n" + text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(p, shader);
  }
  gl.linkProgram(p);
  return p;
}
let faceProgram, edgeProgram, buffers;
if (gl) {
  // Positions come projected: pixels and depth.
  faceProgram = program(
    "in vec3 at; in vec4 color; uniform vec2 size; uniform vec3 lamp; uniform vec3 eye; in vec3 normal; out vec4 c;" +
    "void main() { gl_Position = vec4(2.0*at.x/size.x-1.0, 1.0-2.0*at.y/size.y, -0.2*at.z, 1.0);" +
    " float len = length(normal); float light = len > 0.0 ? 0.72 + 0.33*abs(dot(lamp, normal))/len : 1.0;" +
    " vec3 side = dot(eye, normal)*sign(normal.z) >= 0.0 ? color.rgb : mix(color.rgb, vec3(0.89,0.71,0.49), color.a);" +
    " c = vec4(side * mix(1.0, light, color.a), 1.0); }",
    "in vec4 c; out vec4 o; void main() { o = c; }");
  edgeProgram = program(
    "in vec3 a; in vec3 b; in vec2 corner; uniform vec2 size; uniform float width;" +
    "void main() { vec2 d = b.xy - a.xy; float l = max(length(d), 1e-3); vec2 n = vec2(-d.y, d.x)/l;" +
    " vec3 p = mix(a, b, corner.x); vec2 q = p.xy + n*corner.y*width*0.5;" +
    " gl_Position = vec4(2.0*q.x/size.x-1.0, 1.0-2.0*q.y/size.y, -0.2*p.z - 0.0006, 1.0); }",
    "uniform vec4 ink; out vec4 o; void main() { o = ink; }");
  buffers = { face: gl.createBuffer(), edge: gl.createBuffer(), corner: gl.createBuffer() };
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers.corner);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([0, -1, 0, 1, 1, -1, 1, 1]), gl.STATIC_DRAW);
}
const edgesOf = data.meshes.map((mesh) => {
  const seen = new Set(), list = [];
  for (const face of mesh.faces) face.forEach((a, i) => {
    const b = face[(i + 1) % face.length], key = a < b ? a * 4294967296 + b : b * 4294967296 + a;
    if (!seen.has(key)) { seen.add(key); list.push(a, b); }
  });
  return list;
});
function areaVector(points, face) {
  const n = [0, 0, 0];
  face.forEach((a, i) => {
    const b = face[(i + 1) % face.length];
    for (let k = 0; k < 3; k++) {
      const u = (k + 1) % 3, v = (k + 2) % 3;
      n[k] += (points[3 * a + u] - points[3 * b + u]) * (points[3 * a + v] + points[3 * b + v]);
    }
  });
  return n;
}
let flat = []; // projected points of each view, for the pointer
function draw() {
  const ratio = window.devicePixelRatio || 1;
  const [w, h] = [stage.clientWidth, stage.clientHeight];
  for (const c of [canvas, overlay]) { c.width = Math.round(w * ratio); c.height = Math.round(h * ratio); }
  const eye = camera(), views = boxes();
  const lamp = [0, 1, 2].map((i) => (eye.towards[i] + 0.7 * eye.up[i] - 0.5 * eye.right[i]) / 1.32);
  const spatial = data.meshes.map((_, n) => moved(n));
  flat = spatial.map((points, n) => project(points, views[n], eye));
  const density = (n) => views[n].unit / Math.sqrt(Math.max(1, data.meshes[n].faces.length));
  if (gl) {
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
  } else {
    paint2d.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint2d.fillStyle = "#fff";
    paint2d.fillRect(0, 0, w, h);
  }
  data.meshes.forEach((mesh, n) => (gl ? drawGl : drawPainter)(mesh, spatial[n], flat[n], density(n), edgesOf[n], eye, lamp, [w, h]));
  over.setTransform(ratio, 0, 0, ratio, 0, 0);
  over.clearRect(0, 0, w, h);
  if (state.top && state.circles) data.meshes.forEach((mesh, n) => drawCircles(mesh, n, views[n]));
  names.replaceChildren(...data.meshes.map((mesh, n) => {
    const div = document.createElement("div");
    div.textContent = mesh.name;
    Object.assign(div.style, { left: views[n].x + "px", width: views[n].w + "px", bottom: h - views[n].y - views[n].h + 8 + "px" });
    return div;
  }));
  stage.dataset.drawn = gl ? "webgl" : "canvas";
}
function drawGl(mesh, points, screen, density, edges, eye, lamp, size) {
  const rows = [];
  mesh.faces.forEach((face, f) => {
    const normal = areaVector(points, face), own = faceColor(mesh, f);
    const color = own ? [...own.map((x) => x / 255), 0] : [...FRONT.map((x) => x / 255), state.top ? 0 : 1];
    for (let i = 1; i + 1 < face.length; i++) for (const v of [face[0], face[i], face[i + 1]])
      rows.push(screen[3 * v], screen[3 * v + 1], screen[3 * v + 2], ...color, ...normal);
  });
  const attribute = (p, name, count, stride, offset, divisor) => {
    const at = gl.getAttribLocation(p, name);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, count, gl.FLOAT, false, stride, offset);
    gl.vertexAttribDivisor(at, divisor);
  };
  const uniform = (p, name) => gl.getUniformLocation(p, name);
  gl.useProgram(faceProgram);
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers.face);
  gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(rows), gl.DYNAMIC_DRAW);
  attribute(faceProgram, "at", 3, 40, 0, 0);
  attribute(faceProgram, "color", 4, 40, 12, 0);
  attribute(faceProgram, "normal", 3, 40, 28, 0);
  gl.uniform2fv(uniform(faceProgram, "size"), size);
  gl.uniform3fv(uniform(faceProgram, "lamp"), lamp);
  gl.uniform3fv(uniform(faceProgram, "eye"), eye.towards);
  gl.drawArrays(gl.TRIANGLES, 0, rows.length / 10);
  const ends = new Float32Array(edges.length * 3);
  edges.forEach((v, i) => ends.set(screen.subarray(3 * v, 3 * v + 3), 3 * i));
  gl.useProgram(edgeProgram);
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers.edge);
  gl.bufferData(gl.ARRAY_BUFFER, ends, gl.DYNAMIC_DRAW);
  attribute(edgeProgram, "a", 3, 24, 0, 1);
  attribute(edgeProgram, "b", 3, 24, 12, 1);
  gl.bindBuffer(gl.ARRAY_BUFFER, buffers.corner);
  attribute(edgeProgram, "corner", 2, 8, 0, 0);
  gl.uniform2fv(uniform(edgeProgram, "size"), size);
  gl.uniform1f(uniform(edgeProgram, "width"), density > 8 ? 1.2 : 0.7);
  const fade = Math.min(1, density / 5);
  const paper = 1 - fade;
  gl.uniform4f(uniform(edgeProgram, "ink"), 0.11 + 0.45 * paper, 0.16 + 0.45 * paper, 0.25 + 0.45 * paper, 1);
  gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, edges.length / 2);
}
function drawPainter(mesh, points, screen, density, edges, eye, lamp) {
  const depth = (face) => face.reduce((sum, v) => sum + screen[3 * v + 2], 0) / face.length;
  const order = mesh.faces.map((face, f) => [depth(face), f]).sort((a, b) => a[0] - b[0]);
  paint2d.lineWidth = density > 8 ? 1 : 0.4;
  paint2d.lineJoin = "round";
  for (const [, f] of order) {
    const face = mesh.faces[f], normal = areaVector(points, face), own = faceColor(mesh, f);
    const length = Math.hypot(...normal) || 1;
    const light = own || state.top ? 1 : 0.72 + (0.33 * Math.abs(dot(lamp, normal, 0))) / length;
    const seen = dot(eye.towards, normal, 0) * Math.sign(normal[2] || 1) >= 0;
    const color = (own || (seen ? FRONT : BACK)).map((x) => Math.min(255, Math.round(x * light)));
    paint2d.beginPath();
    face.forEach((v, i) => paint2d[i ? "lineTo" : "moveTo"](screen[3 * v], screen[3 * v + 1]));
    paint2d.closePath();
    paint2d.fillStyle = `rgb(${color})`;
    paint2d.fill();
    paint2d.strokeStyle = density > 4 ? "#1b2a41" : `rgb(${color})`;
    paint2d.stroke();
  }
}
function drawCircles(mesh, n, box) {
  const { center, scale } = frames[n];
  for (const [circles, color] of [[mesh.circles, "#c43c39"], [mesh.otherCircles, "#2f7d5b"]]) {
    over.strokeStyle = color;
    over.lineWidth = 1;
    for (const [x, y, r] of circles || []) {
      over.beginPath();
      over.arc(box.x + box.w / 2 + box.unit * scale * (x - center[0]), box.y + box.h / 2 - box.unit * scale * (y - center[1]),
        box.unit * scale * Math.abs(r), 0, 2 * Math.PI);
      over.stroke();
    }
  }
}

// ---- the pointer: exact values of the nearest visible vertex, or of the face ----
function inside(face, screen, x, y) {
  let winding = false;
  face.forEach((a, i) => {
    const b = face[(i + 1) % face.length];
    const [ax, ay, bx, by] = [screen[3 * a], screen[3 * a + 1], screen[3 * b], screen[3 * b + 1]];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) winding = !winding;
  });
  return winding;
}
function depthAt(face, screen, x, y) {
  // The plane through the projected corners, by the area vector.
  const n = areaVector(screen, face), v = face[0];
  if (n[2] === 0) return -Infinity;
  return screen[3 * v + 2] - (n[0] * (x - screen[3 * v]) + n[1] * (y - screen[3 * v + 1])) / n[2];
}
function pick(x, y) {
  const views = boxes(), n = views.findIndex((b) => x >= b.x && x < b.x + b.w && y >= b.y && y < b.y + b.h);
  if (n < 0) return null;
  const mesh = data.meshes[n], screen = flat[n];
  let best = -1, nearest = -Infinity;
  mesh.faces.forEach((face, f) => {
    if (!inside(face, screen, x, y)) return;
    const depth = depthAt(face, screen, x, y);
    if (depth > nearest) { nearest = depth; best = f; }
  });
  const near = (v) => Math.hypot(screen[3 * v] - x, screen[3 * v + 1] - y);
  const candidates = best >= 0 ? mesh.faces[best] : mesh.points.map((_, v) => v);
  let vertex = -1, least = 9;
  for (const v of candidates) if (near(v) < least) { least = near(v); vertex = v; }
  return vertex >= 0 ? { n, kind: "vertex", index: vertex } : best >= 0 ? { n, kind: "face", index: best } : null;
}
function tell({ n, kind, index }) {
  const mesh = data.meshes[n], lines = [`${mesh.name}: ${kind} ${index}`];
  if (kind === "vertex") ["x", "y", "z"].forEach((name, k) => lines.push(`${name} = ${mesh.exact[index][k]}`));
  for (const [name, values] of Object.entries((mesh.data || {})[kind] || {})) lines.push(`${name} = ${values[index]}`);
  return lines.join("\n");
}
function hover(x, y) {
  const hit = pick(x, y);
  tip.style.display = hit ? "block" : "none";
  if (!hit) return;
  tip.textContent = tell(hit);
  const [w, h] = [stage.clientWidth, stage.clientHeight];
  tip.style.left = Math.min(x + 14, w - tip.offsetWidth - 6) + "px";
  tip.style.top = Math.min(y + 14, h - tip.offsetHeight - 6) + "px";
}

// ---- controls ----
let pending = false;
function redraw() {
  writeAddress();
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => { pending = false; draw(); });
}
const panel = document.getElementById("panel");
function slider(key, label, low, high) {
  const row = document.createElement("label"), name = document.createElement("span"), input = document.createElement("input");
  name.textContent = label;
  Object.assign(input, { type: "range", min: low, max: high, step: (high - low) / 400, value: state[key], title: label });
  input.oninput = () => { state[key] = Number(input.value); redraw(); };
  input.ondblclick = () => { state[key] = DEFAULTS[key]; input.value = state[key]; redraw(); };
  row.append(name, input);
  panel.append(row);
}
function button(label, act) {
  const b = document.createElement("button");
  b.textContent = label;
  b.onclick = act;
  panel.append(b);
}
readAddress();
slider("sx", "shear x", -2, 2);
slider("sy", "shear y", -2, 2);
slider("z", "height", 0, 4);
if (hasOffset) slider("d", "offset d", -2, 2);
button("top view", () => { state.top = state.top ? 0 : 1; redraw(); });
if (data.meshes.some((m) => m.circles)) button("circles", () => { state.circles = state.circles ? 0 : 1; redraw(); });
button("reset", () => { Object.assign(state, DEFAULTS); panel.querySelectorAll("input").forEach((i) => { i.value = i.title === "height" ? 1 : 0; }); redraw(); });
button("save picture", () => {
  const sheet = document.createElement("canvas");
  [sheet.width, sheet.height] = [canvas.width, canvas.height];
  const pen = sheet.getContext("2d");
  pen.drawImage(canvas, 0, 0);
  pen.drawImage(overlay, 0, 0);
  const link = document.createElement("a");
  link.download = (data.title || "isogeo").replace(/[^\w-]+/g, "-") + ".png";
  link.href = sheet.toDataURL("image/png");
  link.click();
});
let held = null;
stage.addEventListener("pointerdown", (e) => { held = [e.clientX, e.clientY]; tip.style.display = "none"; });
addEventListener("pointerup", () => { held = null; });
stage.addEventListener("pointermove", (e) => {
  if (!held) return hover(e.clientX, e.clientY);
  if (state.top) state.top = 0;
  state.az -= 0.4 * (e.clientX - held[0]);
  state.el = Math.max(-90, Math.min(90, state.el + 0.4 * (e.clientY - held[1])));
  held = [e.clientX, e.clientY];
  redraw();
});
stage.addEventListener("wheel", (e) => {
  e.preventDefault();
  state.zoom = Math.max(0.2, Math.min(40, state.zoom * Math.exp(-0.0012 * e.deltaY)));
  redraw();
}, { passive: false });
addEventListener("resize", redraw);
addEventListener("hashchange", () => { Object.assign(state, DEFAULTS); readAddress(); redraw(); });
draw();
