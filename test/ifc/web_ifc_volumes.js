// SPDX-License-Identifier: BSD-3-Clause
// What web-ifc makes of an IFC file, as JSON: volume and box of every product by its name, what it says.
// node web_ifc_volumes.js MODEL.ifc [with triangles: 1]
const fs = require('fs');
const web = require('web-ifc');

// Of each arc, which is a quarter of a circle at most: within 0.04 % of its area. web-ifc cuts openings wrongly into
// walls whose chords are a few millimetres long, as those of a short flat arc are with more of them. Its default is 12.
const CHORDS = 32;

function volumeOf(triangles, points) {
  let volume = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => points[triangles[t + k]]);
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
      a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  return volume;
}

async function main() {
  const api = new web.IfcAPI();
  const said = [];
  console.warn = console.error = (text) => said.push(String(text));
  const log = console.log;
  console.log = (text) => said.push(String(text));
  await api.Init();
  const model = api.OpenModel(fs.readFileSync(process.argv[2]), { COORDINATE_TO_ORIGIN: false, CIRCLE_SEGMENTS: CHORDS });
  const products = {};
  const add = (mesh) => {
    const line = api.GetLine(model, mesh.expressID);
    const kind = api.GetNameFromTypeCode(line.type).toUpperCase();
    const name = kind + ' ' + line.Name.value;
    const product = products[name] || (products[name] = { volume: 0, low: [1e9, 1e9, 1e9], high: [-1e9, -1e9, -1e9], meshes: [] });
    for (let i = 0; i < mesh.geometries.size(); ++i) {
      const placed = mesh.geometries.get(i);
      const geometry = api.GetGeometry(model, placed.geometryExpressID);
      const numbers = api.GetVertexArray(geometry.GetVertexData(), geometry.GetVertexDataSize());
      const triangles = api.GetIndexArray(geometry.GetIndexData(), geometry.GetIndexDataSize());
      const m = placed.flatTransformation;
      const points = [];
      for (let v = 0; v < numbers.length; v += 6) {
        const p = [0, 1, 2].map((k) => m[k] * numbers[v] + m[4 + k] * numbers[v + 1] + m[8 + k] * numbers[v + 2] + m[12 + k]);
        const q = [p[0], -p[2], p[1]]; // web-ifc has y up
        points.push(q);
        for (let k = 0; k < 3; ++k) {
          product.low[k] = Math.min(product.low[k], q[k]);
          product.high[k] = Math.max(product.high[k], q[k]);
        }
      }
      product.volume += volumeOf(triangles, points);
      const c = placed.color;
      if (process.argv[3])
        product.meshes.push({ points, triangles: Array.from(triangles), colour: [c.x, c.y, c.z, c.w] });
      geometry.delete();
    }
  };
  api.StreamAllMeshes(model, add);
  api.StreamAllMeshesWithTypes(model, [web.IFCSPACE], add);
  fs.writeSync(1, JSON.stringify({ products, said }));
}

main();
