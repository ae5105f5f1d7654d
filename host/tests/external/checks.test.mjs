// SPDX-License-Identifier: BSD-3-Clause
// The checks of this folder pass on a sound scene, and on a wrong one fail with a line that names what is wrong.
// Run with node; CAGEWRIGHT_BLENDER names Blender, without it those tests are skipped.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {chmodSync, mkdirSync, mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {exitSkipped, needPackages, SkipError} from './packages.mjs';
import {glbBytes, sampleScene, sampleSlides} from './sample_scene.mjs';

try {
  await needPackages();
} catch (error) {
  if (!(error instanceof SkipError)) throw error;
  console.log(`checks.test.mjs: skipped, ${error.message}`);
  process.exit(exitSkipped);
}

const slideNode = 2, cageNode = 3;
const folder = mkdtempSync(path.join(tmpdir(), 'cagewright-checks-'));
after(() => rmSync(folder, {recursive: true, force: true}));

const inFolder = (name) => path.join(folder, name);

// Writes the sample scene after `change` had its JSON; returns where.
function write(name, change = () => {}) {
  const scene = sampleScene();
  change(scene.json, scene);
  writeFileSync(inFolder(name), glbBytes(scene));
  return inFolder(name);
}

function run(script, ...parameters) {
  const program = fileURLToPath(new URL(script, import.meta.url));
  const {status, stdout, stderr} = spawnSync(process.execPath, [program, ...parameters], {encoding: 'utf8'});
  return {status, stdout, stderr};
}

function expectFailure({status, stderr}, ...words) {
  assert.equal(status, 1, stderr);
  for (const word of words) assert.ok(stderr.includes(word), `${word} is not in: ${stderr}`);
  assert.ok(!stderr.includes('    at '), `a stack and not a sentence: ${stderr}`);
}

const expectSuccess = ({status, stdout, stderr}) => assert.equal(status, 0, stdout + stderr);

// --- validate.mjs

const withSlide = (change) => (json) => change(json.nodes[slideNode]);
const breakRotation = withSlide((slide) => (slide.rotation = [1, 1, 0, 0]));

test('the sample scene is valid', () => expectSuccess(run('validate.mjs', '-', write('sound.glb'))));

test('an error that was not there before fails, with its code and place', () => {
  const result = run('validate.mjs', write('sound.glb'), write('rotation.glb', breakRotation));
  expectFailure(result, 'rotation.glb', 'ROTATION_NON_UNIT', '/nodes/2/rotation');
});

test('an error that was there before passes', () => {
  const file = write('rotation.glb', breakRotation);
  expectSuccess(run('validate.mjs', file, file));
});

test('a second error of a kind that was there once fails, and names the second', () => {
  const twice = write('rotations.glb', (json) => {
    breakRotation(json);
    json.nodes[0].rotation = [0, 2, 0, 0];
  });
  expectFailure(run('validate.mjs', write('rotation.glb', breakRotation), twice), '/nodes/0/rotation');
});

test('a cage whose accessor reaches beyond its buffer fails', () => {
  const result = run('validate.mjs', write('sound.glb'), write('cage.glb', (json) => (json.accessors[2].count = 99)));
  expectFailure(result, 'ACCESSOR_TOO_LONG', '/accessors/2');
});

test('a cage whose data URI is damaged fails', () => {
  const result = run('validate.mjs', write('sound.glb'), write('uri.glb', (json) => (json.buffers[1].uri += '!')));
  expectFailure(result, '/buffers/1/uri');
});

test('an extension that is used but not named in extensionsUsed fails', () => {
  const result = run('validate.mjs', write('sound.glb'), write('used.glb', (json) => delete json.extensionsUsed));
  expectFailure(result, 'UNDECLARED_EXTENSION', 'CAGEWRIGHT_cut_slide');
});

test('an image beside the file is found, and missed where it is not there', () => {
  const change = (json) => {
    json.images = [{uri: 'a%20picture.png'}];
    json.textures = [{source: 0}];
    json.materials = [{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}];
  };
  const before = write('sound.glb'), file = write('image.glb', change);
  expectFailure(run('validate.mjs', before, file), 'IO_ERROR', '/images/0/uri');
  const pixel = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNk+A8AAQUBAScY42YAAAAASUVORK5CYII=';
  writeFileSync(inFolder('a picture.png'), Buffer.from(pixel, 'base64'));
  expectSuccess(run('validate.mjs', before, file));
});

