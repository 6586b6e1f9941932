// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
'use strict';
// Shows the points of a page with WebGL 2. There is a group of points for each plane, with the
// index of the plane, then one for the points on no plane. Each group is drawn by itself and has
// a lattice of its own. page.h describes the data. Factors and limits whose reason is not given are
// chosen by eye: they change only how the page looks and how fast it moves.

const element = id => document.getElementById(id);
const json = id => JSON.parse(element(id).textContent);
const description = json('description'), groups = json('groups'), planes = description.planes;

// Vectors are arrays of numbers. add returns a + factor * b.
const add = (a, b, factor = 1) => a.map((x, i) => x + factor * b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, factor) => a.map(x => x * factor);
const distanceBetween = (a, b) => Math.hypot(...add(a, b, -1));
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const shortText = (x, digits) => String(parseFloat(x.toPrecision(digits))); // without zeros at the end

// ---- the cloud

// Returns the numbers of steps of all points along x, y and z of the lattice of their group: a
// point is at origin + step * these numbers.
function decodedSteps() {
  const letters = atob(element('steps').textContent), bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i)
    bytes[i] = letters.charCodeAt(i);
  element('steps').remove();
  return new Uint16Array(bytes.buffer);
}

// Returns the middle and half the diagonal (or 1, if this is 0) of the bounding box of all points
// on planes. Points on no plane may lie far away: they count only if no point is on a plane.
function middleAndRadius() {
  const maxSteps = 65535;
  const withPoints = groups.filter(group => group.shown), ofPlanes = withPoints.filter(group => group !== groups[planes.length]);
  if (!withPoints.length)
    return [[0, 0, 0], 1];
  let low = [Infinity, Infinity, Infinity], high = scaled(low, -1);
  for (const {origin, step} of ofPlanes.length ? ofPlanes : withPoints) {
    low = low.map((x, axis) => Math.min(x, origin[axis]));
    high = high.map((x, axis) => Math.max(x, origin[axis] + maxSteps * step[axis]));
  }
  return [scaled(add(low, high), 0.5), distanceBetween(high, low) / 2 || 1];
}

const steps = decodedSteps();
const [middle, radius] = middleAndRadius(); // all drawn positions are relative to the middle
const decimals = clamp(4 - Math.floor(Math.log10(radius)), 3, 12); // of coordinates: so many that the radius has five digits or more

// Adds to each group what drawing needs:
//   first       index of its first point among all points of the page
//   isOn        whether the box in its row is checked
//   isListed    whether the filter lets it pass
//   fromMiddle  its origin, relative to the middle
//   color       red, green and blue from 0 to 1
//   normal      of its plane; zero for no plane
//   spacing     distance between neighboring points
// Returns how many points are on the page.
function prepareGroups() {
  const spacings = planes.map((plane, i) => Math.sqrt(plane.area / groups[i].shown) || 0);
  const knownSpacings = spacings.filter(x => x > 0).sort((a, b) => a - b);
  const medianSpacing = knownSpacings[knownSpacings.length >> 1] || radius / 200;
  let first = 0;
  groups.forEach((group, i) => {
    const isPlane = i < planes.length, gray = 0.5;
    const color = [1, 3, 5].map(at => isPlane ? parseInt(planes[i].color.slice(at, at + 2), 16) / 255 : gray); // of #rrggbb
    Object.assign(group, {first, isOn: true, isListed: true, fromMiddle: add(group.origin, middle, -1), color,
      normal: isPlane ? planes[i].normal : [0, 0, 0], spacing: Math.min(spacings[i] || medianSpacing, 4 * medianSpacing)});
    first += group.shown;
  });
  return first;
}

const shownPoints = prepareGroups();

// ---- the camera: it looks at a target, and turns around it

