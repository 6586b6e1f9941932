// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
'use strict';

// Shows the points of a page with WebGL 2. Each plane is a group of points that is drawn
// by itself, on a lattice of its own; the last group are the points on no plane.

const element = id => document.getElementById(id);
const json = id => JSON.parse(element(id).textContent);
const description = json('description'), groups = json('groups'), planes = description.planes;

const add = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, factor) => a.map(x => x * factor);
const unit = a => scaled(a, 1 / Math.hypot(...a));

// ---- the cloud

function decodedPlaces() {
  const letters = atob(element('places').textContent);
  element('places').textContent = '';
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = letters.charCodeAt(i);
  return new Uint16Array(bytes.buffer);
}

// The box around all points on planes, or around all where there are none: points on no
// plane may lie far away.
function boxAroundPlanes() {
  const shown = groups.filter(group => group.shown > 0);
  const of_planes = shown.filter(group => group !== groups[planes.length]);
  const low = [0, 1, 2].map(() => Infinity), high = low.map(x => -x);
  for (const {origin, step} of of_planes.length ? of_planes : shown)
    for (let axis = 0; axis < 3; ++axis) {
      low[axis] = Math.min(low[axis], origin[axis]);
      high[axis] = Math.max(high[axis], origin[axis] + 65535 * step[axis]);
    }
  return shown.length ? [low, high] : [[0, 0, 0], [1, 1, 1]];
}

const places = decodedPlaces();
const [low, high] = boxAroundPlanes();
// Numbers in single precision are relative to it.
const center = scaled(add(low, high), 0.5);
const radius = Math.max(Math.hypot(...add(high, low, -1)) / 2, 1e-9);
const decimals = Math.min(12, Math.max(3, 4 - Math.floor(Math.log10(radius))));

function median(numbers) {
  return numbers.sort((a, b) => a - b)[numbers.length >> 1];
}

function prepareGroups() {
  const spacing = groups.map((group, i) =>
    i < planes.length && group.shown && planes[i].area > 0 ? Math.sqrt(planes[i].area / group.shown) : 0);
  const usual = median(spacing.filter(x => x > 0)) || radius / 200;
  let first = 0;
  groups.forEach((group, i) => {
    const plane = planes[i];
    group.first = first;
    first += group.shown;
    group.from_center = add(group.origin, center, -1);
    group.spacing = Math.min(spacing[i] || usual, 4 * usual);
    group.color = plane ? [1, 3, 5].map(at => parseInt(plane.color.slice(at, at + 2), 16) / 255) : [0.5, 0.5, 0.5];
    group.normal = plane ? plane.normal : [0, 0, 0];
    group.isOn = true;
  });
  return first;
}

const shownPoints = prepareGroups();

// ---- the camera: it turns about a target around the up axis

const up = unit(description.up);
const east = unit(cross(Math.abs(up[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0], up)), north = cross(up, east);
const lens = 1.6; // focal length in half heights of the picture
const camera = {};

function firstView() {
  Object.assign(camera, {target: [0, 0, 0], distance: 2 * radius, yaw: -1, pitch: 0.6});
}

function cameraFrame() {
  const {yaw, pitch, target, distance} = camera;
  const out = add(scaled(east, Math.cos(yaw)), north, Math.sin(yaw));
  const back = add(scaled(out, Math.cos(pitch)), up, Math.sin(pitch));
  const right = add(scaled(east, -Math.sin(yaw)), north, Math.cos(yaw));
  return {right, above: cross(back, right), back, eye: add(target, back, distance)};
}

// The planes of a room face its inside: from outside the near ones are better left out.
const facing = groups.reduce((sum, group, i) => i < planes.length
  ? sum + Math.sign(dot(planes[i].normal, add(center, planes[i].centroid, -1))) * group.all : sum, 0);

// ---- drawing

const canvas = element('points'), marks = element('marks').getContext('2d');
const gl = canvas.getContext('webgl2', {alpha: true, antialias: true});
if (!gl)
  element('answer').textContent = 'This browser has no WebGL 2, which draws the points; try another one.';

const vertexShader = `#version 300 es
in vec3 place;
uniform vec3 origin, scale, right, above, back, normal;
uniform vec4 view; // lens by width and height, near, pixels of a unit at distance one
uniform vec2 pixels; // smallest and largest side of a point
out float light;
void main() {
  vec3 from_eye = origin + scale * place;
  vec3 p = vec3(dot(right, from_eye), dot(above, from_eye), dot(back, from_eye));
  float depth = -p.z;
  gl_Position = vec4(view.x * p.x, view.y * p.y, depth - 2.0 * view.z, depth);
  gl_PointSize = clamp(view.w / max(depth, view.z), pixels.x, pixels.y);
  light = normal == vec3(0.0) ? 1.0 : 0.65 + 0.35 * abs(dot(normal, normalize(from_eye)));
}`;
const fragmentShader = `#version 300 es
precision mediump float;
uniform vec3 color;
in float light;
out vec4 shown;
void main() { shown = vec4(color * light, 1.0); }`;

function linkedProgram() {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, 0, 'place');
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program));
  return program;
}

