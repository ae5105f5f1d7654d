# SPDX-License-Identifier: BSD-3-Clause
"""Scenes, files and what goes on round them in the window, by mouse and keyboard.

    python3 session_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import os
import re
import shutil
import subprocess
import tempfile
import time
from random import Random

import window_case
from window_case import path, PROGRAM, run_tests, SCENES, setUpModule, tearDownModule, WindowTest
from window_driver import Window, is_red


def read(name):
    with open(name, 'rb') as file:
        return file.read()


class Scenes(WindowTest):
    def open_scene(self, name):
        copies = path('scenes')  # a window leaves locks and autosaves beside its scene
        shutil.copytree(SCENES, copies, dirs_exist_ok=True)
        window = Window(window_case.server, PROGRAM, os.path.join(copies, name))
        self.addCleanup(window.close)
        window.settle()
        return window

    def test_a_double_click_in_the_outliner_chooses_the_mesh_to_cage(self):
        window = self.open_scene('slides_two_caged_meshes.gltf')
        first = window.state()
        outliner = window.where(widget='outliner')
        for row in range(1, 12):  # until the row of the other mesh is hit
            y = outliner['y'] + 14 + 17 * row
            window.move(outliner['x'] + 60, y)
            window.xdotool('click', '--repeat', 2, '--delay', 60, 1)
            state = window.settle()
            if state['mesh'] != first['mesh']:
                break
        self.assertNotEqual(state['mesh'], first['mesh'])
        self.assertNotEqual([slide['center'] for slide in state['slides']],
                            [slide['center'] for slide in first['slides']])
        self.assertGreater(window.shot('two_meshes').count(window.view(), is_red), 20)

    def test_slides_are_where_their_node_is(self):
        for name in ('nodes_non_uniform_scale.gltf', 'nodes_negative_scale.gltf', 'nodes_matrix.gltf'):
            with self.subTest(name):
                window = self.open_scene(name)
                window.run('add_slide', name='cut', center=[0, 0, 0], u=[0.6, 0, 0], v=[0, 0, 0.6])
                window.settle()
                slide = window.state()['slides'][0]
                at = window.where(point=[c + u for c, u in zip(slide['center'], slide['u'])])
                window.run('select', slides=[])
                shot = window.shot('placed_' + name)
                self.assertGreater(shot.count((at['x'] - 6, at['y'] - 6, 13, 13), is_red), 3)
                window.close()

    def test_a_file_that_another_has_written_is_not_written_over_unasked(self):
        scene = path('shared.glb')
        shutil.copy(path('biped.glb'), scene)
        window = self.open('shared.glb')
        window.run('remove_slides', slides='neck')
        window.settle()
        time.sleep(0.01)
        shutil.copy(path('biped.glb'), scene)
        theirs = read(scene)
        window.key('ctrl+s')
        time.sleep(0.5)
        window.focus_dialog('Changed by another')
        window.key('Return')  # No is what is offered
        time.sleep(0.3)
        self.assertEqual(read(scene), theirs)
        window.focus('main_window')
        window.key('ctrl+s')
        time.sleep(0.5)
        window.focus_dialog('Changed by another')
        window.key('alt+y')
        window.wait_until(lambda s: s['saved'], 'written over')
        self.assertNotEqual(read(scene), theirs)
        window.focus('main_window')
        window.run('undo')
        window.key('ctrl+s')
        window.wait_until(lambda s: s['saved'], 'its own file is saved unasked')

    def test_a_scene_that_another_has_written_can_be_saved_under_another_name(self):
        scene = path('theirs.glb')
        shutil.copy(path('biped.glb'), scene)
        window = self.open('theirs.glb')
        window.settle()
        window.run('remove_slides', slides=['neck'])
        window.settle()
        time.sleep(0.05)
        shutil.copy(path('biped.glb'), scene)
        window.key('ctrl+s')
        window.focus_dialog('Changed by another')
        window.shot('changed_by_another')
        window.click_widget('Save As ...')
        window.focus_dialog('Save as')
        window.wait_until(lambda s: s['focus'] == 'fileNameEdit', 'a name can be typed')
        window.key('ctrl+a')
        window.type(path('mine.glb'))
        window.key('Return')
        window.wait_until(lambda s: s['status'] == 'Saved mine.glb', 'it is saved there')
        self.assertEqual(read(scene), read(path('biped.glb')))

    def test_a_scene_that_cannot_be_opened_is_said_on_the_terminal_too(self):
        with open(path('text.glb'), 'w') as file:
            file.write('not a scene')
        window = Window(window_case.server, PROGRAM, path('text.glb'), errors=subprocess.PIPE)
        self.addCleanup(window.close)
        self.assertFalse(window.state()['has_scene'])
        window.process.kill()
        said = window.process.stderr.read().decode()
        window.process.stderr.close()
        self.assertRegex(said, r'(?m)^cagewright: .*text\.glb')

    def test_a_slide_beyond_all_bounds_does_not_take_the_view_along(self):
        window = self.open('biped.glb')
        window.settle()
        window.key('a')
        before = window.shot('before_far')
        view = window.view()
        window.run('change_slide', slide='neck', center=[1e300, 0, 0])
        window.settle()
        window.key('a')
        window.run('undo')
        window.settle()
        window.key('a')
        window.settle()
        self.assertLess(window.shot('after_far').differs(before, view), 0.01 * view[2] * view[3])

    def test_what_the_plugin_would_know_survives_without_it(self):
        window = Window(window_case.server, PROGRAM, environment={'CAGEWRIGHT_PLUGIN': path('none.so')})
        self.addCleanup(window.close)
        window.run('open', path=path('biped.glb'))
        state = window.settle()
        self.assertEqual(len(state['slides']), 17)
        window.run('save', path=path('without.glb'))
        with open(path('biped.glb'), 'rb') as before, open(path('without.glb'), 'rb') as after:
            self.assertEqual(after.read(), before.read())


class Files(WindowTest):
    scene = 'biped.glb'

    def test_saves_what_was_drawn_and_reads_it_again(self):
        shutil.copy(path('biped.glb'), path('mine.glb'))
        window = self.open('mine.glb')
        window.settle()
        window.run('remove_slides', slides=['brow'])
        self.assertIn('*', window.state()['title'])
        window.key('ctrl+s')
        state = window.wait_until(lambda s: s['saved'], 'ctrl+s saves')
        self.assertNotIn('*', state['title'])
        window.close()
        again = self.open('mine.glb')
        self.assertNotIn('brow', [slide['name'] for slide in again.settle()['slides']])

    def test_asks_before_changes_are_lost(self):
        shutil.copy(path('biped.glb'), path('asked.glb'))
        window = self.open('asked.glb')
        window.settle()
        window.run('remove_slides', slides=['brow'])
        window.key('ctrl+q')
        window.click_widget('Cancel')
        self.assertIn('*', window.state()['title'])
        window.focus('main_window')
        window.key('ctrl+q')
        time.sleep(0.5)
        window.click_widget("Don't Save") if self.has_widget(window, "Don't Save") else window.click_widget('Discard')
        self.assertEqual(window.process.wait(20), 0)

    def has_widget(self, window, name):
        return window.ask(command='where', widget=name)['ok']

    def test_recovers_what_was_not_saved_after_a_crash(self):
        shutil.copy(path('biped.glb'), path('crashed.glb'))
        home = tempfile.mkdtemp(prefix='cagewright-home-')
        self.addCleanup(shutil.rmtree, home, True)
        window = self.open('crashed.glb', home=home, environment={'CAGEWRIGHT_AUTOSAVE_MS': '300'})
        window.settle()
        window.run('remove_slides', slides=['brow'])
        saved = path('.crashed.glb.autosave.glb')
        self.wait_for_file(saved)
        window.crash()
        again = self.open('crashed.glb', home=home)
        again.focus_dialog('Recover')
        again.click_widget('Yes')
        state = again.settle()
        self.assertNotIn('brow', [slide['name'] for slide in state['slides']])
        self.assertFalse(state['saved'])
        again.focus('main_window')
        again.key('ctrl+s')
        again.wait_until(lambda s: s['saved'], 'the recovered scene is saved')
        self.assertFalse(os.path.exists(saved))

    def test_what_a_window_still_has_open_is_not_offered_to_another_as_if_it_had_crashed(self):
        shutil.copy(path('biped.glb'), path('shared.glb'))
        saved = path('.shared.glb.autosave.glb')

        def slides(window):
            return [slide['name'] for slide in window.settle()['slides']]

        quick = {'CAGEWRIGHT_AUTOSAVE_MS': '300'}
        first = self.open('shared.glb', environment=quick)
        first.settle()
        first.run('remove_slides', slides=['brow'])
        self.wait_for_file(saved)
        with open(saved, 'rb') as file:
            left = file.read()
        second = self.open('shared.glb', environment=quick)
        self.assertIn('brow', slides(second))  # as it was saved, without a question
        state = second.state()
        self.assertIn('open in another window', state['title'])
        self.assertIn('shared.glb is open in another window', state['status'])
        self.assertNotIn('another', first.state()['title'])
        # The second one does not touch what the first one has written.
        second.run('remove_slides', slides=['waist'])
        time.sleep(1)
        with open(saved, 'rb') as file:
            self.assertEqual(file.read(), left)
        # A name of its own is nobody else's.
        second.run('save', path=path('own.glb'))
        self.assertNotIn('another', second.state()['title'])
        second.run('remove_slides', slides=['neck'])
        self.wait_for_file(path('.own.glb.autosave.glb'))
        second.close()
        # What has crashed is offered, also though its lock is still there.
        self.assertTrue(os.path.exists(path('.shared.glb.lock')))
        first.crash()
        again = self.open('shared.glb')
        again.focus_dialog('Recover')
        again.click_widget('Yes')
        self.assertNotIn('brow', slides(again))
        self.assertNotIn('another', again.state()['title'])

    def test_the_autosave_is_the_second_windows_when_the_first_is_closed(self):
        shutil.copy(path('biped.glb'), path('passed.glb'))
        first = self.open('passed.glb')
        first.settle()
        second = self.open('passed.glb', environment={'CAGEWRIGHT_AUTOSAVE_MS': '300'})
        second.settle()
        second.run('remove_slides', slides=['brow'])
        time.sleep(1)
        self.assertFalse(os.path.exists(path('.passed.glb.autosave.glb')))
        first.focus('main_window')
        first.key('ctrl+q')
        self.assertEqual(first.process.wait(20), 0)
        self.wait_for_file(path('.passed.glb.autosave.glb'))
        self.assertNotIn('another window', second.state()['title'])

    def test_what_a_window_that_crashed_has_left_is_put_aside_by_one_that_goes_on(self):
        shutil.copy(path('biped.glb'), path('left.glb'))
        often = {'CAGEWRIGHT_AUTOSAVE_MS': '300'}
        first = self.open('left.glb', environment=often)
        first.settle()
        second = self.open('left.glb', environment=often)
        second.settle()
        first.run('remove_slides', slides=['brow'])
        self.wait_for_file(path('.left.glb.autosave.glb'))
        first.crash()
        left = read(path('.left.glb.autosave.glb'))
        second.run('remove_slides', slides=['neck'])
        self.wait_for_file(path('left_recovered_1.glb'))
        self.assertEqual(read(path('left_recovered_1.glb')), left)
        self.wait_for_file(path('.left.glb.autosave.glb'))
        self.assertRegex(second.state()['status'], 'another window ended .* is in left_recovered_1.glb now')
        self.assertNotIn('another window', second.state()['title'])

    def wait_for_file(self, name):
        end = time.monotonic() + 20
        while not os.path.exists(name):
            self.assertLess(time.monotonic(), end, name)
            time.sleep(0.1)
        time.sleep(0.5)

    def test_killed_at_any_time_it_has_lost_no_more_than_the_last_five_seconds(self):
        seed = int.from_bytes(os.urandom(4), 'little')
        random = Random(seed)
        shutil.copy(path('biped.glb'), path('killed.glb'))
        home = tempfile.mkdtemp(prefix='cagewright-home-')
        self.addCleanup(shutil.rmtree, home, True)
        window = self.open('killed.glb', home=home)
        window.settle()
        window.run('set_parameter', id='refine.delta', value=0.03)  # slow: a cage is being made all the time
        window.run('select', slides=['left_knee'])
        window.run('frame', what='selection')
        window.key('w')
        time.sleep(0.3)
        done = []  # when each edit was done

        def expect_saved(edit):
            now = time.monotonic()
            needed = sum(1 for when in done if when < now - 5)
            self.assertGreaterEqual(edit, needed, 'seed %d, at %g: %r' % (seed, now, done))

        def autosaved():
            if not os.path.exists(path('.killed.glb.autosave.glb')):
                return 0
            with open(path('.killed.glb.autosave.glb'), 'rb') as file:
                return max([int(number) for number in re.findall(rb'"edit (\d+)"', file.read())], default=0)

        at = window.where(handle=0)
        end = time.monotonic() + random.uniform(7, 9)
        while time.monotonic() < end:
            before = 'edit %d' % len(done) if done else 'brow'
            window.run('rename_slide', slide=before, name='edit %d' % (len(done) + 1))
            done.append(time.monotonic())
            window.drag([(at['x'], at['y']), (at['x'] + random.randint(-9, 9), at['y'] + 9)])
            expect_saved(autosaved())
        # Killed while the mouse is down.
        at = window.where(handle=0)
        window.drag([(at['x'], at['y']), (at['x'] + 9, at['y'])], release=False)
        end = time.monotonic() + random.uniform(0, 4)
        while time.monotonic() < end:
            window.move(at['x'] + random.randint(-20, 20), at['y'] + random.randint(-20, 20))
            expect_saved(autosaved())
        window.crash()
        window_case.server.release(1)
        left = autosaved()
        expect_saved(left)
        again = self.open('killed.glb', home=home)
        again.focus_dialog('Recover')
        again.click_widget('Yes')
        state = again.wait_until(lambda s: s.get('slides'), 'recovered')
        self.assertIn('edit %d' % left, [slide['name'] for slide in state['slides']])


class Working(WindowTest):
    def test_the_window_answers_while_a_cage_is_made_and_cancel_stops_it(self):
        window = self.open('biped.glb')
        window.settle()
        window.run('set_parameter', id='refine.delta', value=0.05)  # slow: seconds
        slowest = 0
        for _ in range(10):
            begin = time.monotonic()
            state = window.state()
            slowest = max(slowest, time.monotonic() - begin)
            time.sleep(0.02)
        self.assertTrue(state['solving'])
        self.assertLess(slowest, 0.5)
        window.key('Escape')
        begin = time.monotonic()
        window.wait_until(lambda s: not s['solving'], 'cancelled', 10)
        self.assertLess(time.monotonic() - begin, 3)
        window.key('ctrl+z')
        window.wait_until(lambda s: s['cage']['certified'] and s['cage']['is_of_now'], 'certified again')

    def test_a_command_that_cannot_be_run_is_answered_by_a_sentence_of_ours(self):
        window = self.open('biped.glb')
        window.settle()
        refusals = [({'handle': 0}, 'take the tool'), ({'handle': -1}, 'no handle -1'), ({'handle': 'x'}, 'no handle'),
                    ({'point': [0, 1]}, '[x, y, z]'), ({'widget': 7}, 'a name'), ({'widget': 'none'}, 'no such widget')]
        for arguments, words in refusals:
            with self.subTest(arguments):
                error = window.ask(command='where', **arguments)['error']
                self.assertIn(words, error)
                self.assertNotIn('[json', error)
        window.run('select', slides=['waist'])
        window.key('w')
        time.sleep(0.3)
        self.assertIn('from 0 to', window.ask(command='where', handle=99)['error'])
        for line in ('{"command":', '[]', '{"command": 7}'):
            self.assertIn('a JSON object on one line', window.ask_line(line)['error'])

    def test_a_parameter_is_set_by_its_field(self):
        window = self.open('biped.glb')
        window.settle()
        tabs = window.where(widget='tabs')
        window.click(tabs['x'] + 75, tabs['y'] + 12)  # the second tab
        field = window.where(widget='refine.delta')
        window.click(field['x'] + 10, field['y'] + field['height'] / 2)
        window.key('ctrl+a')
        window.type('0.01')
        window.key('Return')
        state = window.wait_until(lambda s: 'set' in s['undo'], 'the field sets the parameter')
        window.key('Escape')
        window.settle()

    def test_a_plugin_in_use_is_not_unloaded(self):
        window = self.open('biped.glb')
        window.settle()
        answer = window.ask(command='unload_plugin')
        self.assertFalse(answer['ok'])
        self.assertIn('close', answer['error'])
        window.run('close')
        self.assertTrue(window.ask(command='unload_plugin')['ok'])
        window.run('open', path=path('biped.glb'))
        self.assertEqual(len(window.settle()['slides']), 17)

    def test_ceres_checks_the_scene_in_a_process_of_its_own(self):
        window = self.open('biped.glb')
        window.settle()
        window.key('alt+c', 'v')
        time.sleep(0.5)
        seconds = window.where(widget='validation_seconds')
        window.focus_dialog('Validate')
        window.click(seconds['x'] + 20, seconds['y'] + seconds['height'] / 2)
        window.key('ctrl+a', '0', 'Tab')
        window.click_widget('validation_start')
        end = time.monotonic() + 120
        while 'Done' not in (text := window.where(widget='validation_text').get('text', '')):
            self.assertLess(time.monotonic(), end, text)
            window.state()
            time.sleep(0.2)
        window.shot('validated')
        self.assertIn('Ceres agrees', text)
        # Again, and stopped; then closed.
        window.focus_dialog('Validate')
        window.click(seconds['x'] + 20, seconds['y'] + seconds['height'] / 2)
        window.key('ctrl+a', '9', '9', 'Tab')
        window.click_widget('validation_start')
        time.sleep(1)
        self.assertEqual(window.where(widget='validation_start')['text'].replace('&', ''), 'Stop')
        window.click_widget('validation_start')
        window.wait_until(lambda s: 'Start' in window.where(widget='validation_start')['text'].replace('&', ''),
                          'it is stopped', 20)
        self.assertNotIn('agrees', window.where(widget='validation_text')['text'])
        window.click_widget('Close')
        window.wait_until(lambda s: not window.ask(command='where', widget='validation_text')['ok'], 'it is closed')

    def test_says_one_sentence_where_there_is_no_display(self):
        environment = {key: value for key, value in os.environ.items() if key != 'DISPLAY'}
        run = subprocess.run([PROGRAM, 'view', path('biped.off')], env=environment, stderr=subprocess.PIPE,
                             stdout=subprocess.PIPE, timeout=30)
        self.assertEqual(run.returncode, 3)
        self.assertEqual(run.stderr.count(b'\n'), 1)
        self.assertIn(b'DISPLAY', run.stderr)

    def test_hints_and_first_help_are_shown_until_the_first_slide(self):
        window = self.open('biped.off')
        window.settle()
        self.assertTrue(window.ask(command='where', widget='help')['ok'])
        window.key('d')  # what is drawn on must be seen
        self.assertFalse(window.ask(command='where', widget='help')['ok'])
        window.key('q')
        self.assertTrue(window.ask(command='where', widget='help')['ok'])
        window.run('add_slide', point=[0.138, 0.3, 0.05])
        window.settle()
        self.assertFalse(window.ask(command='where', widget='help')['ok'])


if __name__ == '__main__':
    run_tests()