const {up} = description, lens = 1.6; // focal length in half heights of the picture
const level = cross(Math.abs(up[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0], up);
const east = scaled(level, 1 / Math.hypot(...level)), north = cross(up, east); // unit vectors perpendicular to up
// The target, relative to the middle, the distance from it to the eye, and the yaw around up and the
// pitch above the horizontal of the direction from the target to the eye [rad].
let camera;

// Turns the camera to a target. The direction is the unit vector from the target to the eye.
function look(target, direction, distance) {
  camera = {target, distance, yaw: Math.atan2(dot(direction, north), dot(direction, east)),
    pitch: Math.asin(clamp(dot(direction, up), -1, 1))};
  redraw();
}

// A sphere of this radius just fits into a square picture at a distance of 1.89 radii; few clouds fill
// the corners of their box, so that the distance is a little less.
function lookAtAll() {
  look([0, 0, 0], description.view, 1.8 * radius * Math.max(1, canvas.clientHeight / canvas.clientWidth));
}

// Returns the position of the eye, relative to the middle, and unit vectors along the axes of the
// picture: right, above, and back, from the target to the eye.
function cameraFrame() {
  const {yaw, pitch, target, distance} = camera;
  const levelBack = add(scaled(east, Math.cos(yaw)), north, Math.sin(yaw));
  const back = add(scaled(levelBack, Math.cos(pitch)), up, Math.sin(pitch));
  const right = add(scaled(east, -Math.sin(yaw)), north, Math.cos(yaw));
  return {right, above: cross(back, right), back, eye: add(target, back, distance)};
}

// Points nearer to the eye are neither drawn nor clicked.
function nearDistance() {
  return 0.01 * camera.distance;
}

// ---- drawing

const canvas = element('points'), marks = element('marks').getContext('2d');
const gl = canvas.getContext('webgl2'), uniforms = {};
let program, pointArray, lineArray;
let pendingFrame = 0; // number of the frame that was requested; 0 for none
let settleTimer = 0; // runs while the view moves and for a short time after it
let drawnShare = 1; // share of the points of each group that is drawn; less than 1 while the view moves

const vertexShader = `#version 300 es
in vec3 steps; // of a point; for lines a position relative to the middle, with a scale of 1
uniform vec3 origin, scale, right, above, back, normal; // the origin is relative to the eye
uniform vec4 view; // lens * height / width, lens, near distance, side of a point in pixels at a depth of 1
uniform vec2 pixels; // smallest and largest side of a point
out float light; // factor of the color
void main() {
  vec3 ray = origin + scale * steps; // from the eye
  float depth = -dot(back, ray);
  // z / w is -1 at the near distance and goes to 1 far away: nothing far away is cut off.
  gl_Position = vec4(view.x * dot(right, ray), view.y * dot(above, ray), depth - 2.0 * view.z, depth);
  gl_PointSize = clamp(view.w / max(depth, view.z), pixels.x, pixels.y);
  light = normal == vec3(0.0) ? 1.0 : 0.65 + 0.35 * abs(dot(normal, normalize(ray)));
}`;
const fragmentShader = `#version 300 es
precision mediump float;
uniform vec3 color;
in float light;
out vec4 shown;
void main() { shown = vec4(color * light, 1.0); }`;

function setUniform(name, numbers) {
  uniforms[name] = uniforms[name] || gl.getUniformLocation(program, name);
  gl['uniform' + numbers.length + 'fv'](uniforms[name], numbers);
}

// Returns a vertex array in which each vertex has three numbers of a type. The stride is the number
// of bytes of a vertex.
function vertexArray(numbers, type, stride) {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(0);
  gl.vertexAttribPointer(0, 3, type, false, stride, 0);
  return array;
}

// The lines of all layers: of each line both ends, of each end three coordinates relative to the
// middle. A part has consecutive lines of a layer and a group.
const lines = {ends: [], parts: []};

// Adds lines with the ends ends[0] and ends[1], ends[2] and ends[3], and so on. The group is null for
// lines of no group.
function addLines(layer, group, ends) {
  lines.parts.push({layer, group, first: lines.ends.length / 3, count: ends.length});
  for (const end of ends)
    lines.ends.push(...add(end, middle, -1));
}

function prepareDrawing() {
  planes.forEach((plane, i) => {
    const normalLength = Math.max(0.25 * Math.sqrt(plane.area), radius / 100);
    addLines('normals', groups[i], [plane.centroid, add(plane.centroid, plane.normal, normalLength)]);
    for (const ring of [plane.hull, ...plane.holes, ...(plane.parts || []).flat()])
      addLines('outlines', groups[i], ring.flatMap((corner, k) => [corner, ring[(k + 1) % ring.length]]));
  });
  addLines('edges', null, description.edges.flatMap(edge => [edge.from, edge.to]));
  program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.bindAttribLocation(program, 0, 'steps');
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  pointArray = vertexArray(steps, gl.UNSIGNED_SHORT, 6);
  lineArray = vertexArray(new Float32Array(lines.ends), gl.FLOAT, 12);
}

// Returns whether the group with index i is drawn for an eye.
function isSeen(i, {eye}) {
  if (i === planes.length)
    return element('rest').checked;
  const isFromFront = dot(planes[i].normal, add(add(eye, middle), planes[i].centroid, -1)) > 0;
  return groups[i].isOn && groups[i].isListed && (isFromFront || element('backs').checked);
}

// Points are squares a little larger than the spacing (overlap), so that surfaces look closed. They are
// not drawn nearer to the eye than near. The ratio is that of pixels of the screen to those of the page.
function drawPoints(frame, near, ratio) {
  const overlap = 1.4, minSide = 1.5, maxSide = 10; // sides of points: in spacings, and bounds in pixels of the page
  const factor = 2 ** element('size').value, aspect = canvas.height / canvas.width;
  const pixelsOfUnit = overlap * factor / Math.sqrt(drawnShare) * lens * canvas.height / 2; // at a depth of 1
  gl.bindVertexArray(pointArray);
  setUniform('pixels', [minSide * ratio * Math.min(factor, 1), maxSide * ratio * factor]);
  groups.forEach((group, i) => {
    if (!group.shown || !isSeen(i, frame))
      return;
    setUniform('origin', add(group.fromMiddle, frame.eye, -1));
    setUniform('scale', group.step);
    setUniform('color', group.color);
    setUniform('normal', group.normal);
    setUniform('view', [lens * aspect, lens, near, pixelsOfUnit * group.spacing]);
    gl.drawArrays(gl.POINTS, group.first, Math.ceil(drawnShare * group.shown));
  });
}

// The ink is the color of texts and lines, "rgb(red, green, blue)".
function drawLines(frame, ink) {
  gl.bindVertexArray(lineArray);
  setUniform('origin', scaled(frame.eye, -1));
  setUniform('scale', [1, 1, 1]);
  setUniform('normal', [0, 0, 0]);
  for (const {layer, group, first, count} of lines.parts)
    if (element(layer).checked && (!group || group.isOn && group.isListed)) {
      setUniform('color', layer === 'normals' ? group.color : ink.match(/\d+/g).slice(0, 3).map(x => x / 255));
      gl.drawArrays(gl.LINES, first, count);
    }
}

function draw() {
  pendingFrame = 0;
  const ratio = window.devicePixelRatio || 1, frame = cameraFrame(), near = nearDistance();
  for (const surface of [canvas, marks.canvas]) {
    const width = Math.round(surface.clientWidth * ratio), height = Math.round(surface.clientHeight * ratio);
    if (surface.width !== width || surface.height !== height) // setting them clears the canvas
      Object.assign(surface, {width, height});
  }
  const ink = getComputedStyle(document.body).color;
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT); // with nothing: the page is behind it
  for (const axis of ['right', 'above', 'back'])
    setUniform(axis, frame[axis]);
  drawPoints(frame, near, ratio);
  drawLines(frame, ink);
  drawMarks(frame, ratio, ink);
}