function vertexArray(numbers, type, stride) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 3, type, false, stride, 0);
  return array;
}

// Lines of all layers in one buffer: each with its layer and plane, if it is of one.
const lines = {ends: [], parts: []};

function addLines(layer, group, ends) {
  lines.parts.push({layer, group, first: lines.ends.length / 3, count: ends.length});
  for (const end of ends)
    lines.ends.push(...add(end, center, -1));
}

function prepareLines() {
  planes.forEach((plane, i) => {
    const sides = [plane.hull, ...plane.holes].flatMap(ring =>
      ring.flatMap((corner, k) => [corner, ring[(k + 1) % ring.length]]));
    addLines('outlines', i, sides);
    const length = Math.max(0.25 * Math.sqrt(plane.area), radius / 100);
    addLines('normals', i, [plane.centroid, add(plane.centroid, plane.normal, length)]);
  });
  addLines('edges', -1, (description.edges || []).flatMap(edge => [edge.from, edge.to]));
}

let program, uniforms, pointArray, lineArray;

function prepareDrawing() {
  prepareLines();
  program = linkedProgram();
  gl.useProgram(program);
  uniforms = {};
  for (const name of ['origin', 'scale', 'right', 'above', 'back', 'normal', 'view', 'pixels', 'color'])
    uniforms[name] = gl.getUniformLocation(program, name);
  pointArray = vertexArray(places, gl.UNSIGNED_SHORT, 6);
  lineArray = vertexArray(new Float32Array(lines.ends), gl.FLOAT, 12);
  gl.enable(gl.DEPTH_TEST);
}

function isSeen(i, eye) {
  const group = groups[i];
  if (i === planes.length)
    return element('rest').checked;
  return group.isOn && (element('backs').checked ||
    dot(group.normal, add(add(eye, center), planes[i].centroid, -1)) > 0);
}

function resize() {
  const ratio = window.devicePixelRatio || 1;
  for (const one of [canvas, marks.canvas]) {
    const width = Math.round(one.clientWidth * ratio), height = Math.round(one.clientHeight * ratio);
    if (one.width !== width || one.height !== height)
      Object.assign(one, {width, height});
  }
  return ratio;
}

let part = 1; // of each group's points, less while the view moves
const set = (name, numbers) => gl['uniform' + numbers.length + 'fv'](uniforms[name], numbers);

function drawGroup(i, frame, pixelsOfUnit, near, ratio, larger) {
  const group = groups[i], aspect = canvas.height / canvas.width;
  set('origin', add(group.from_center, frame.eye, -1));
  set('scale', group.step);
  set('color', group.color);
  set('normal', group.normal);
  set('view', [lens * aspect, lens, near, 1.4 * larger * group.spacing / Math.sqrt(part) * pixelsOfUnit]);
  set('pixels', [1.5 * ratio * Math.min(larger, 1), 10 * ratio * larger]);
  gl.drawArrays(gl.POINTS, group.first, Math.ceil(part * group.shown));
}

function drawLines(frame) {
  const ink = getComputedStyle(document.body).color.match(/\d+/g).slice(0, 3).map(x => x / 255);
  gl.bindVertexArray(lineArray);
  set('origin', scaled(frame.eye, -1));
  set('scale', [1, 1, 1]);
  set('normal', [0, 0, 0]);
  for (const {layer, group, first, count} of lines.parts)
    if (element(layer).checked && (group < 0 || groups[group].isOn)) {
      set('color', layer === 'normals' ? groups[group].color : ink);
      gl.drawArrays(gl.LINES, first, count);
    }
}

function draw() {
  pending = 0;
  if (!gl)
    return;
  const ratio = resize(), frame = cameraFrame(), near = 0.01 * camera.distance;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  for (const name of ['right', 'above', 'back'])
    set(name, frame[name]);
  gl.bindVertexArray(pointArray);
  groups.forEach((group, i) => {
    if (group.shown && isSeen(i, frame.eye))
      drawGroup(i, frame, lens * canvas.height / 2, near, ratio, 2 ** element('size').value);
  });
  drawLines(frame);
  drawMarks(frame, ratio);
}

let pending = 0, settled = 0;

function redraw() {
  pending = pending || requestAnimationFrame(draw);
}

// A moving view shows an even sample, so that it follows the hand with any graphics card.
function redrawMoving() {
  part = Math.min(1, 600000 / shownPoints);
  clearTimeout(settled);
  settled = setTimeout(() => { part = 1; redraw(); }, 200);
  redraw();
}

