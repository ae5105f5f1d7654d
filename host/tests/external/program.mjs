// SPDX-License-Identifier: BSD-3-Clause
// The real program on real files: where they are, what it is given, what it may answer.
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, readdirSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import path from 'node:path';

import {CheckError} from './packages.mjs';
import {bounds, isModel, readDocument, readExpected, slidesIn} from './slide_transforms.mjs';

const minutes = 60 * 1000;

// Every .glb and .gltf of a folder and the folders in it, in the same order everywhere. Folders called "broken" hold
// what is to be refused, which other tests see to.
export function scenesIn(folder) {
  return readdirSync(folder, {withFileTypes: true})
      .sort((a, b) => (a.name < b.name ? -1 : 1))
      .flatMap((entry) => {
        const file = path.join(folder, entry.name);
        if (entry.isDirectory()) return entry.name === 'broken' ? [] : scenesIn(file);
        return /\.(glb|gltf)$/i.test(entry.name) ? [file] : [];
      });
}

// The scene in a new folder, beside links to all that lies beside it, so that what is made of it finds its images.
export function stage(scene, folder) {
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
  const from = path.resolve(path.dirname(scene));
  for (const name of readdirSync(from)) symlinkSync(path.join(from, name), path.join(folder, name));
  return path.join(folder, path.basename(scene));
}

// The nodes that the scene shows, or all of them where it has no scenes.
function shownNodes(root) {
  const scene = root.getDefaultScene() ?? root.listScenes()[0], nodes = [];
  if (!scene) return root.listNodes();
  scene.traverse((node) => nodes.push(node));
  return nodes;
}

// One ellipse across the middle of a mesh, as wide as the mesh is there; null where there is no saying.
function ellipseAcross(mesh) {
  const {low, high, diagonal} = bounds(mesh);
  if (!(diagonal > 0 && diagonal < Infinity)) return null;
  // A flat mesh is none that can be cut, but it must not make an ellipse without area.
  const half = low.map((x, i) => Math.max((high[i] - x) / 2, diagonal / 20)), long = half.indexOf(Math.max(...half));
  const axis = (i) => [0, 1, 2].map((k) => (k === i ? half[i] : 0));
  const center = low.map((x, i) => (x + high[i]) / 2);
  return {name: 'middle', center, u: axis((long + 1) % 3), v: axis((long + 2) % 3)};
}

// The ways to make a cage of a scene, the best one first: [{options, expected}], what to ask of the program and which
// slides the scene has to have afterwards. A scene's own slides are the only way where it has some, or else those of
// NAME.slides.json beside it. Other scenes are cut across the middle of one mesh after the other; a mesh that cannot be
// cut there may still be put into a box, without slides.
export async function waysToCage(scene) {
  const given = scene.replace(/\.[^.]*$/, '.slides.json');
  if (existsSync(given)) return [{options: ['--slides', given], expected: await readExpected(given)}];
  const own = await slidesIn(scene);
  if (own.length > 0) return [{options: [], expected: own}];
  const root = (await readDocument(scene)).getRoot(), nodes = root.listNodes(), cuts = [], boxes = [];
  for (const model of shownNodes(root).filter(isModel)) {
    const node = nodes.indexOf(model), ellipse = ellipseAcross(model.getMesh());
    boxes.push({options: ['--node', String(node)], expected: []});
    if (!ellipse) continue;
    const file = path.join(path.dirname(scene), `across-${node}.slides.json`);
    writeFileSync(file, JSON.stringify({version: 1, slides: [ellipse]}));
    cuts.push({options: ['--slides', file, '--node', String(node)], expected: [ellipse]});
  }
  return [...cuts, ...boxes];
}

// Runs `cagewright cage`. Returns null where it wrote `out`, and the sentence where it refused; throws CheckError where
// it did neither as it should.
export function cage(program, scene, options, out) {
  const parameters = ['cage', scene, '-o', out, '--quiet', ...options];
  const run = spawnSync(program, parameters, {encoding: 'utf8', timeout: 5 * minutes});
  const errors = run.stderr?.trimEnd() ?? '';
  if (run.status === 0 || run.status === 1) {
    if (!existsSync(out)) throw new CheckError(`${scene}: exit ${run.status}, but ${out} is not there`);
    return null;
  }
  const ended = run.error?.message ?? run.signal ?? `exit ${run.status}`;
  if (run.status !== 3) throw new CheckError(`${scene}: cagewright cage: ${ended}: ${errors}`);
  if (existsSync(out)) throw new CheckError(`${scene}: exit 3, but ${out} was written`);
  if (errors === '' || errors.includes('\n')) {
    throw new CheckError(`${scene}: exit 3 without one line that says why: ${errors}`);
  }
  return errors;
}