function redraw() {
  if (gl)
    pendingFrame = pendingFrame || requestAnimationFrame(draw);
}

// While the view moves, only an even sample of the points is drawn, so that the view follows the hand
// with any graphics card.
function redrawMoving() {
  const maxPoints = 600000, pause = 200; // [ms] without motion, after which all points are drawn
  drawnShare = Math.min(1, maxPoints / shownPoints);
  clearTimeout(settleTimer);
  settleTimer = setTimeout(() => { drawnShare = 1; redraw(); }, pause);
  redraw();
}

// ---- over the points: scale bar, axes, the point that was clicked

// The last point that was clicked, and the one before, relative to the middle.
let chosen = null, chosenBefore = null;

// Positions in the picture and lengths with [pixel] are in pixels of the page, other lengths in the
// unit of the cloud.
function drawMarks(frame, ratio, ink) {
  const {clientWidth: width, clientHeight: height} = canvas, focal = lens * height / 2; // [pixel]
  const line = points => {
    marks.beginPath();
    points.forEach(point => marks.lineTo(...point));
    marks.stroke();
  };
  marks.setTransform(ratio, 0, 0, ratio, 0, 0);
  marks.clearRect(0, 0, width, height);
  marks.strokeStyle = marks.fillStyle = ink;
  marks.font = '12px sans-serif';
  // A scale bar of 1, 2 or 5 times a power of ten [unit of the cloud], true at the depth of the target.
  const maxWidth = 160, margin = 14, tick = 6; // [pixel]
  const maxLength = maxWidth * camera.distance / focal, power = 10 ** Math.floor(Math.log10(maxLength));
  const length = power * [5, 2, 1].find(factor => factor * power <= maxLength);
  const end = margin + length * focal / camera.distance, bottom = height - margin, top = bottom - tick;
  line([[margin, top], [margin, bottom], [end, bottom], [end, top]]);
  marks.fillText(shortText(length, 2) + ' m', margin + 4, top);
  // The axes x, y and z of the cloud, and a longer one up, as the camera sees them.
  const origin = [width - 55, height - 55], axisLength = 30; // [pixel]
  for (const [name, axis] of [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]], ['up', scaled(up, 1.5)]]) {
    const tip = [origin[0] + axisLength * dot(frame.right, axis), origin[1] - axisLength * dot(frame.above, axis)];
    line([origin, tip]);
    marks.fillText(name, tip[0] + 2, tip[1] - 2);
  }
  // The pixel of a point; null behind the eye.
  const onScreen = point => {
    const ray = add(point, frame.eye, -1), depth = -dot(frame.back, ray), scale = focal / depth;
    return depth > 0 ? [width / 2 + scale * dot(frame.right, ray), height / 2 - scale * dot(frame.above, ray)] : null;
  };
  const chosenPixels = [chosenBefore, chosen].map(point => point && onScreen(point)).filter(pixel => pixel);
  for (const [x, y] of chosenPixels) {
    marks.beginPath();
    marks.arc(x, y, 7, 0, 2 * Math.PI);
    marks.stroke();
  }
  if (chosenPixels.length === 2)
    line(chosenPixels);
}

