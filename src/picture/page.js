"use strict";
// The complex in ℝⁿ is turned in planes that hold an axis beyond the third, projected to ℝ³ in perspective, turned there, drawn.
const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");
const dimension = SCENE.points.length ? SCENE.points[0].length : 3;
const view = { yaw: 0.56, pitch: 0.37, zoom: 1, shrink: 0.7, turns: new Array(Math.max(0, dimension - 3)).fill(0), spinning: false };
const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;

function projected(p) {
  const q = p.slice();
  for (let k = dimension - 1; k >= 3; k--) {
    const i = (k - 3) % 3, t = view.turns[k - 3], a = q[i], b = q[k];
    q[i] = Math.cos(t) * a - Math.sin(t) * b;
    const w = Math.sin(t) * a + Math.cos(t) * b, f = 1.7 / (1.7 - w);
    for (let j = 0; j < k; j++) q[j] *= f;
  }
  const cy = Math.cos(view.yaw), sy = Math.sin(view.yaw), cp = Math.cos(view.pitch), sp = Math.sin(view.pitch);
  const x = cy * q[0] - sy * q[2], z = sy * q[0] + cy * q[2];
  return [x, cp * q[1] - sp * z, sp * q[1] + cp * z];
}

const EYE = 4, LIGHT = [-0.408, 0.510, 0.757];
const FACES = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

function shade(colour, brightness) {
  const lit = c => Math.round(brightness <= 1 ? c * brightness : c + (255 - c) * Math.min(1, brightness - 1));
  return `rgb(${lit(colour[0])},${lit(colour[1])},${lit(colour[2])})`;
}

function draw() {
  const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const seen = SCENE.points.map(projected);
  let reach = 1e-9;
  for (const p of seen) reach = Math.max(reach, Math.hypot(...p));
  for (const p of seen) for (let i = 0; i < 3; i++) p[i] /= reach;
  const radius = 0.46 * Math.min(width, height) * view.zoom;
  const scale = p => EYE / (EYE - p[2]);
  const place = p => [width / 2 + radius * p[0] * scale(p), height / 2 - radius * p[1] * scale(p)];
  const fog = depth => Math.max(0.3, Math.min(1, 0.72 + 0.3 * depth));
  const stroke = getComputedStyle(document.documentElement).getPropertyValue("--stroke");
  const items = SCENE.tetrahedra.map((t, i) => ({ depth: t.reduce((s, v) => s + seen[v][2], 0) / 4, tetrahedron: i }));
  for (const [a, b] of SCENE.lines) items.push({ depth: (seen[a][2] + seen[b][2]) / 2, line: [a, b] });
  items.sort((a, b) => a.depth - b.depth);
  pen.lineJoin = pen.lineCap = "round";
  for (const item of items) {
    pen.globalAlpha = fog(item.depth);
    if (item.line) {
      const [a, b] = item.line.map(v => seen[v]), [p, q] = [place(a), place(b)];
      pen.strokeStyle = stroke;
      pen.lineWidth = 2.2 * scale(a);
      pen.beginPath(); pen.moveTo(...p); pen.lineTo(...q); pen.stroke();
      continue;
    }
    const whole = SCENE.tetrahedra[item.tetrahedron].map(v => seen[v]);
    const middle = [0, 1, 2].map(i => (whole[0][i] + whole[1][i] + whole[2][i] + whole[3][i]) / 4);
    const c = whole.map(p => p.map((x, i) => middle[i] + view.shrink * (x - middle[i])));
    const d = c.slice(1).map(p => p.map((x, i) => x - c[0][i]));
    const volume = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0])
      + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    const colour = SCENE.colours[SCENE.groups[item.tetrahedron] % SCENE.colours.length];
    for (const face of FACES) {
      const [p, q, r] = volume >= 0 ? face.map(i => c[i]) : [c[face[0]], c[face[2]], c[face[1]]];
      const u = q.map((x, i) => x - p[i]), v = r.map((x, i) => x - p[i]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const length = Math.hypot(...n);
      if (length < 1e-12 || n[2] * EYE - (n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) <= 0) continue;
      const brightness = 0.62 + 0.48 * (n[0] * LIGHT[0] + n[1] * LIGHT[1] + n[2] * LIGHT[2]) / length;
      pen.fillStyle = shade(colour, brightness);
      pen.strokeStyle = shade(colour, 0.62 * brightness);
      pen.lineWidth = 0.6;
      pen.beginPath();
      pen.moveTo(...place(p)); pen.lineTo(...place(q)); pen.lineTo(...place(r)); pen.closePath();
      pen.fill(); pen.stroke();
    }
  }
  pen.globalAlpha = 1;
}

let waiting = false;
function redraw() {
  if (!waiting) { waiting = true; requestAnimationFrame(() => { waiting = false; draw(); }); }
}

const controls = document.querySelector(".controls");
function slider(name, min, max, value, change) {
  const label = document.createElement("label"), input = document.createElement("input");
  Object.assign(input, { type: "range", min, max, step: (max - min) / 400, value });
  input.addEventListener("input", () => { change(Number(input.value)); redraw(); });
  label.append(name, input);
  controls.append(label);
  return input;
}
const button = document.createElement("button");
button.type = "button";
function spin(on) { view.spinning = on; button.textContent = on ? "Stop" : "Turn"; if (on) requestAnimationFrame(step); }
button.addEventListener("click", () => spin(!view.spinning));
controls.append(button);
slider("Size of the tetrahedra", 0.1, 1, view.shrink, x => { view.shrink = x; });
const planes = view.turns.map((_, k) =>
  slider(`Turn of axes ${(k % 3) + 1} and ${k + 4}`, -Math.PI, Math.PI, 0, x => { view.turns[k] = x; }));

let last = 0;
function step(time) {
  if (!view.spinning) return;
  const seconds = Math.min(0.1, (time - last) / 1000);
  last = time;
  view.yaw += 0.35 * seconds;
  if (planes.length) {
    view.turns[0] += 0.25 * seconds;
    if (view.turns[0] > Math.PI) view.turns[0] -= 2 * Math.PI;
    planes[0].value = view.turns[0];
  }
  draw();
  requestAnimationFrame(step);
}
canvas.addEventListener("pointerdown", e => canvas.setPointerCapture(e.pointerId));
canvas.addEventListener("pointermove", e => {
  if (!e.buttons) return;
  view.yaw += e.movementX * 0.008;
  view.pitch = Math.max(-1.57, Math.min(1.57, view.pitch + e.movementY * 0.008));
  redraw();
});
canvas.addEventListener("wheel", e => {
  e.preventDefault();
  view.zoom = Math.max(0.3, Math.min(6, view.zoom * Math.exp(-e.deltaY * 0.0012)));
  redraw();
}, { passive: false });
canvas.addEventListener("keydown", e => {
  const turn = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
  if (!turn) return;
  e.preventDefault();
  view.yaw += turn[0];
  view.pitch += turn[1];
  redraw();
});
addEventListener("resize", redraw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
draw();
spin(!calm && SCENE.tetrahedra.length <= 2000);
