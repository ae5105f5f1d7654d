// SPDX-License-Identifier: BSD-3-Clause
// slide_transforms.mjs SCENE EXPECTED.json TOLERANCE
//
// @gltf-transform/core reads SCENE, knows nothing of our extensions, and finds the slides by their extras and names.
// The transform of each, from its node up to the mesh node that it cuts, maps the unit circle to the ellipse in
// EXPECTED and the Z axis to its normal, u x v. TOLERANCE is a fraction of the diagonal of the mesh's bounding box.
// EXPECTED is an array of {name, center, u, v}, or a slides file that holds ellipses only. `normal` may say where the Z
// axis points instead.
import {existsSync} from 'node:fs';
import {readFile} from 'node:fs/promises';

import {CheckError, importTransform, runAsProgram} from './packages.mjs';

const slideKey = 'CAGEWRIGHT_cut_slide', cageKey = 'CAGEWRIGHT_cage';
const circlePoints = 64;

const subtract = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const length = (a) => Math.hypot(...a);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / length(a));

// 4 x 4, column by column, as glTF has them.
function multiply(a, b) {
  return Array.from({length: 16}, (_, i) => {
    const row = i % 4, column = i - row;
    return a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] + a[row + 12] * b[column + 3];
  });
}
const apply = (m, [x, y, z], w) => [0, 1, 2].map((i) => m[i] * x + m[i + 4] * y + m[i + 8] * z + m[i + 12] * w);

// Materials and textures may need extensions that the reader does not have, and images may be missing; neither matters
// for transforms and positions.
export async function readDocument(file) {
  const {Logger, NodeIO} = await importTransform();
  class Reader extends NodeIO {
    async readURI(uri, type) {
      const isImage = /\.(png|jpe?g|webp|ktx2)$/i.test(uri);
      return isImage && !existsSync(uri) ? new Uint8Array(0) : super.readURI(uri, type);
    }
  }
  const io = new Reader().setLogger(new Logger(Logger.Verbosity.SILENT));
  try {
    const document = await io.readAsJSON(file);
    delete document.json.extensionsRequired;
    return await io.readJSON(document);
  } catch (error) {
    throw new CheckError(`${file}: gltf-transform cannot read it: ${error.message}`);
  }
}

export const isSlide = (node) => node.getExtras()[slideKey] !== undefined;
export const isModel = (node) => node.getMesh() !== null && node.getExtras()[cageKey] === undefined;

export function bounds(mesh) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const primitive of mesh.listPrimitives()) {
    const positions = primitive.getAttribute('POSITION');
    if (!positions || positions.getCount() === 0) continue;
    positions.getMinNormalized([]).forEach((x, i) => (low[i] = Math.min(low[i], x)));
    positions.getMaxNormalized([]).forEach((x, i) => (high[i] = Math.max(high[i], x)));
  }
  return {low, high, diagonal: length(subtract(high, low))};
}

// The inverse of an affine transform.
function inverse(m) {
  const [x, y, z] = [0, 4, 8].map((column) => m.slice(column, column + 3)), volume = dot(x, cross(y, z));
  const rows = [cross(y, z), cross(z, x), cross(x, y)].map((row) => row.map((entry) => entry / volume));
  const back = rows.map((row) => -dot(row, m.slice(12, 15)));
  return [...[0, 1, 2].flatMap((column) => [...rows.map((row) => row[column]), 0]), ...back, 1];
}

// The transform of a node relative to one above it, or to the scene.
function toAncestor(node, ancestor) {
  let transform = node.getMatrix();
  for (let up = node.getParentNode(); up && up !== ancestor; up = up.getParentNode()) {
    transform = multiply(up.getMatrix(), transform);
  }
  return transform;
}

// {toMesh, mesh}: the transform of a slide relative to the mesh node that it is under; where there is none, to the only
// one of the file. Throws CheckError where there is no telling.
export function placeSlide(document, slide) {
  let above = slide.getParentNode();
  while (above && !isModel(above)) above = above.getParentNode();
  if (above) return {toMesh: toAncestor(slide, above), mesh: above.getMesh()};
  const models = document.getRoot().listNodes().filter(isModel);
  if (models.length !== 1) throw new CheckError(`none of the nodes above slide ${slide.getName()} has a mesh`);
  return {toMesh: multiply(inverse(toAncestor(models[0], null)), toAncestor(slide, null)), mesh: models[0].getMesh()};
}