test('a file cut short fails', () => {
  const bytes = glbBytes(sampleScene());
  writeFileSync(inFolder('short.glb'), bytes.subarray(0, bytes.length - 5));
  expectFailure(run('validate.mjs', write('sound.glb'), inFolder('short.glb')), 'short.glb', 'GLB_');
});

test('a file that is no glTF fails', () => {
  writeFileSync(inFolder('text.glb'), 'nothing of the kind');
  expectFailure(run('validate.mjs', write('sound.glb'), inFolder('text.glb')), 'text.glb');
});

// --- slide_transforms.mjs

const slidesFile = inFolder('expected.json');
writeFileSync(slidesFile, JSON.stringify(sampleSlides));
const checkSlides = (scene, tolerance = '1e-6', expected = slidesFile) =>
  run('slide_transforms.mjs', scene, expected, tolerance);
const expectOff = (result) => expectFailure(result, 'waist', 'off its ellipse');
const changedSlide = (name, change) => checkSlides(write(name, withSlide(change)));

test('the slide of the sample scene is where it should be',
     () => expectSuccess(checkSlides(write('sound.glb'), '1e-12')));

test('a slides file is as good as an array', () => {
  writeFileSync(inFolder('slides.json'), JSON.stringify({version: 1, slides: sampleSlides}));
  expectSuccess(checkSlides(write('sound.glb'), '1e-12', inFolder('slides.json')));
});

test('the same ellipse by other half axes passes', () => {
  const [{name, center, u, v}] = sampleSlides, mix = (a, b) => u.map((x, i) => a * x + b * v[i]);
  writeFileSync(inFolder('mixed.json'), JSON.stringify([{name, center, u: mix(0.6, 0.8), v: mix(-0.8, 0.6)}]));
  expectSuccess(checkSlides(write('sound.glb'), '1e-12', inFolder('mixed.json')));
});

test('a slide with nodes between it and its mesh is where it should be', () => {
  expectSuccess(checkSlides(write('between.glb', (json) => {
    const slide = json.nodes[slideNode];
    // Twice as far and half as big: the group undoes it.
    slide.translation = slide.translation.map((x) => 2 * x);
    slide.scale = slide.scale.map((x) => 2 * x);
    json.nodes[1].children = [cageNode, json.nodes.push({scale: [0.5, 0.5, 0.5], children: [slideNode]}) - 1];
  })));
});

test('a required extension of materials does not stop the reader', () => {
  expectSuccess(checkSlides(write('required.glb', (json) => {
    json.extensionsUsed.push('KHR_materials_unlit');
    json.extensionsRequired = ['KHR_materials_unlit'];
  })));
});

test('a slide moved by a hundred-thousandth fails',
     () => expectOff(changedSlide('moved.glb', (slide) => (slide.translation[1] += 3e-5))));

test('a slide that is as far off but within the tolerance passes',
     () => expectSuccess(checkSlides(write('near.glb', withSlide((slide) => (slide.translation[1] += 3e-5))), '1e-4')));

test('a radius that is too large fails',
     () => expectOff(changedSlide('wide.glb', (slide) => (slide.scale[0] *= 1.0001))));

test('swapped radii fail',
     () => expectOff(changedSlide('swapped.glb', (slide) => (slide.scale = [0.4, 0.55, 0.475]))));

test('a slide that is a line fails',
     () => expectOff(changedSlide('flat.glb', (slide) => (slide.scale[1] = 0))));

test('a normal that points the other way fails',
     () => expectFailure(changedSlide('turned.glb', (slide) => (slide.scale[2] *= -1)), 'waist', 'misses the normal'));

// The slide is moved under a new child of the root.
function toRoot(json, node) {
  json.nodes[1].children = [cageNode];
  json.nodes[0].children.push(json.nodes.push({...node, children: [slideNode]}) - 1);
}

