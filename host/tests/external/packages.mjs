// SPDX-License-Identifier: BSD-3-Clause
// What every check here shares: its npm packages, and how it ends.
import {existsSync} from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

export const exitSkipped = 77;

// A check that found something wrong; the message is all that is printed.
export class CheckError extends Error {}

// Something that the check needs is not on this machine.
export class SkipError extends Error {}

// The folder with the installed packages, as CAGEWRIGHT_NODE_MODULES names it.
function nodeModules() {
  const folder = process.env.CAGEWRIGHT_NODE_MODULES;
  if (!folder) throw new SkipError('CAGEWRIGHT_NODE_MODULES is not set; run fetch_packages.sh, name its node_modules');
  if (!existsSync(folder)) throw new SkipError(`${folder} is not there (CAGEWRIGHT_NODE_MODULES)`);
  return path.resolve(folder);
}

// What to import of each package: the folder is not where node would look for it.
const entries = {'@gltf-transform/core': 'dist/index.js', 'gltf-validator': 'index.js'};

async function importPackage(name) {
  const file = path.join(nodeModules(), name, entries[name]);
  if (!existsSync(file)) throw new SkipError(`${file} is not there; run fetch_packages.sh`);
  const module = await import(pathToFileURL(file).href);
  return module.default ?? module;
}

export const importValidator = () => importPackage('gltf-validator');
export const importTransform = () => importPackage('@gltf-transform/core');

// Throws SkipError where one of the packages is not there.
export const needPackages = () => Promise.all([importValidator(), importTransform()]);

// One failure must not hide the others: the sentence of the CheckError that `check` throws, or null.
export async function failureOf(check) {
  try {
    await check();
    return null;
  } catch (error) {
    if (error instanceof CheckError) return error.message;
    throw error;
  }
}

export function failTogether(failures) {
  if (failures.length > 0) throw new CheckError(failures.join('\n'));
}

// Runs `main` where the module was started as a program. It returns the line to print; exit 0, 1 or 77.
export async function runAsProgram(moduleUrl, main) {
  if (!process.argv[1] || moduleUrl !== pathToFileURL(path.resolve(process.argv[1])).href) return;
  const name = path.basename(process.argv[1]);
  try {
    console.log(`${name}: ${await main(process.argv.slice(2))}`);
  } catch (error) {
    if (error instanceof SkipError) {
      console.log(`${name}: skipped, ${error.message}`);
      process.exitCode = exitSkipped;
    } else {
      console.error(`${name}: ${error instanceof CheckError ? error.message : error.stack}`);
      process.exitCode = 1;
    }
  }
}
