// SPDX-License-Identifier: BSD-3-Clause
// Shows the models and the scan of the page: pictures on canvases, and a view to turn where there is WebGL.
// three.js (THREE) is inlined before this.

// Bytes of base64 as an ArrayBuffer.
function bytesOf(base64) {
  const text = atob(base64), array = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) array[i] = text.charCodeAt(i);
  return array.buffer;
}

// The elements of a binary glTF as solidToGlb() writes it: label, room, corners (z up), triangles. Faces point out
// of the rooms.
function readGlb(buffer) {
  const size = new DataView(buffer).getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 20, size)));
  const numbers = (index, Kind, width) => {
    const accessor = gltf.accessors[index], view = gltf.bufferViews[accessor.bufferView];
    return new Kind(buffer, 28 + size + (view.byteOffset || 0), width * accessor.count);
  };
  const parts = [];
  for (const room of gltf.nodes)
    for (const node of (room.children || []).map(child => gltf.nodes[child])) {
      if (node.mesh === undefined) continue;
      const primitive = gltf.meshes[node.mesh].primitives[0];
      const places = numbers(primitive.attributes.POSITION, Float32Array, 3), corners = new Float32Array(places.length);
      for (let i = 0; i < places.length; i += 3) corners.set([places[i], -places[i + 2], places[i + 1]], i);
      parts.push({
        label: (gltf.materials[primitive.material] || {}).name || 'other', room: +room.name.replace('room_', ''),
        corners, triangles: numbers(primitive.indices, Uint32Array, 1)
      });
    }
  return parts;
}

// The points of the scan: those below the ceilings come first. A distance counts data.colours.distances; 255 is far.
function readScan(scan) {
  const places = new Uint16Array(bytesOf(scan.places)), corners = new Float32Array(places.length);
  const extent = scan.high.map((value, k) => value - scan.low[k]);
  for (let i = 0; i < places.length; ++i) corners[i] = scan.low[i % 3] + extent[i % 3] * places[i] / 65535;
  return { ...scan, corners, distances: scan.distances && new Uint8Array(bytesOf(scan.distances)) };
}

function boxOf(parts) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  parts.forEach(part => part.corners.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3], value);
    high[i % 3] = Math.max(high[i % 3], value);
  }));
  return { low, high };
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// Directions of a viewer, angles in degrees: towards him, to the right and upwards in the picture.
function directions(azimuth, elevation) {
  const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
  const towards = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
  const right = [-Math.sin(a), Math.cos(a), 0];
  return { towards, right, up: cross(towards, right) };
}

// Light from above and from one side, both sides of a face alike.
const brightness = n => Math.min(1, 0.72 + 0.16 * Math.abs(0.8 * n[0] + 0.6 * n[1]) + 0.28 * Math.abs(n[2]));

// Tells whether a part, or its part at a height, belongs to a ceiling. Ceilings, and details in the upper half of
// their room, are what is taken off.
function ceilingTest(parts) {
  const middles = {};
  for (const room of new Set(parts.map(part => part.room))) {
    const box = boxOf(parts.filter(part => part.room === room));
    middles[room] = (box.low[2] + box.high[2]) / 2;
  }
  return (part, z) => part.label === 'ceiling' || (part.label === 'detail' && z > middles[part.room]);
}

// Calls see(part, corners, unit normal, whether it belongs to a ceiling) for each triangle.
function forEachTriangle(parts, see) {
  const isCeiling = ceilingTest(parts);
  for (const part of parts)
    for (let t = 0; t < part.triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map(k => [0, 1, 2].map(axis => part.corners[3 * part.triangles[t + k] + axis]));
      const normal = cross(b.map((value, k) => value - a[k]), c.map((value, k) => value - a[k]));
      const length = Math.hypot(...normal) || 1;
      see(part, [a, b, c], normal.map(value => value / length), isCeiling(part, (a[2] + b[2] + c[2]) / 3));
    }
}

const rgb = hex => [1, 3, 5].map(k => parseInt(hex.substr(k, 2), 16));

// Colours of points, 0 to 255: from dark to light by height, or by distance.
function pointColours(data, scan, byDistance) {
  const ramp = data.colours.distances.map(rgb), low = [84, 96, 116], high = [216, 214, 206];
  const height = Math.max(1e-6, data.top - data.bottom);
  return i => {
    if (byDistance) return scan.distances[i] < ramp.length ? ramp[scan.distances[i]] : [155, 155, 155];
    const share = Math.max(0, Math.min(1, (scan.corners[3 * i + 2] - data.bottom) / height));
    return low.map((value, k) => value + share * (high[k] - value));
  };
}