// ---- a click on a point

// Of the points that are a few pixels or less from the pixel (x, y), returns the one nearest to the eye
// and the index of its group; null if there is none. A point counts as farther away, the more pixels it
// is from (x, y).
function pointAt(x, y) {
  const {clientWidth: width, clientHeight: height} = canvas, focal = lens * height / 2, reach = 6; // [pixel]
  const frame = cameraFrame(), axes = [frame.right, frame.above, frame.back];
  let nearest = Infinity, found = null;
  groups.forEach((group, i) => {
    if (!group.shown || !isSeen(i, frame))
      return;
    // Along the axes right (r), above (a) and back (b): the lengths of one step along x, y and z, and
    // the coordinate of the origin of the group. Written out below, as the loop runs over all points.
    const [r, a, b] = axes.map(axis => axis.map((n, k) => n * group.step[k]));
    const [r0, a0, b0] = axes.map(axis => dot(axis, add(group.fromMiddle, frame.eye, -1)));
    for (let k = 3 * group.first; k < 3 * (group.first + group.shown); k += 3) {
      const u = steps[k], v = steps[k + 1], w = steps[k + 2];
      const depth = -(b[0] * u + b[1] * v + b[2] * w + b0);
      const across = width / 2 + focal * (r[0] * u + r[1] * v + r[2] * w + r0) / depth - x; // [pixel] from (x, y)
      const down = height / 2 - focal * (a[0] * u + a[1] * v + a[2] * w + a0) / depth - y;
      const pixelsAway = Math.hypot(across, down), farness = depth * (1 + 4 * pixelsAway / focal);
      if (pixelsAway <= reach && depth > nearDistance() && farness < nearest) {
        nearest = farness;
        found = {i, point: add(group.fromMiddle, [u * group.step[0], v * group.step[1], w * group.step[2]])};
      }
    }
  });
  return found;
}

// Returns the kind of a plane, as "wall"; its orientation if it has no kind or the kind "other".
function nameOf(plane) {
  return plane.kind && plane.kind !== 'other' ? plane.kind : plane.orientation;
}

