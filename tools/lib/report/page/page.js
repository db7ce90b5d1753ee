// SPDX-License-Identifier: BSD-3-Clause
// Turns and cuts the model of the page; three.js (THREE) is inlined before this.
(function () {
  'use strict';
  const view = document.getElementById('view');
  const controls = document.getElementById('view-controls');
  const problem = document.getElementById('view-problem');
  const data = JSON.parse(document.getElementById('model-data').textContent);
  const element = id => document.getElementById(id);

  function fail(sentence) {
    view.hidden = controls.hidden = true;
    problem.textContent = sentence;
    problem.hidden = false;
  }

  function bytes(base64) {
    const text = atob(base64);
    const array = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) array[i] = text.charCodeAt(i);
    return array.buffer;
  }

  // Places come as 16-bit shares of a box; here they are metres from the middle of the scene.
  function places(model, base64, middle) {
    const shares = new Uint16Array(bytes(base64));
    const array = new Float32Array(shares.length);
    for (let i = 0; i < array.length; ++i) {
      const k = i % 3;
      array[i] = model.low[k] + shares[i] / 65535 * model.size[k] - middle[k];
    }
    return array;
  }

  // The light of the pictures: from above and from one side, both sides of a face alike.
  function brightness(n) {
    return Math.min(1, 0.72 + 0.16 * Math.abs(0.8 * n.x + 0.6 * n.y) + 0.28 * Math.abs(n.z));
  }

  function faces(model, vertices, ofCeiling, colourOf) {
    const corners = new Uint32Array(bytes(model.corners));
    const kinds = {
      labels: new Uint8Array(bytes(model.labels)),
      rooms: new Uint8Array(bytes(model.rooms)),
      ceilings: new Uint8Array(bytes(model.ceilings))
    };
    const chosen = [];
    for (let t = 0; t < model.triangles; ++t)
      if (!!kinds.ceilings[t] === ofCeiling) chosen.push(t);
    const positions = new Float32Array(9 * chosen.length);
    const colours = new Float32Array(9 * chosen.length);
    const corner = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
    const u = new THREE.Vector3(), v = new THREE.Vector3(), normal = new THREE.Vector3();
    chosen.forEach((t, place) => {
      for (let k = 0; k < 3; ++k) {
        const i = 3 * corners[3 * t + k];
        corner[k].set(vertices[i], vertices[i + 1], vertices[i + 2]);
        corner[k].toArray(positions, 9 * place + 3 * k);
      }
      u.subVectors(corner[1], corner[0]);
      v.subVectors(corner[2], corner[0]);
      normal.crossVectors(u, v).normalize();
      const colour = colourOf(kinds, t).clone().multiplyScalar(brightness(normal));
      for (let k = 0; k < 3; ++k) colour.toArray(colours, 9 * place + 3 * k);
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
    return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      vertexColors: THREE.VertexColors, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2
    }));
  }

  function lines(positions) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x222222 }));
  }

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  } catch (error) {
    fail('This browser offers no WebGL, so the model cannot be turned here; the pictures below show it.');
    return;
  }
  renderer.setClearColor(0xffffff);
  renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
  view.appendChild(renderer.domElement);

  // The box around all models, metres.
  const names = Object.keys(data.models);
  const low = [0, 1, 2].map(k => Math.min(...names.map(n => data.models[n].low[k])));
  const high = [0, 1, 2].map(k => Math.max(...names.map(n => data.models[n].low[k] + data.models[n].size[k])));
  const middle = low.map((value, k) => (value + high[k]) / 2);
  const radius = Math.hypot(...low.map((value, k) => high[k] - value)) / 2;

  const labelColours = data.label_colours.map(code => new THREE.Color(code));
  const roomColours = data.room_colours.map(code => new THREE.Color(code));
  const palettes = {
    label: (kinds, t) => labelColours[kinds.labels[t]] || labelColours[0],
    room: (kinds, t) => kinds.rooms[t] ? roomColours[(kinds.rooms[t] - 1) % roomColours.length] : labelColours[0]
  };

  const state = { model: names[0], ceiling: false, colour: 'label', clip: high[2] };
  const scene = new THREE.Scene();
  const plane = new THREE.Plane(new THREE.Vector3(0, 0, -1), 0);
  renderer.clippingPlanes = [];
  const made = {};

  // The shapes of a model in a palette, made when they are first wanted.
  function shapes() {
    const name = state.model + ' ' + state.colour;
    if (!made[name]) {
      const model = data.models[state.model];
      const vertices = places(model, model.positions, middle);
      const group = {
        body: faces(model, vertices, false, palettes[state.colour]),
        ceiling: faces(model, vertices, true, palettes[state.colour])
      };
      if (model.edges) {
        group.edges = lines(places(model, model.edges, middle));
        group.openEdges = lines(places(model, model.open_edges, middle));
      }
      Object.values(group).forEach(shape => scene.add(shape));
      made[name] = group;
    }
    return made[name];
  }

  const camera = new THREE.PerspectiveCamera(32, 1, radius / 200, radius * 20);
  camera.up.set(0, 0, 1);
  const orbit = new THREE.OrbitControls(camera, renderer.domElement);
  orbit.screenSpacePanning = true;

  // Far enough that every corner of the box is in view, and turns about its middle.
  function goTo(azimuth, elevation) {
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    const towards = new THREE.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    const right = new THREE.Vector3(-Math.sin(a), Math.cos(a), 0);
    const above = new THREE.Vector3().crossVectors(towards, right);
    const slope = Math.tan(camera.fov * Math.PI / 360) / 1.08;
    let distance = 0;
    for (let k = 0; k < 8; ++k) {
      const corner = new THREE.Vector3(...[0, 1, 2].map(i => ((k >> i & 1) ? high[i] : low[i]) - middle[i]));
      const needed = Math.max(Math.abs(corner.dot(above)) / slope, Math.abs(corner.dot(right)) / (slope * camera.aspect));
      distance = Math.max(distance, needed + corner.dot(towards));
    }
    orbit.target.set(0, 0, 0);
    camera.position.copy(towards).multiplyScalar(distance);
    orbit.update();
    draw();
  }

  function draw() {
    const current = shapes();
    Object.values(made).forEach(group => Object.values(group).forEach(shape => { shape.visible = false; }));
    const isCut = state.clip < high[2] - 1e-6;
    // A closed model shows both sides; an opened one only those that face the rooms.
    const side = state.ceiling && !isCut ? THREE.DoubleSide : THREE.FrontSide;
    current.body.visible = true;
    current.ceiling.visible = state.ceiling;
    current.body.material.side = current.ceiling.material.side = side;
    if (current.edges) (state.ceiling ? current.edges : current.openEdges).visible = true;
    plane.constant = state.clip - middle[2];
    renderer.clippingPlanes = isCut ? [plane] : [];
    renderer.render(scene, camera);
  }

  function resize() {
    const width = view.clientWidth, height = view.clientHeight;
    if (!width || !height) return;
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    draw();
  }

  const clip = element('clip'), clipText = element('clip-text');
  clip.min = low[2].toFixed(2);
  clip.max = (Math.ceil(high[2] * 100) / 100).toFixed(2);
  clip.value = clip.max;
  function readClip() {
    const isWhole = +clip.value >= +clip.max;
    state.clip = isWhole ? high[2] : Math.max(+clip.value, low[2] + 0.01);
    clipText.textContent = isWhole ? 'nothing' : (+clip.value).toFixed(2) + ' m';
  }
  readClip();
  clip.addEventListener('input', () => { readClip(); draw(); });
  element('ceiling').checked = state.ceiling;
  element('ceiling').addEventListener('change', event => { state.ceiling = event.target.checked; draw(); });
  document.querySelectorAll('input[name=model]').forEach(input => input.addEventListener('change', () => {
    state.model = input.value;
    draw();
  }));
  document.querySelectorAll('input[name=colour]').forEach(input => input.addEventListener('change', () => {
    state.colour = input.value;
    draw();
  }));
  element('from-above').addEventListener('click', () => goTo(-90, 89.9));
  element('aslant').addEventListener('click', () => goTo(-55, 42));
  orbit.addEventListener('change', draw);
  window.addEventListener('resize', resize);
  controls.hidden = false;
  resize();
  goTo(-55, 42);
})();
