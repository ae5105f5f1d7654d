// SPDX-License-Identifier: BSD-3-Clause
// blender_scenes.mjs PROGRAM BLENDER WORK FOLDER
//
// The program makes a cage of every scene of FOLDER; Blender imports it, shows slides and cages where they belong
// (blender_roundtrip.py) and exports it; the slides are still there, and the program reads what Blender wrote.
import {spawnSync} from 'node:child_process';
import {existsSync, rmSync} from 'node:fs';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

import {CheckError, failTogether, failureOf, needPackages, runAsProgram, SkipError} from './packages.mjs';
import {cage, scenesIn, stage, waysToCage} from './program.mjs';
import {checkSlides} from './slide_transforms.mjs';
import {validate} from './validate.mjs';

const script = fileURLToPath(new URL('blender_roundtrip.py', import.meta.url));
// Blender keeps transforms in single precision.
const tolerance = 1e-5;

const beside = (scene, name) => path.join(path.dirname(scene), name);

// One Blender for all pairs [scene, out]. Returns the lines that say what is wrong, scene by scene.
function roundTrips(blender, pairs) {
  const options = ['-b', '--factory-startup', '--python-exit-code', '3', '-P', script, '--', ...pairs.flat()];
  const run = spawnSync(blender, options, {encoding: 'utf8', timeout: 15 * 60 * 1000, maxBuffer: 1 << 28});
  const failures = (run.stderr ?? '').split('\n').filter((line) => line.startsWith('blender_roundtrip.py: '));
  const isJudgement = run.status === 0 ? failures.length === 0 : run.status === 1 && failures.length > 0;
  if (isJudgement) return failures;
  const ended = run.error?.message ?? run.signal ?? `exit ${run.status}`;
  throw new CheckError(`blender: ${ended}\n${run.stdout}${run.stderr}`);
}

function mustWrite(program, scene, options, out) {
  const refusal = cage(program, scene, options, out);
  if (refusal) throw new CheckError(`${scene}: refused: ${refusal}`);
}

// The staged scene with a cage: {scene, caged, back, expected}; `back` is what Blender is to write.
async function cageScene(program, scene) {
  const [{expected, options}] = await waysToCage(scene);
  const caged = beside(scene, `caged${path.extname(scene)}`);
  mustWrite(program, scene, options, caged);
  return {scene, caged, back: beside(scene, 'back.glb'), expected};
}

async function checkBack(program, {scene, back, expected}) {
  const again = beside(scene, 'again.glb');
  await checkSlides(back, expected, tolerance);
  // The extras are enough: no slides are given, the scene has them.
  mustWrite(program, back, [], again);
  await checkSlides(again, expected, tolerance);
  await validate(back, again);
  // Without extras the slides are ordinary nodes and the cage is a mesh like others: a cage, or one clear line.
  cage(program, beside(scene, 'back.plain.glb'), [], beside(scene, 'plain_again.glb'));
}

await runAsProgram(import.meta.url, async ([program, blender, work, folder]) => {
  if (!folder) throw new CheckError('usage: blender_scenes.mjs PROGRAM BLENDER WORK FOLDER');
  await needPackages();
  if (!existsSync(folder)) throw new SkipError(`${folder} is not there`);
  const scenes = scenesIn(folder), caged = [], failures = [];
  const attempt = async (check) => {
    const failure = await failureOf(check);
    if (failure) failures.push(failure);
  };
  for (const [i, scene] of scenes.entries()) {
    await attempt(async () => caged.push(await cageScene(program, stage(scene, path.join(work, String(i))))));
  }
  await attempt(() => failTogether(roundTrips(blender, caged.map((each) => [each.caged, each.back]))));
  for (const each of caged.filter(({back}) => existsSync(back))) await attempt(() => checkBack(program, each));
  if (scenes.length === 0) failures.push(`${folder}: holds no scenes`);
  failTogether(failures);
  rmSync(work, {recursive: true, force: true});
  return `${scenes.length} scenes of ${folder} went through Blender and back`;
});
