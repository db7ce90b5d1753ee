// SPDX-License-Identifier: BSD-3-Clause
// What Khronos' validator and three.js make of a GLB, as JSON. node glb_in_node.mjs MODEL.glb
import fs from 'fs';
import { createRequire } from 'module';
import { pathToFileURL } from 'url';

const require = createRequire(import.meta.url);
const validator = require('gltf-validator');
const three = require.resolve('three').replace(/build[^/\\]*[/\\][^/\\]*$/, '').replace(/[/\\]build[/\\].*$/, '/');
const { GLTFLoader } = await import(pathToFileURL(three + '/examples/jsm/loaders/GLTFLoader.js'));

const bytes = fs.readFileSync(process.argv[2]);
const report = await validator.validateBytes(new Uint8Array(bytes));
const whole = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const said = [];
console.warn = console.error = (text) => said.push(String(text));
const gltf = await new Promise((done, fail) => new GLTFLoader().parse(whole, '', done, fail));
gltf.scene.updateMatrixWorld(true);
const meshes = [];
gltf.scene.traverse((node) => {
  if (!node.isMesh)
    return;
  node.geometry.computeBoundingBox();
  const box = node.geometry.boundingBox.clone().applyMatrix4(node.matrixWorld);
  meshes.push({ name: node.name, parent: node.parent.name, material: node.material.name,
    low: box.min.toArray(), high: box.max.toArray() });
});
fs.writeSync(1, JSON.stringify({ issues: report.issues, said, meshes }));
