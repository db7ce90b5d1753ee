// SPDX-License-Identifier: BSD-3-Clause
// Turns and cuts the model of the page; three.js (THREE) is inlined before this.
(function () {
  'use strict';
  const view = document.getElementById('view');
  const controls = document.getElementById('view-controls');
  const problem = document.getElementById('view-problem');
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

  // The parts of a glTF: what it is, its room, its corners with z up, its triangles. Elements lie below rooms.
  function partsOf(gltf) {
    const parts = [];
    gltf.scene.traverse(node => {
      if (!node.isMesh) return;
      const places = node.geometry.attributes.position.array;
      const corners = new Float32Array(places.length);
      for (let i = 0; i < places.length; i += 3) corners.set([places[i], -places[i + 2], places[i + 1]], i);
      parts.push({
        label: node.material.name, room: +node.parent.name.replace('room_', ''),
        corners: corners, triangles: node.geometry.index.array
      });
    });
    return parts;
  }

  function boxOf(parts) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    parts.forEach(part => part.corners.forEach((value, i) => {
      low[i % 3] = Math.min(low[i % 3], value);
      high[i % 3] = Math.max(high[i % 3], value);
    }));
    return { low: low, high: high };
  }

  // The light of the pictures: from above and from one side, both sides of a face alike.
  function brightness(n) {
    return Math.min(1, 0.72 + 0.16 * Math.abs(0.8 * n.x + 0.6 * n.y) + 0.28 * Math.abs(n.z));
  }

  // Ceilings, and details in the upper half of their room, are what is taken off.
  function ceilingRule(parts) {
    const middles = {};
    [...new Set(parts.map(part => part.room))].forEach(room => {
      const box = boxOf(parts.filter(part => part.room === room));
      middles[room] = (box.low[2] + box.high[2]) / 2;
    });
    return (part, z) => part.label === 'ceiling' || (part.label === 'detail' && z > middles[part.room]);
  }

  function faces(parts, middle, isCeiling, colourOf) {
    const positions = [], colours = [];
    const corner = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
    const u = new THREE.Vector3(), v = new THREE.Vector3(), normal = new THREE.Vector3();
    parts.forEach(part => {
      const base = colourOf(part);
      for (let t = 0; t < part.triangles.length; t += 3) {
        corner.forEach((c, k) => c.fromArray(part.corners, 3 * part.triangles[t + k]));
        if (!isCeiling(part, (corner[0].z + corner[1].z + corner[2].z) / 3)) continue;
        normal.crossVectors(u.subVectors(corner[1], corner[0]), v.subVectors(corner[2], corner[0])).normalize();
        const colour = base.clone().multiplyScalar(brightness(normal));
        corner.forEach(c => {
          positions.push(c.x - middle[0], c.y - middle[1], c.z - middle[2]);
          colours.push(colour.r, colour.g, colour.b);
        });
      }
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(positions), 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(new Float32Array(colours), 3));
    return new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      vertexColors: THREE.VertexColors, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2
    }));
  }

  // The outlines of parts: edges that one triangle of a part has.
  function outlines(parts, middle, isShown) {
    const positions = [];
    parts.forEach(part => {
      const edges = {};
      for (let t = 0; t < part.triangles.length; ++t) {
        const a = part.triangles[t], b = part.triangles[t % 3 === 2 ? t - 2 : t + 1];
        const key = Math.min(a, b) + ' ' + Math.max(a, b);
        edges[key] = edges[key] ? null : [a, b];
      }
      Object.values(edges).filter(edge => edge).forEach(edge => {
        const ends = edge.map(i => part.corners.subarray(3 * i, 3 * i + 3));
        if (isShown(part, (ends[0][2] + ends[1][2]) / 2))
          ends.forEach(p => positions.push(p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]));
      });
    });
    return lines(new Float32Array(positions));
  }

  function lines(positions) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
    return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x222222 }));
  }

  // Shows the parts of each model, by its name.
  function show(models) {
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
    const names = Object.keys(models);
    const { low, high } = boxOf([].concat(...Object.values(models)));
    const middle = low.map((value, k) => (value + high[k]) / 2);
    const radius = Math.hypot(...low.map((value, k) => high[k] - value)) / 2;

    const codes = JSON.parse(element('palettes').textContent);
    const palettes = {
      label: part => new THREE.Color(codes.labels[part.label] || codes.labels.other),
      room: part => new THREE.Color(part.room ? codes.rooms[(part.room - 1) % codes.rooms.length] : codes.labels.other)
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
        const parts = models[state.model], isCeiling = ceilingRule(parts);
        const isBody = (part, z) => !isCeiling(part, z);
        const group = {
          body: faces(parts, middle, isBody, palettes[state.colour]),
          ceiling: faces(parts, middle, isCeiling, palettes[state.colour])
        };
        if (state.model === 'solid') {
          group.edges = outlines(parts, middle, () => true);
          group.openEdges = outlines(parts, middle, isBody);
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
      // A closed model shows both sides; an opened one only what the rooms see of them: faces look out.
      const side = state.ceiling && !isCut ? THREE.DoubleSide : THREE.BackSide;
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
  }

  // Both are read before one is shown.
  const read = script => new Promise((done, failed) => new THREE.GLTFLoader().parse(
    bytes(script.textContent), '', gltf => done({ [script.dataset.name]: partsOf(gltf) }), failed));
  Promise.all([...document.querySelectorAll('script.model')].map(read))
    .then(models => show(Object.assign({}, ...models)))
    .catch(error => fail('The model cannot be shown: ' + error));
})();