// ---- over the points: scale bar, axes, the point that was clicked

let chosen = null; // {point, group, ...} relative to the center

function pixelOf(point, frame) {
  const from_eye = add(point, frame.eye, -1), depth = -dot(frame.back, from_eye);
  const {clientWidth: width, clientHeight: height} = canvas, focal = lens * height / 2;
  return [width / 2 + focal * dot(frame.right, from_eye) / depth,
    height / 2 - focal * dot(frame.above, from_eye) / depth, depth];
}

function drawMarks(frame, ratio) {
  const {clientWidth: width, clientHeight: height} = canvas;
  const line = (...points) => {
    marks.beginPath();
    points.forEach(point => marks.lineTo(...point));
    marks.stroke();
  };
  marks.setTransform(ratio, 0, 0, ratio, 0, 0);
  marks.clearRect(0, 0, width, height);
  marks.strokeStyle = marks.fillStyle = getComputedStyle(document.body).color;
  marks.font = '12px sans-serif';
  // True at the depth of the target, in the middle of the view.
  const pixelsOfUnit = lens * height / 2 / camera.distance, wanted = 160 / pixelsOfUnit;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = power * [5, 2, 1].find(factor => factor * power <= wanted), end = 14 + length * pixelsOfUnit;
  line([14, height - 20], [14, height - 14], [end, height - 14], [end, height - 20]);
  marks.fillText(parseFloat(length.toPrecision(2)) + ' m', 18, height - 20);
  const corner = [width - 55, height - 55];
  [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]], ['up', scaled(up, 1.35)]].forEach(([name, axis]) => {
    const tip = [corner[0] + 30 * dot(frame.right, axis), corner[1] - 30 * dot(frame.above, axis)];
    line(corner, tip);
    marks.fillText(name, tip[0] + 2, tip[1] - 2);
  });
  const at = chosen && pixelOf(chosen, frame);
  if (at && at[2] > 0) {
    marks.beginPath();
    marks.arc(at[0], at[1], 7, 0, 2 * Math.PI);
    marks.stroke();
  }
}

// ---- a click on a point

// The nearest point to the eye of those that are a few pixels from a place.
function pointAt(x, y) {
  const frame = cameraFrame(), reach = 6, near = 0.01 * camera.distance;
  const {clientWidth: width, clientHeight: height} = canvas, focal = lens * height / 2;
  let best = Infinity, found = null;
  groups.forEach((group, i) => {
    if (!group.shown || !isSeen(i, frame.eye))
      return;
    const from_eye = add(group.from_center, frame.eye, -1), axes = [frame.right, frame.above, frame.back];
    const [r, a, b] = axes.map(axis => axis.map((n, k) => n * group.step[k]));
    const [r0, a0, b0] = axes.map(axis => dot(axis, from_eye));
    for (let k = 3 * group.first; k < 3 * (group.first + group.shown); k += 3) {
      const u = places[k], v = places[k + 1], w = places[k + 2];
      const depth = -(b[0] * u + b[1] * v + b[2] * w + b0);
      if (depth < near)
        continue;
      const off = Math.hypot(width / 2 + focal * (r[0] * u + r[1] * v + r[2] * w + r0) / depth - x,
        height / 2 - focal * (a[0] * u + a[1] * v + a[2] * w + a0) / depth - y);
      const farness = depth * (1 + 4 * off / focal);
      if (off <= reach && farness < best) {
        best = farness;
        found = {i, point: add(group.from_center, [u * group.step[0], v * group.step[1], w * group.step[2]])};
      }
    }
  });
  return found;
}

function choose(found) {
  chosen = found && found.point;
  document.querySelectorAll('tr.chosen').forEach(row => row.classList.remove('chosen'));
  if (!found)
    element('answer').textContent = '';
  else {
    const plane = planes[found.i], place = add(found.point, center);
    const at = 'at ' + place.map(x => x.toFixed(decimals)).join(', ');
    if (!plane)
      element('answer').textContent = 'no plane, ' + at;
    else {
      // Places are known to half a step of their lattice.
      const distance = dot(plane.normal, add(place, plane.centroid, -1));
      const error = dot(plane.normal.map(Math.abs), groups[found.i].step) / 2;
      element('answer').textContent = `plane ${plane.id}, ${plane.orientation}, ${at}, ` +
        `distance to the plane ${distance.toPrecision(3)} \u00b1 ${error.toPrecision(1)}`;
      const row = element('rows').children[found.i];
      row.classList.add('chosen');
      row.scrollIntoView({block: 'nearest'});
    }
  }
  redraw();
}

// ---- mouse, pen and fingers