test('a slide under no mesh belongs to the only one', () => {
  const scene = write('root.glb', (json) => {
    const {translation, rotation} = json.nodes[1];
    toRoot(json, {translation, rotation});
  });
  expectSuccess(checkSlides(scene, '1e-12'));
  expectFailure(checkSlides(write('away.glb', (json) => toRoot(json, {}))), 'waist', 'off its ellipse');
});

test('a slide under no mesh fails where there are two', () => {
  const scene = write('root.glb', (json) => {
    toRoot(json, {});
    json.nodes[0].children.push(json.nodes.push({mesh: 0}) - 1);
  });
  expectFailure(checkSlides(scene), 'none of the nodes above slide waist has a mesh');
});

test('a cage is not the mesh that a slide under it cuts', () => {
  const scene = write('under_cage.glb', (json) => {
    json.nodes[1].children = [cageNode];
    json.nodes[cageNode].children = [slideNode];
    json.nodes[cageNode].scale = [2, 2, 2];
  });
  expectFailure(checkSlides(scene), 'waist', 'off its ellipse');
});

test('a slide without extras is not found by a tool that drops our extension',
     () => expectFailure(changedSlide('extras.glb', (slide) => delete slide.extras), '0 slides are called waist'));

test('a slide with another name is not the one',
     () => expectFailure(changedSlide('name.glb', (slide) => (slide.name = 'waist.2')), '0 slides are called waist'));

test('two slides with one name fail', () => {
  const scene = write('two.glb', (json) => {
    json.nodes[1].children.push(json.nodes.push(structuredClone(json.nodes[slideNode])) - 1);
  });
  expectFailure(checkSlides(scene), '2 slides are called waist');
});

test('nothing to compare with is no success', () => {
  writeFileSync(inFolder('none.json'), '[]');
  expectFailure(checkSlides(write('sound.glb'), '1e-6', inFolder('none.json')), 'none.json', 'no slides');
  writeFileSync(inFolder('stroke.json'), JSON.stringify([{name: 'waist', stroke: [[0, 0, 0]]}]));
  expectFailure(checkSlides(write('sound.glb'), '1e-6', inFolder('stroke.json')), 'waist', 'no ellipse');
});

// --- written_scenes.mjs, with programs that are no good

// A program that is called as cagewright is; `body` is what its shell script does with $scene and $out.
function fakeProgram(name, body) {
  const file = inFolder(name);
  writeFileSync(file, `#!/bin/sh\nscene=$2 out=$4\n${body}\n`);
  chmodSync(file, 0o755);
  return file;
}

mkdirSync(inFolder('scenes'));
write('scenes/a.glb');
write('scenes/b.glb', (json) => {
  json.nodes.length = 2;
  delete json.nodes[1].children;
});
const writtenScenes = (name, body, atLeast = '2') =>
  run('written_scenes.mjs', fakeProgram(name, body), inFolder('work'), atLeast, inFolder('scenes'));

test('a program that writes what it read passes where the slides are there', () => {
  const body = 'case $scene in *b.glb) echo "b.glb: no" >&2; exit 3;; esac; cp "$scene" "$out"';
  const result = writtenScenes('copies', body, '1');
  expectSuccess(result);
  assert.match(result.stdout, /b\.glb: refused: b\.glb: no/);
});

test('a program that loses the slides it was given fails',
     () => expectFailure(writtenScenes('forgets', 'cp "$scene" "$out"'), 'b.glb', '0 slides are called middle'));

test('a program that writes too few scenes fails', () => {
  const result = writtenScenes('refuses', 'echo "$scene: no" >&2; exit 3');
  expectFailure(result, 'only 0 of the 2 scenes');
});

test('a program that damages a scene fails',
     () => expectFailure(writtenScenes('damages', 'head -c 900 "$scene" > "$out"'), 'a.glb', 'GLB_'));

test('a program that says it wrote what it did not fails',
     () => expectFailure(writtenScenes('lies', 'exit 0'), 'is not there'));

test('a program that refuses and writes fails',
     () => expectFailure(writtenScenes('both', 'cp "$scene" "$out"; echo no >&2; exit 3'), 'exit 3, but'));

test('a program that refuses with two lines or none fails', () => {
  expectFailure(writtenScenes('talks', 'printf "no\\nno\\n" >&2; exit 3'), 'without one line');
  expectFailure(writtenScenes('silent', 'exit 3'), 'without one line');
});

