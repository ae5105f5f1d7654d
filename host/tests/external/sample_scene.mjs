// SPDX-License-Identifier: BSD-3-Clause
// A scene as docs/scene-format.md says, written by hand: a closed tube with a slide and a cage, under nodes that turn,
// stretch and mirror. The checks are tried on it, whole and broken.

const segments = 12, rings = 5;

// A closed tube along Z, radii 0.5 and 0.35, z from -1 to 1. {positions, triangles}, flat arrays.
function tube() {
  const positions = [], triangles = [];
  for (let ring = 0; ring < rings; ++ring) {
    for (let i = 0; i < segments; ++i) {
      const angle = (2 * Math.PI * i) / segments;
      positions.push(0.5 * Math.cos(angle), 0.35 * Math.sin(angle), (2 * ring) / (rings - 1) - 1);
    }
  }
  const bottom = rings * segments, top = bottom + 1;
  positions.push(0, 0, -1, 0, 0, 1);
  for (let i = 0; i < segments; ++i) {
    const next = (i + 1) % segments, last = (rings - 1) * segments;
    triangles.push(bottom, next, i, top, last + i, last + next);
    for (let low = 0; low < last; low += segments) {
      triangles.push(low + i, low + next, low + segments + next, low + i, low + segments + next, low + segments + i);
    }
  }
  return {positions, triangles};
}

// A box in the tube's space: two ends and a section between them, so that each side is two quads.
function cage() {
  const positions = [], triangles = [], square = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  for (const z of [-1.1, 0.2, 1.1]) for (const [x, y] of square) positions.push(0.7 * x, 0.6 * y, z);
  for (const low of [0, 4]) {
    for (let i = 0; i < 4; ++i) {
      const next = (i + 1) % 4;
      triangles.push(low + i, low + next, low + 4 + next, low + i, low + 4 + next, low + 4 + i);
    }
  }
  triangles.push(0, 2, 1, 0, 3, 2, 8, 9, 10, 8, 10, 11);
  return {positions, triangles};
}

function geometry({positions, triangles}) {
  const points = Float32Array.from(positions), indices = Uint16Array.from(triangles);
  const bytes = Buffer.concat([Buffer.from(points.buffer), Buffer.from(indices.buffer)]);
  const side = (pick) => [0, 1, 2].map((k) => points.filter((_, i) => i % 3 === k).reduce((a, b) => pick(a, b)));
  return {bytes, split: points.byteLength, count: points.length / 3, indexCount: indices.length,
          min: side(Math.min), max: side(Math.max)};
}

// Adds a mesh whose bytes are those of `buffer`, and returns its number.
function addMesh(json, name, buffer, {bytes, split, count, indexCount, min, max}) {
  const view = json.bufferViews.length, accessor = json.accessors.length;
  json.bufferViews.push({buffer, byteLength: split, target: 34962},
                        {buffer, byteOffset: split, byteLength: bytes.length - split, target: 34963});
  json.accessors.push({bufferView: view, componentType: 5126, count, type: 'VEC3', min, max},
                      {bufferView: view + 1, componentType: 5123, count: indexCount, type: 'SCALAR'});
  return json.meshes.push({name, primitives: [{attributes: {POSITION: accessor}, indices: accessor + 1}]}) - 1;
}

// The slide of the scene, as a slides file has it: the circle turned by 30 degrees about X, moved up.
const cosine = Math.cos(Math.PI / 6), sine = Math.sin(Math.PI / 6);
export const sampleSlides = [{name: 'waist', center: [0.02, -0.01, 0.2], u: [0.55, 0, 0],
                              v: [0, 0.4 * cosine, 0.4 * sine]}];

// {json, binary}: nodes are 0 root, 1 model, 2 slide, 3 cage.
export function sampleScene() {
  const json = {asset: {version: '2.0', generator: 'Cagewright tests'}, scene: 0, scenes: [{nodes: [0]}],
                extensionsUsed: ['CAGEWRIGHT_cut_slide', 'CAGEWRIGHT_cage'],
                nodes: [], meshes: [], accessors: [], bufferViews: [], buffers: []};
  const model = geometry(tube()), own = geometry(cage());
  json.buffers.push({byteLength: model.bytes.length});
  const modelMesh = addMesh(json, 'Tube', 0, model);
  json.buffers.push({byteLength: own.bytes.length,
                     uri: `data:application/octet-stream;base64,${own.bytes.toString('base64')}`});
  const cageMesh = addMesh(json, 'Tube cage', 1, own);
  const half = Math.PI / 12, sections = [-1, -1, -1, -1, 0, 0, 0, 0, -1, -1, -1, -1];
  json.nodes.push(
      {name: 'root', rotation: [0.36, 0.48, 0, 0.8], scale: [2, 1.5, -1], children: [1]},
      {name: 'Tube', mesh: modelMesh, translation: [3, -1, 2], rotation: [0, 0.6, 0, 0.8], children: [2, 3]},
      {name: 'waist', translation: [...sampleSlides[0].center], rotation: [Math.sin(half), 0, 0, Math.cos(half)],
       scale: [0.55, 0.4, 0.475], extensions: {CAGEWRIGHT_cut_slide: {id: 3}}, extras: {CAGEWRIGHT_cut_slide: {id: 3}}},
      {name: 'Tube cage', mesh: cageMesh,
       extensions: {CAGEWRIGHT_cage: {source: 1, parameters: {}, slides: [3], sections}},
       extras: {CAGEWRIGHT_cage: {slides: [3]}}});
  return {json, binary: model.bytes};
}

export function glbBytes({json, binary}) {
  const pad = (bytes, filler) => Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, filler)]);
  const chunk = (type, bytes) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(bytes.length, 0);
    head.write(type, 4, 'latin1');
    return Buffer.concat([head, bytes]);
  };
  const text = pad(Buffer.from(JSON.stringify(json)), ' ');
  const chunks = Buffer.concat([chunk('JSON', text), chunk('BIN\0', pad(binary, 0))]);
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(12 + chunks.length, 8);
  return Buffer.concat([head, chunks]);
}
