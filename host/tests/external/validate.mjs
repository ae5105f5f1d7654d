// SPDX-License-Identifier: BSD-3-Clause
// validate.mjs BEFORE AFTER [BEFORE AFTER]...
//
// Khronos' validator finds no error in AFTER that it did not find in BEFORE: for each code and kind of object, not more
// errors than there were. BEFORE may be "-", for a file that was not made of another glTF file.
import {readFile} from 'node:fs/promises';
import path from 'node:path';

import {CheckError, failTogether, failureOf, importValidator, runAsProgram} from './packages.mjs';

const severityError = 0;

// The validator's errors in a file, with what it refers to beside it: [{code, pointer, message}].
export async function errorsIn(file) {
  const validator = await importValidator();
  const folder = path.dirname(file);
  const bytes = new Uint8Array(await readFile(file));
  const externalResourceFunction = async (uri) =>
    new Uint8Array(await readFile(path.resolve(folder, decodeURIComponent(uri))));
  let report;
  try {
    report = await validator.validateBytes(bytes, {uri: path.basename(file), maxIssues: 0, externalResourceFunction});
  } catch (reason) {
    return [{code: 'NOT_GLTF', pointer: '', message: String(reason)}];
  }
  return report.issues.messages.filter((issue) => issue.severity === severityError)
      .map(({code, pointer, offset, message}) => ({code, pointer: pointer ?? `byte ${offset ?? '?'}`, message}));
}

// "/nodes/3/children/0" and "/nodes/17/children/2" are of one kind.
const kindOf = ({code, pointer}) => `${code} ${pointer.replace(/\d+/g, '*')}`;

export function newErrors(before, after) {
  const allowed = new Map();
  for (const error of before) allowed.set(kindOf(error), (allowed.get(kindOf(error)) ?? 0) + 1);
  const known = new Set(before.map(({code, pointer}) => `${code} ${pointer}`));
  // Errors at the same place as before go first, so that those which are left over are the ones to look at.
  const isKnown = ({code, pointer}) => known.has(`${code} ${pointer}`);
  return [...after.filter(isKnown), ...after.filter((error) => !isKnown(error))].filter((error) => {
    const left = allowed.get(kindOf(error)) ?? 0;
    allowed.set(kindOf(error), left - 1);
    return left <= 0;
  });
}

// Throws CheckError. Returns how many errors the two files share.
export async function validate(before, after) {
  const old = before === '-' ? [] : await errorsIn(before);
  const now = await errorsIn(after);
  const added = newErrors(old, now);
  if (added.length > 0) {
    const lines = added.slice(0, 10).map(({code, pointer, message}) => `${after}: ${code} at ${pointer}: ${message}`);
    if (added.length > lines.length) lines.push(`${after}: and ${added.length - lines.length} errors more`);
    throw new CheckError(lines.join('\n'));
  }
  return now.length;
}

await runAsProgram(import.meta.url, async (files) => {
  if (files.length === 0 || files.length % 2 !== 0) {
    throw new CheckError('usage: validate.mjs BEFORE AFTER [BEFORE AFTER]...');
  }
  const failures = [];
  let shared = 0;
  for (let i = 0; i < files.length; i += 2) {
    const failure = await failureOf(async () => (shared += await validate(files[i], files[i + 1])));
    if (failure) failures.push(failure);
  }
  failTogether(failures);
  return `${files.length / 2} written, no new error (${shared} were there before)`;
});