// Where a place of the plan is on the sheet of a drawing, as shares of it.
const onSheet = (drawing, at) => [drawing.x, drawing.y].map(([a, b, c]) => a * at[0] + b * at[1] + c);

// The points of the scan 1.0 to 1.5 m above a storey's floor, on the sheet of its plan.
function slice(drawing, places) {
  const canvas = Object.assign(document.createElement('canvas'), { width: 2000, height: 1414 }), pen = canvas.getContext('2d');
  pen.fillStyle = '#e8590c';
  for (let i = 0; i < places.length; i += 3)
    if (places[i + 2] > drawing.floor + 1 && places[i + 2] < drawing.floor + 1.5) {
      const [x, y] = onSheet(drawing, [places[i], places[i + 1]]);
      pen.fillRect(canvas.width * x - 1.5, canvas.height * y - 1.5, 3, 3);
    }
  return canvas;
}

// ---- Pictures, painted from far to near: they need no WebGL, and are printed ----

// Draws items [depth, colour, place...] around the box of `outline`; a single place is a square of `size` metres.
function paint(canvas, outline, items, size) {
  const { right, up } = directions(-55, 48), width = 1600, margin = 24;
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const part of outline)
    for (let i = 0; i < part.corners.length; i += 3)
      [right, up].forEach((way, k) => {
        const value = dot(way, part.corners.subarray(i, i + 3));
        low[k] = Math.min(low[k], value);
        high[k] = Math.max(high[k], value);
      });
  const scale = Math.min((width - 2 * margin) / (high[0] - low[0]), (1.1 * width - 2 * margin) / (high[1] - low[1]));
  const shift = (width - scale * (high[0] - low[0])) / 2;
  canvas.width = width;
  canvas.height = Math.round(scale * (high[1] - low[1]) + 2 * margin);
  const pen = canvas.getContext('2d');
  const x = p => shift + scale * (dot(right, p) - low[0]), y = p => margin + scale * (high[1] - dot(up, p));
  const side = Math.max(1.5, Math.min(24, 1.2 * size * scale));
  items.sort((a, b) => a[0] - b[0]);
  for (const [, colour, ...places] of items) {
    pen.fillStyle = pen.strokeStyle = colour;
    if (places.length === 1) {
      pen.fillRect(x(places[0]) - side / 2, y(places[0]) - side / 2, side, side);
      continue;
    }
    pen.beginPath();
    places.forEach(p => pen.lineTo(x(p), y(p)));
    pen.closePath();
    pen.fill();
    pen.stroke(); // closes the gaps between neighbours
  }
}

function paintPictures(data, models, scan) {
  const canvas = id => document.querySelector('#' + id + ' canvas');
  const { towards } = directions(-55, 48), parts = models.solid || models.mesh, outline = parts || [scan];
  const points = byDistance => {
    const colourOf = pointColours(data, scan, byDistance), items = [];
    for (let i = 0; i < scan.below; ++i) {
      const place = scan.corners.subarray(3 * i, 3 * i + 3);
      if (!byDistance || scan.distances[i] < 255) items.push([dot(towards, place), `rgb(${colourOf(i).map(Math.round)})`, place]);
    }
    return items;
  };
  if (scan && scan.is_scan) paint(canvas('scan-picture'), outline, points(false), scan.spacing);
  if (scan && scan.distances) paint(canvas('distance-picture'), outline, points(true), scan.spacing);
  if (!parts) return;
  const storeyOf = room => ((data.plan || {}).storeys || []).findIndex(storey => storey.rooms.includes(room));
  const items = [];
  forEachTriangle(parts, (part, corners, normal, isCeiling) => {
    if (isCeiling || dot(normal, towards) >= 0) return; // the side that the room sees is the back
    const depth = corners.reduce((total, p) => total + dot(towards, p), 0) / 3;
    const order = 2e5 * storeyOf(part.room) + (part.label === 'floor' ? 0 : 1e5); // large floors lie behind all else
    const colour = rgb(data.colours.labels[part.label] || data.colours.labels.other);
    items.push([order + depth, `rgb(${colour.map(value => Math.round(value * brightness(normal)))})`, ...corners]);
  });
  paint(canvas('model-picture'), outline, items, 0);
}

// ---- The view to turn ----