const pointers = new Map();
let travelled = 0;

function pan(dx, dy) {
  const frame = cameraFrame(), unitsOfPixel = camera.distance / (lens * canvas.clientHeight / 2);
  camera.target = add(add(camera.target, frame.right, -dx * unitsOfPixel), frame.above, dy * unitsOfPixel);
}

function zoom(factor) {
  camera.distance = Math.min(Math.max(camera.distance * factor, radius / 5000), 50 * radius);
}

function move(event) {
  const before = pointers.get(event.pointerId);
  if (!before)
    return;
  const now = [event.offsetX, event.offsetY], [dx, dy] = add(now, before, -1);
  travelled += Math.hypot(dx, dy);
  const other = [...pointers.entries()].find(([id]) => id !== event.pointerId);
  if (other) {
    pan(dx / 2, dy / 2);
    zoom(Math.hypot(...add(before, other[1], -1)) / Math.max(1, Math.hypot(...add(now, other[1], -1))));
  }
  else if (event.buttons & 6 || event.shiftKey)
    pan(dx, dy);
  else {
    camera.yaw -= 0.006 * dx;
    camera.pitch = Math.min(Math.max(camera.pitch + 0.006 * dy, -1.57), 1.57);
  }
  pointers.set(event.pointerId, now);
  redrawMoving();
}

function listenToPointers() {
  canvas.addEventListener('pointerdown', event => {
    if (pointers.size === 0)
      travelled = 0;
    pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
    if (event.isTrusted)
      canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', move);
  for (const kind of ['pointerup', 'pointercancel'])
    canvas.addEventListener(kind, event => {
      if (kind === 'pointerup' && pointers.size === 1 && travelled < 5 && event.button === 0)
        choose(pointAt(event.offsetX, event.offsetY));
      pointers.delete(event.pointerId);
    });
  canvas.addEventListener('contextmenu', event => event.preventDefault());
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    zoom(Math.exp(0.001 * event.deltaY * (event.deltaMode ? 30 : 1)));
    redrawMoving();
  }, {passive: false});
}

// ---- the list of planes

function lookAt(i) {
  camera.target = add(planes[i].centroid, center, -1);
  camera.distance = Math.max(2.5 * Math.sqrt(planes[i].area), radius / 100);
  const turned = [east, north, up].map(axis => dot(axis, planes[i].normal));
  if (Math.hypot(turned[0], turned[1]) > 0.3)
    camera.yaw = Math.atan2(turned[1], turned[0]) + 0.4;
  camera.pitch = Math.min(Math.max(Math.asin(Math.min(Math.max(turned[2], -1), 1)), -1.2), 1.2) + 0.2;
  redraw();
}

function rowOf(plane, i) {
  const row = document.createElement('tr'), box = document.createElement('input');
  const swatch = document.createElement('span');
  Object.assign(box, {type: 'checkbox', checked: true, title: 'show plane ' + plane.id});
  box.onclick = event => event.stopPropagation();
  box.onchange = () => { groups[i].isOn = box.checked; redraw(); };
  swatch.className = 'swatch';
  swatch.style.background = plane.color;
  row.insertCell().append(box);
  row.insertCell().append(swatch, `${plane.id} ${plane.orientation}`);
  for (const text of [groups[i].all, plane.area.toPrecision(3), plane.rms.toPrecision(2), plane.slope.toFixed(1) + '\u00b0'])
    row.insertCell().append(text);
  row.onclick = () => lookAt(i);
  return row;
}

function showAll(isOn) {
  groups.forEach((group, i) => { group.isOn = isOn; });
  element('rows').querySelectorAll('input').forEach(box => { box.checked = isOn; });
  redraw();
}

function fillPanel() {
  const all = groups.reduce((sum, group) => sum + group.all, 0);
  document.title = element('title').textContent = description.title;
  element('note').textContent = `${planes.length} planes. ` + (shownPoints === all
    ? `All ${all} points are shown.`
    : `${shownPoints} of ${all} points are shown, an even sample with points of each plane.`) +
    ' Lengths are in the unit of the cloud (m).';
  element('rows').append(...planes.map(rowOf));
  element('backs').checked = facing <= 0;
  element('all').onclick = () => showAll(true);
  element('none').onclick = () => showAll(false);
  element('reset').onclick = () => { firstView(); redraw(); };
  element('layers').addEventListener('input', redraw);
}

firstView();
fillPanel();
if (gl) {
  prepareDrawing();
  listenToPointers();
  canvas.addEventListener('webglcontextlost', event => event.preventDefault());
  canvas.addEventListener('webglcontextrestored', () => { lines.ends = []; lines.parts = []; prepareDrawing(); redraw(); });
  new ResizeObserver(redraw).observe(canvas);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  redraw();
}