test('a program that crashes fails', () => expectFailure(writtenScenes('crashes', 'kill -SEGV $$'), 'SIGSEGV'));

test('a program that ends with an internal error fails',
     () => expectFailure(writtenScenes('internal', 'exit 4'), 'exit 4'));

// --- blender_roundtrip.py and blender_scenes.mjs

const blender = process.env.CAGEWRIGHT_BLENDER;
const withBlender = {skip: blender ? false : 'CAGEWRIGHT_BLENDER names no Blender'};

function roundTrip(scene) {
  const script = fileURLToPath(new URL('blender_roundtrip.py', import.meta.url));
  const options = ['-b', '--factory-startup', '--python-exit-code', '3', '-P', script];
  return spawnSync(blender, [...options, '--', scene, inFolder('back.glb')], {encoding: 'utf8'});
}

test('the sample scene goes through Blender', withBlender, () => {
  expectSuccess(roundTrip(write('sound.glb')));
  expectSuccess(checkSlides(inFolder('back.glb'), '1e-5'));
});

test('a slide with a mesh is no empty', withBlender, () => {
  expectFailure(roundTrip(write('mesh.glb', withSlide((slide) => (slide.mesh = 0)))), 'waist', 'is a MESH');
});

test('a slide whose transform Blender cannot keep is elsewhere', withBlender, () => {
  const shear = withSlide((slide) => {
    slide.matrix = [1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    delete slide.translation;
    delete slide.rotation;
    delete slide.scale;
  });
  expectFailure(roundTrip(write('shear.glb', shear)), 'waist', 'elsewhere');
});

test('a slide without extras is lost in Blender', withBlender, () => {
  const result = roundTrip(write('extras.glb', withSlide((slide) => delete slide.extras)));
  expectFailure(result, 'no object in Blender', 'waist');
});

test('a cage with a degenerate triangle is not the same in Blender', withBlender, () => {
  const scene = write('degenerate.glb', (json) => {
    const bytes = Buffer.from(json.buffers[1].uri.split(',')[1], 'base64');
    // The second corner of the first triangle becomes its first.
    const corner = json.bufferViews[3].byteOffset;
    bytes.copyWithin(corner + 2, corner, corner + 2);
    json.buffers[1].uri = `data:application/octet-stream;base64,${bytes.toString('base64')}`;
  });
  expectFailure(roundTrip(scene), 'Tube cage', 'faces');
});

test('a cage vertex that no triangle uses is lost in Blender', withBlender, () => {
  const scene = write('unused.glb', (json) => (json.accessors[3].count = 6));
  expectFailure(roundTrip(scene), 'Tube cage', 'vertices');
});

test('a file that Blender cannot import fails', withBlender, () => {
  expectFailure(roundTrip(write('version.glb', (json) => (json.asset.version = '3.0'))), 'version.glb', 'gltf fails');
});

test('a scene without slides and cages is no success', withBlender, () => {
  const scene = write('without.glb', (json) => {
    for (const node of json.nodes) delete node.extensions;
    for (const node of json.nodes) delete node.extras;
  });
  expectFailure(roundTrip(scene), 'neither slides nor cages');
});

test('a program that cannot read what Blender wrote fails', withBlender, () => {
  const body = 'case $scene in *back*) echo "$scene: no" >&2; exit 3;; esac; cp "$scene" "$out"';
  const program = fakeProgram('stops', body);
  const only = inFolder('only');
  mkdirSync(only);
  write('only/a.glb');
  expectFailure(run('blender_scenes.mjs', program, blender, inFolder('work'), only), 'back.glb: refused');
});

test('a program that loses slides on the way to Blender fails', withBlender, () => {
  const program = fakeProgram('loses', 'sed "s/CAGEWRIGHT_cut_slide/CAGEWRIGHT_cut_slice/g" "$scene" > "$out"');
  const result = run('blender_scenes.mjs', program, blender, inFolder('work'), inFolder('only'));
  expectFailure(result, '0 slides are called waist');
});

test('a program that keeps what Blender wrote passes', withBlender, () => {
  const program = fakeProgram('copies', 'cp "$scene" "$out"');
  expectSuccess(run('blender_scenes.mjs', program, blender, inFolder('work'), inFolder('only')));
});
