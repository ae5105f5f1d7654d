// SPDX-License-Identifier: BSD-3-Clause
// written_scenes.mjs PROGRAM WORK AT_LEAST FOLDER
//
// The program makes a cage of every .glb and .gltf of FOLDER. Of what it writes, Khronos' validator finds no error that
// was not there before, and another reader sees the slides where they should be. Files that the program refuses, with
// one line, are counted; it has to write at least AT_LEAST, a number or "all". WORK is a folder for what is written; it
// goes when all is well.
import {existsSync, rmSync} from 'node:fs';
import path from 'node:path';

import {CheckError, failTogether, failureOf, needPackages, runAsProgram, SkipError} from './packages.mjs';
import {cage, scenesIn, stage, waysToCage} from './program.mjs';
import {checkSlides} from './slide_transforms.mjs';
import {validate} from './validate.mjs';

const tolerance = 1e-6;

const outOf = (scene) => scene.replace(/(\.[^.]*)$/, '.caged$1');

// {slides}: how many the program wrote, all in place; or {refusal}: why it wrote nothing. Throws CheckError.
async function checkScene(program, scene) {
  const out = outOf(scene);
  let ways = [], refusal = null;
  const failure = await failureOf(async () => (ways = await waysToCage(scene)));
  // What the reader cannot read the program need not read either, but it has to answer properly.
  if (failure || ways.length === 0) ways = [{options: [], expected: []}];
  for (const {options, expected} of ways) {
    const reason = cage(program, scene, options, out);
    if (reason) {
      refusal ??= reason;
      continue;
    }
    await validate(scene, out);
    if (expected.length > 0) await checkSlides(out, expected, tolerance);
    return {slides: expected.length};
  }
  return {refusal};
}

await runAsProgram(import.meta.url, async ([program, work, atLeast, folder]) => {
  if (!folder) throw new CheckError('usage: written_scenes.mjs PROGRAM WORK AT_LEAST FOLDER');
  await needPackages();
  if (!existsSync(folder)) throw new SkipError(`${folder} is not there`);
  const scenes = scenesIn(folder), failures = [], refusals = [];
  let slides = 0;
  for (const [i, scene] of scenes.entries()) {
    const failure = await failureOf(async () => {
      const result = await checkScene(program, stage(scene, path.join(work, String(i))));
      if (result.refusal) refusals.push(`${path.relative(folder, scene)}: refused: ${result.refusal}`);
      slides += result.slides ?? 0;
    });
    if (failure) failures.push(`${path.relative(folder, scene)}: ${failure}`);
  }
  if (refusals.length > 0) console.log(refusals.join('\n'));
  const written = scenes.length - refusals.length - failures.length;
  if (!(written >= (atLeast === 'all' ? scenes.length : Number(atLeast)))) {
    failures.push(`only ${written} of the ${scenes.length} scenes of ${folder} were written, not ${atLeast}`);
  }
  if (slides === 0) failures.push(`no scene of ${folder} was written with slides`);
  failTogether(failures);
  rmSync(work, {recursive: true, force: true});
  return `${written} scenes of ${folder} written, sound, with ${slides} slides; ${refusals.length} refused with a line`;
});