// How far the transformed circle is from the ellipse, and by how much the axis misses the normal (a sine).
function deviation(toMesh, {center, u, v, normal: zAxis}) {
  const normal = unit(cross(u, v)), uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
  let distance = 0;
  for (let i = 0; i < circlePoints; ++i) {
    const angle = (2 * Math.PI * i) / circlePoints;
    const d = subtract(apply(toMesh, [Math.cos(angle), Math.sin(angle), 0], 1), center);
    // d = a u + b v + something along the normal; on the ellipse where (a, b) is on the unit circle.
    const a = (vv * dot(d, u) - uv * dot(d, v)) / det, b = (uu * dot(d, v) - uv * dot(d, u)) / det;
    const inPlane = Math.abs(Math.hypot(a, b) - 1) * Math.max(length(u), length(v));
    distance = Math.max(distance, Math.hypot(inPlane, dot(d, normal)));
    if (Number.isNaN(distance)) return {distance: NaN, turn: NaN};
  }
  return {distance, turn: length(subtract(unit(apply(toMesh, [0, 0, 1], 0)), unit(zAxis ?? normal)))};
}

// Throws CheckError for a slide that is missing or elsewhere. Returns the largest distance over the diagonal.
export async function checkSlides(scene, expected, tolerance) {
  const document = await readDocument(scene);
  const slides = document.getRoot().listNodes().filter(isSlide);
  let largest = 0;
  for (const slide of expected) {
    const named = slides.filter((node) => node.getName() === slide.name);
    if (named.length !== 1) throw new CheckError(`${scene}: ${named.length} slides are called ${slide.name}, not one`);
    const {toMesh, mesh} = placeSlide(document, named[0]);
    const {distance, turn} = deviation(toMesh, slide), relative = distance / bounds(mesh).diagonal;
    if (!(relative <= tolerance)) {
      const off = `is off its ellipse by ${relative} of the diagonal, more than ${tolerance}`;
      throw new CheckError(`${scene}: slide ${slide.name} ${off}`);
    }
    if (!(turn <= tolerance)) {
      const off = `misses the normal by ${turn}, more than ${tolerance}`;
      throw new CheckError(`${scene}: the Z axis of slide ${slide.name} ${off}`);
    }
    largest = Math.max(largest, relative);
  }
  return largest;
}

// The slides that a scene has, as checkSlides() expects them. Without those whose names are given apart: "knee" where
// there are two of them, and "knee.2", which one of the two may be called then.
export async function slidesIn(scene) {
  const document = await readDocument(scene), slides = document.getRoot().listNodes().filter(isSlide);
  const called = (name) => slides.filter((other) => other.getName() === name).length;
  const keepsName = (name) => called(name) === 1 && called(name.replace(/\.\d+$/, '')) < 2;
  return slides.filter((node) => keepsName(node.getName())).map((node) => {
    const {toMesh} = placeSlide(document, node), image = (axis, w) => apply(toMesh, axis, w);
    return {name: node.getName(), center: image([0, 0, 0], 1), u: image([1, 0, 0], 0), v: image([0, 1, 0], 0),
            normal: image([0, 0, 1], 0)};
  });
}

export async function readExpected(file) {
  const json = JSON.parse(await readFile(file, 'utf8')), slides = json.slides ?? json;
  if (!Array.isArray(slides) || slides.length === 0) throw new CheckError(`${file}: holds no slides to compare with`);
  for (const {name, center, u, v} of slides) {
    if (!center || !u || !v) throw new CheckError(`${file}: slide ${name} is no ellipse (center, u, v)`);
  }
  return slides;
}

await runAsProgram(import.meta.url, async ([scene, expectedFile, tolerance, ...rest]) => {
  if (!(Number(tolerance) > 0) || rest.length > 0) {
    throw new CheckError('usage: slide_transforms.mjs SCENE EXPECTED.json TOLERANCE');
  }
  const expected = await readExpected(expectedFile);
  const largest = await checkSlides(scene, expected, Number(tolerance));
  const off = largest.toExponential(1);
  return `${expected.length} slides of ${scene} are where they should be, to ${off} of the diagonal`;
});
