# SPDX-License-Identifier: BSD-3-Clause
"""What is recorded in the window, replayed by the program.

    python3 recording_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import glob
import json
import os
import shutil
import subprocess

from window_case import path, PROGRAM, run_tests, setUpModule, tearDownModule, WindowTest


def parts_of_scene(name):
    """A .glb's JSON, its lists of extensions in order, and the rest."""
    with open(name, 'rb') as file:
        file.read(12)
        size = int.from_bytes(file.read(4), 'little')
        file.read(4)
        scene, rest = json.loads(file.read(size)), file.read()
    scene['extensionsUsed'].sort()  # the copy has a cage before it has slides
    return json.dumps(scene, sort_keys=True), rest


class Recording(WindowTest):
    scene = 'biped.glb'

    def test_a_recording_in_which_what_was_before_it_is_undone_and_redone_replays_to_the_same_file(self):
        window = self.open()
        window.settle()
        window.run('rename_slide', slide='waist', name='belly')
        window.run('remove_slides', slides=['brow'])
        script = path('undone.jsonl')
        window.run('record', path=script)
        window.run('undo')
        window.run('undo')
        window.run('duplicate_slides', slides=['waist'])
        window.run('undo')
        window.run('redo')
        window.run('save', path=path('undone.glb'))
        window.run('record')
        with open(path('undone.glb'), 'rb') as file:
            recorded = file.read()
        os.remove(path('undone.glb'))
        with open(script) as file:
            self.assertEqual([json.loads(line)['command'] for line in file].count('undo'), 1)
        subprocess.run([PROGRAM, '--command', script], check=True, stdout=subprocess.DEVNULL)
        with open(path('undone.glb'), 'rb') as file:
            self.assertEqual(file.read(), recorded)

    def test_copies_of_the_scene_that_a_recording_needs_are_written_once(self):
        window = self.open()
        window.settle()
        window.run('rename_slide', slide='waist', name='belly')
        script = path('to_and_fro.jsonl')
        window.run('record', path=script)
        for command in ('undo', 'redo', 'undo', 'redo', 'undo'):
            window.run(command)
        window.run('record')
        self.assertEqual(sorted(glob.glob(script + '*')), [script, script + '.2.glb', script + '.glb'])

    def test_a_recording_replays_where_it_saves_over_the_scene_that_it_began_with(self):
        scene = path('over.glb')
        shutil.copy(path('biped.glb'), scene)
        window = self.open('over.glb')
        window.settle()
        window.run('rename_slide', slide='waist', name='belly')
        script = path('over.jsonl')
        window.run('record', path=script)
        window.run('undo')
        window.run('rename_slide', slide='waist', name='middle')
        window.run('save')
        window.run('record')
        window.close()
        with open(scene, 'rb') as file:
            recorded = file.read()
        os.remove(scene)
        subprocess.run([PROGRAM, '--command', script], check=True, stdout=subprocess.DEVNULL)
        with open(scene, 'rb') as file:
            self.assertEqual(file.read(), recorded)

    def test_parameters_that_were_set_before_the_first_slide_are_in_a_recording_s_copy(self):
        window = self.open('biped.off')
        window.settle()
        window.run('set_parameter', id='orient.lambda', value=3)
        window.settle()
        script = path('parameters.jsonl')
        window.run('record', path=script)
        window.run('add_slide', name='shin', point=[0.138, 0.3, 0.05])
        window.run('save', path=path('parameters.glb'))
        window.run('record')
        recorded = parts_of_scene(path('parameters.glb'))
        self.assertIn('"orient.lambda": 3', recorded[0])
        os.remove(path('parameters.glb'))
        subprocess.run([PROGRAM, '--command', script], check=True, stdout=subprocess.DEVNULL)
        self.assertEqual(parts_of_scene(path('parameters.glb')), recorded)

    def test_a_recording_that_cannot_go_on_ends_with_a_sentence_and_what_was_done_stays_done(self):
        window = self.open()
        window.settle()
        window.run('rename_slide', slide='waist', name='belly')
        folder = path('recorded_here')
        os.mkdir(folder)
        window.run('record', path=os.path.join(folder, 'r.jsonl'))
        shutil.rmtree(folder)
        open(folder, 'w').close()
        self.assertTrue(window.ask(command='undo')['ok'])
        state = window.wait_until(lambda s: 'The recording is ended: ' in s['status'], 'it says so')
        self.assertIn('r.jsonl.2.glb', state['status'])
        self.assertIn('waist', [slide['name'] for slide in state['slides']])
        self.assertNotIn('record_script', state['marks'])
        window.run('record', path=path('another.jsonl'))
        window.run('redo')
        window.run('record')
        with open(path('another.jsonl')) as file:
            self.assertEqual([json.loads(line)['command'] for line in file].count('open'), 2)

    def test_a_recorded_session_replays_to_the_same_file(self):
        window = self.open()
        window.settle()
        script = path('session.jsonl')
        window.run('record', path=script)
        window.run('remove_slides', slides=['brow'])
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == 17, 'undone')
        window.run('select', slides=['waist'])
        window.key('ctrl+d')
        window.wait_until(lambda s: len(s['slides']) == 18, 'a copy')
        window.settle()
        window.run('save', path=path('recorded.glb'))
        window.run('record')
        with open(path('recorded.glb'), 'rb') as file:
            recorded = file.read()
        os.remove(path('recorded.glb'))
        environment = {key: value for key, value in os.environ.items() if key != 'DISPLAY'}
        subprocess.run([PROGRAM, '--command', script], check=True, env=environment, stdout=subprocess.DEVNULL)
        with open(path('recorded.glb'), 'rb') as file:
            self.assertEqual(file.read(), recorded)


if __name__ == '__main__':
    run_tests()