// Returns what the list tells of the plane with index i, as a sentence.
function factsOf(i) {
  const {id, area, rms, slope} = planes[i];
  return `plane ${id}, ${nameOf(planes[i])}: ${groups[i].all} points, area ${shortText(area, 3)}, rms ${shortText(rms, 2)}, ` +
    `slope ${slope.toFixed(1)}`;
}

// Returns what is known of a point that pointAt found.
function answer({i, point}) {
  const plane = planes[i], position = add(point, middle);
  let text = `${plane ? factsOf(i) : 'no plane'}; at ${position.map(x => x.toFixed(decimals)).join(', ')}`;
  if (plane) {
    // Rounding to the lattice moved the point by half a step at most along each axis.
    const distance = dot(plane.normal, add(position, plane.centroid, -1));
    const error = dot(plane.normal.map(Math.abs), groups[i].step) / 2;
    text += `, distance to the plane ${shortText(distance, 3)} \u00b1 ${shortText(error, 1)}`;
  }
  if (chosenBefore)
    text += `; ${distanceBetween(point, chosenBefore).toFixed(decimals)} from the point before`;
  return text;
}

// Marks the row of the plane with index i in the list; no row if i is the index of the group of no plane.
function markRow(i) {
  for (const row of document.querySelectorAll('tr.chosen'))
    row.classList.remove('chosen');
  if (planes[i]) {
    element('rows').children[i].classList.add('chosen');
    element('rows').children[i].scrollIntoView({block: 'nearest'});
  }
  redraw();
}

// Chooses what pointAt has found: a point with its group, or null.
function choose(found) {
  chosenBefore = found && chosen;
  chosen = found && found.point;
  element('answer').textContent = found ? answer(found) : '';
  markRow(found ? found.i : planes.length);
}

// Chooses the plane with index i and looks at it from its front.
function choosePlane(i) {
  const {centroid, normal, area} = planes[i];
  chosenBefore = chosen = null;
  element('answer').textContent = factsOf(i);
  markRow(i);
  look(add(centroid, middle, -1), normal, Math.max(2 * Math.sqrt(area), radius / 50));
}

// ---- mouse, pen and fingers

const pointers = new Map(); // from the id of each pointer that is down to its last pixel
let traveled = 0; // [pixel] by all pointers since the first one went down