const fieldOfView = 32; // degrees, vertical

function geometryOf(positions, colours) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
  if (colours) geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(colours), 3));
  return geometry;
}

// Makes shapes of what is shown, by its name, around the origin: body, ceiling, and edges of either.
function shapeMaker(data, models, scan, middle) {
  const colourOf = {
    label: part => rgb(data.colours.labels[part.label] || data.colours.labels.other),
    room: part => rgb(part.room ? data.colours.rooms[(part.room - 1) % data.colours.rooms.length] : data.colours.labels.other)
  };
  const moved = p => [p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]];

  function surface(parts, colour, isSolid) {
    const made = { body: [[], []], ceiling: [[], []] };
    forEachTriangle(parts, (part, corners, normal, isCeiling) => {
      const [positions, colours] = isCeiling ? made.ceiling : made.body;
      const shade = colourOf[colour](part).map(value => value / 255 * brightness(normal));
      for (const corner of corners) {
        positions.push(...moved(corner));
        colours.push(...shade);
      }
    });
    const mesh = ([positions, colours]) => new THREE.Mesh(geometryOf(positions, colours), new THREE.MeshBasicMaterial({
      vertexColors: THREE.VertexColors, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2
    }));
    const shapes = { body: mesh(made.body), ceiling: mesh(made.ceiling) };
    if (isSolid) {
      const isCeiling = ceilingTest(parts), isAbove = part => isCeiling(part, (boxOf([part]).low[2] + boxOf([part]).high[2]) / 2);
      shapes.bodyEdges = edges(parts.filter(part => !isAbove(part)));
      shapes.ceilingEdges = edges(parts.filter(isAbove));
    }
    return shapes;
  }

  // The outlines of parts: edges that one triangle of a part has.
  function edges(parts) {
    const positions = [];
    for (const part of parts) {
      const ends = new Map();
      for (let t = 0; t < part.triangles.length; ++t) {
        const a = part.triangles[t], b = part.triangles[t % 3 === 2 ? t - 2 : t + 1];
        const key = Math.min(a, b) + ' ' + Math.max(a, b);
        ends.set(key, ends.has(key) ? null : [a, b]);
      }
      for (const edge of ends.values())
        if (edge) edge.forEach(i => positions.push(...moved(part.corners.subarray(3 * i, 3 * i + 3))));
    }
    return new THREE.LineSegments(geometryOf(positions), new THREE.LineBasicMaterial({ color: 0x222222 }));
  }

  function points(byDistance) {
    const colour = pointColours(data, scan, byDistance);
    const cloud = (first, last) => {
      const positions = [], colours = [];
      for (let i = first; i < last; ++i) {
        positions.push(...moved(scan.corners.subarray(3 * i, 3 * i + 3)));
        colours.push(...colour(i).map(value => value / 255));
      }
      return new THREE.Points(geometryOf(positions, colours),
        new THREE.PointsMaterial({ size: 1.2 * scan.spacing / Math.tan(fieldOfView * Math.PI / 360), vertexColors: THREE.VertexColors }));
    };
    return { body: cloud(0, scan.below), ceiling: cloud(scan.below, scan.count) };
  }

  return (name, colour) => models[name] ? surface(models[name], colour, name === 'solid') : points(name === 'distances');
}

// Throws a sentence if there is no WebGL.
function showView(data, models, scan) {
  const element = id => document.getElementById(id), view = element('view');
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  } catch (error) {
    throw 'This browser offers no WebGL, so the model cannot be turned here; the pictures below show it.';
  }
  renderer.setClearColor(0xffffff);
  renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
  view.appendChild(renderer.domElement);

  const { low, high } = boxOf([].concat(...Object.values(models)));
  const middle = low.map((value, k) => (value + high[k]) / 2), radius = Math.hypot(...low.map((value, k) => high[k] - value)) / 2;
  const state = { model: models.solid ? 'solid' : 'mesh', colour: 'label', ceiling: false, clip: high[2] };
  const scene = new THREE.Scene(), plane = new THREE.Plane(new THREE.Vector3(0, 0, -1), 0);
  const camera = new THREE.PerspectiveCamera(fieldOfView, 1, radius / 200, radius * 20);
  const orbit = new THREE.OrbitControls(camera, renderer.domElement);
  camera.up.set(0, 0, 1);
  orbit.screenSpacePanning = true;
  const make = shapeMaker(data, models, scan, middle), made = {};

  // The shapes of what is chosen, made when they are first wanted.
  function shapes() {
    const name = state.model + ' ' + state.colour;
    if (!made[name]) {
      made[name] = make(state.model, state.colour);
      Object.values(made[name]).forEach(shape => scene.add(shape));
    }
    return made[name];
  }

  function draw() {
    const current = shapes(), isCut = state.clip < high[2] - 1e-6;
    Object.values(made).forEach(group => Object.values(group).forEach(shape => { shape.visible = group === current; }));
    current.ceiling.visible = state.ceiling;
    if (current.ceilingEdges) current.ceilingEdges.visible = state.ceiling;
    // A closed model shows both sides; an opened one only what the rooms see of them: faces look out.
    current.body.material.side = current.ceiling.material.side = state.ceiling && !isCut ? THREE.DoubleSide : THREE.BackSide;
    plane.constant = state.clip - middle[2];
    renderer.clippingPlanes = isCut ? [plane] : [];
    renderer.render(scene, camera);
  }

  // Far enough that every corner of the box is in view; turns about its middle.
  function goTo(azimuth, elevation) {
    const { towards, right, up } = directions(azimuth, elevation), slope = Math.tan(camera.fov * Math.PI / 360) / 1.08;
    let distance = 0;
    for (let k = 0; k < 8; ++k) {
      const corner = [0, 1, 2].map(i => ((k >> i & 1) ? high[i] : low[i]) - middle[i]);
      distance = Math.max(distance, dot(corner, towards)
        + Math.max(Math.abs(dot(corner, up)) / slope, Math.abs(dot(corner, right)) / (slope * camera.aspect)));
    }
    orbit.target.set(0, 0, 0);
    camera.position.set(...towards.map(value => value * distance));
    orbit.update();
    draw();
  }

  function resize() {
    if (!view.clientWidth || !view.clientHeight) return;
    renderer.setSize(view.clientWidth, view.clientHeight, false);
    camera.aspect = view.clientWidth / view.clientHeight;
    camera.updateProjectionMatrix();
    draw();
  }

  const clip = element('clip');
  clip.min = low[2].toFixed(2);
  clip.value = clip.max = (Math.ceil(high[2] * 100) / 100).toFixed(2);
  function readClip() {
    const isWhole = +clip.value >= +clip.max;
    state.clip = isWhole ? high[2] : Math.max(+clip.value, low[2] + 0.01);
    element('clip-text').textContent = isWhole ? 'nothing' : (+clip.value).toFixed(2) + ' m';
  }
  readClip();
  clip.addEventListener('input', () => { readClip(); draw(); });
  element('ceiling').checked = state.ceiling;
  element('ceiling').addEventListener('change', event => { state.ceiling = event.target.checked; draw(); });
  const isThere = { solid: models.solid, mesh: models.mesh, scan: scan && scan.is_scan, distances: scan && scan.distances };
  for (const input of document.querySelectorAll('#view-controls input[type=radio]')) {
    if (input.name === 'model' && !isThere[input.value]) input.parentElement.remove();
    input.checked = state[input.name] === input.value;
    input.addEventListener('change', () => { state[input.name] = input.value; draw(); });
  }
  element('from-above').addEventListener('click', () => goTo(-90, 89.9));
  element('aslant').addEventListener('click', () => goTo(-55, 42));
  orbit.addEventListener('change', draw);
  window.addEventListener('resize', resize);
  element('view-controls').hidden = false;
  resize();
  goTo(-55, 42);
}

// Shows the models and the scan of the page's data.
function showModel(data) {
  const models = {};
  for (const [name, model] of Object.entries(data.models)) models[name] = readGlb(bytesOf(model.glb));
  const scan = data.scan && readScan(data.scan), all = [].concat(...Object.values(models));
  const box = boxOf(all.length ? all : scan ? [scan] : []);
  const info = { ...data, bottom: box.low[2], top: box.high[2] };
  if (all.length || scan) paintPictures(info, models, scan);
  if (!all.length) return;
  try {
    if (typeof THREE === 'undefined')
      throw 'The model cannot be turned on this page: three.js was not found where the page was written (Debian\'s '
        + 'package libjs-three). The pictures below show it.';
    showView(info, models, scan);
  } catch (problem) {
    for (const id of ['view', 'view-controls', 'view-help']) document.getElementById(id).hidden = true;
    document.getElementById('view-problem').textContent = String(problem);
    document.getElementById('view-problem').hidden = false;
  }
}