// Returns the pixel of an event relative to the canvas, even if the event is beside the canvas, where a
// drag may end.
function pixelOf(event) {
  const {left, top} = canvas.getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

// Moves the target so that the picture moves by (dx, dy) pixels at the depth of the target.
function pan(dx, dy) {
  const frame = cameraFrame(), unitsOfPixel = camera.distance / (lens * canvas.clientHeight / 2);
  camera.target = add(add(camera.target, frame.right, -dx * unitsOfPixel), frame.above, dy * unitsOfPixel);
}

function zoom(factor) {
  camera.distance = clamp(camera.distance * factor, radius / 5000, 50 * radius);
}

function move(event) {
  const before = pointers.get(event.pointerId);
  if (!before)
    return;
  const now = pixelOf(event), [dx, dy] = add(now, before, -1);
  const [, otherPixel] = [...pointers.entries()].find(([id]) => id !== event.pointerId) || [];
  traveled += Math.hypot(dx, dy);
  if (otherPixel) { // each of two fingers moves the picture by half its way
    pan(dx / 2, dy / 2);
    zoom(distanceBetween(before, otherPixel) / Math.max(1, distanceBetween(now, otherPixel)));
  }
  else if (event.buttons & 6 || event.shiftKey) // right or middle button
    pan(dx, dy);
  else {
    const anglePerPixel = 0.006, maxPitch = 1.57; // [rad], almost a quarter turn
    camera.yaw -= anglePerPixel * dx;
    camera.pitch = clamp(camera.pitch + anglePerPixel * dy, -maxPitch, maxPitch);
  }
  pointers.set(event.pointerId, now);
  redrawMoving();
}

function release(event) {
  const maxTravelOfClick = 5; // [pixel]
  if (event.type === 'pointerup' && pointers.size === 1 && traveled < maxTravelOfClick && event.button === 0)
    choose(pointAt(...pixelOf(event)));
  pointers.delete(event.pointerId);
}

function press(event) {
  if (pointers.size === 0)
    traveled = 0;
  pointers.set(event.pointerId, pixelOf(event));
}

function turnWheel(event) {
  event.preventDefault();
  const pixelsOfLine = 30;
  const isInLines = event.deltaMode !== 0; // or in pages, which count as lines; else deltaY is in pixels
  zoom(Math.exp(0.001 * event.deltaY * (isInLines ? pixelsOfLine : 1)));
  redrawMoving();
}

// ---- the list of planes and the layers

// Returns the row of a plane in the list.
function rowOf(plane, i) {
  const row = document.createElement('tr'), box = document.createElement('input'), swatch = document.createElement('span');
  Object.assign(box, {type: 'checkbox', checked: true, title: 'show plane ' + plane.id});
  box.onclick = event => event.stopPropagation();
  box.onchange = () => { groups[i].isOn = box.checked; redraw(); };
  swatch.style.background = plane.color;
  row.insertCell().append(box);
  row.insertCell().append(swatch, `${plane.id} ${nameOf(plane)}`);
  for (const text of [groups[i].all, shortText(plane.area, 3), shortText(plane.rms, 2), plane.slope.toFixed(1)])
    row.insertCell().append(text);
  row.onclick = () => choosePlane(i);
  return row;
}

// Shows or hides all planes that are listed.
function showAll(isOn) {
  groups.forEach((group, i) => {
    if (!group.isListed)
      return;
    group.isOn = isOn;
    if (planes[i])
      element('rows').children[i].querySelector('input').checked = isOn;
  });
  redraw();
}

// Lists and shows only planes whose number is the text of the search field, or whose name begins with
// it, and that are of the chosen kind, if there is one.
function filterPlanes() {
  const text = element('find').value.trim().toLowerCase(), kind = element('kind').value;
  planes.forEach((plane, i) => {
    const isNamed = String(plane.id) === text || nameOf(plane).startsWith(text);
    groups[i].isListed = isNamed && (!kind || nameOf(plane) === kind);
    element('rows').children[i].hidden = !groups[i].isListed;
  });
  const listed = planes.filter((plane, i) => groups[i].isListed).length;
  element('found').textContent = listed < planes.length ? `${listed} of ${planes.length}` : '';
  redraw();
}

// Fills the choice of kinds: each name of planes with the number of planes.
function fillFilter() {
  const counts = new Map();
  for (const plane of planes)
    counts.set(nameOf(plane), (counts.get(nameOf(plane)) || 0) + 1);
  const names = [...counts.keys()].sort();
  element('kind').append(new Option('all kinds', ''), ...names.map(name => new Option(`${name} (${counts.get(name)})`, name)));
  element('filter').oninput = filterPlanes;
}

function fillPanel() {
  const all = groups.reduce((sum, group) => sum + group.all, 0);
  document.title = element('title').textContent = description.title;
  element('note').textContent = `${planes.length} ${planes.length === 1 ? 'plane' : 'planes'}. ` +
    (shownPoints === all ? `All ${all} points are shown.`
      : `${shownPoints} of ${all} points are shown: an even sample, with points of each plane.`) +
    ' Lengths are in the unit of the cloud (m), slopes in degrees.';
  element('rows').append(...planes.map(rowOf));
  fillFilter();
  element('backs').checked = description.backs;
  element('all').onclick = () => showAll(true);
  element('none').onclick = () => showAll(false);
  element('reset').onclick = lookAtAll;
  element('layers').oninput = redraw;
}

function start() {
  fillPanel();
  if (!gl) {
    element('answer').textContent = 'This browser has no WebGL 2, which draws the points; try another one.';
    return;
  }
  prepareDrawing();
  canvas.onpointerdown = press;
  canvas.oncontextmenu = event => event.preventDefault();
  canvas.addEventListener('wheel', turnWheel, {passive: false});
  for (const [kind, listener] of [['pointermove', move], ['pointerup', release], ['pointercancel', release]])
    window.addEventListener(kind, listener);
  new ResizeObserver(redraw).observe(canvas);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  lookAtAll();
  redrawMoving(); // a sample of the points is soon drawn
}

start();
