# SPDX-License-Identifier: BSD-3-Clause
"""Ways into the window other than its menus: files that are dropped, strokes that are drawn on, keys alone, scripts.

    python3 input_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]

The program that files are dragged from is beside PROGRAM.
"""
import json
import math
import os
import subprocess
import time

import window_case
from window_case import middle, path, PROGRAM, run_tests, setUpModule, tearDownModule, WindowTest


class Dropping(WindowTest):
    def drop(self, window, *files):
        source = subprocess.Popen([os.path.join(os.path.dirname(PROGRAM), 'cagewright_drag_source'), *files],
                                  env=window.environment)
        self.addCleanup(source.kill)
        window.xdotool('search', '--sync', '--onlyvisible', '--name', 'Drag source')
        time.sleep(0.3)
        window.drag([(50, 230), (700, 500)])
        self.assertEqual(source.wait(20), 0)

    def test_a_file_that_is_dropped_is_opened(self):
        window = self.open()
        window.settle()
        self.drop(window, path('biped.glb'))
        state = window.wait_until(lambda s: s.get('slides'), 'the scene with slides is open')
        self.assertIn('biped.glb', state['title'])
        self.assertEqual(len(state['slides']), 17)

    def test_of_several_files_or_what_is_none_the_window_says_so_and_stays_as_it_is(self):
        window = self.open()
        title = window.settle()['title']
        for files in ([path('biped.glb'), path('biped.off')], [window_case.folder]):
            self.drop(window, *files)
            window.wait_until(lambda s: 'Drop one file' in s['status'], 'it says so')
            window.key('q', 'ctrl+shift+a')
            window.wait_until(lambda s: not s['status'], 'and no longer')
        self.assertEqual(window.state()['title'], title)


class Strokes(WindowTest):
    def test_a_stroke_is_drawn_on_from_behind_with_shift(self):
        window = self.open()
        window.settle()
        window.key('alt+s', 'o')  # Complete Stroke: off
        self.assertNotIn('complete_stroke', window.state()['marks'])
        window.run('look', axis='front')
        window.key('d')
        window.drag(list(self.leg(window)[:2]))
        first = window.wait_until(lambda s: len(s['slides']) == 1, 'the stroke makes a slide')
        window.settle()
        window.run('look', axis='back')
        window.settle()
        window.drag(list(reversed(self.leg(window)[:2])), keys=['shift'])
        state = window.wait_until(lambda s: s['undo'] != first['undo'], 'the slide is fitted again')
        self.assertEqual([slide['name'] for slide in state['slides']], [slide['name'] for slide in first['slides']])
        # What it has become is as thick as the shin, whose loop is found here.
        window.run('snap_slides', slides=[state['slides'][0]['name']])
        loop = window.settle()['slides'][0]
        for axis in 'uv':
            self.assertLess(abs(self.length(state['slides'][0][axis]) / self.length(loop[axis]) - 1), 0.3)
        window.key('ctrl+z', 'ctrl+z')
        state = window.wait_until(lambda s: s['undo'] == first['undo'], 'both are taken back')
        self.assertEqual(state['slides'], first['slides'])

    def test_a_slide_much_longer_than_its_stroke_is_pointed_out(self):
        window = self.open()
        window.settle()
        window.run('look', axis='front')
        window.key('d')
        window.drag([self.leg(window, 0.4)[2], self.leg(window, 0.5)[2]])  # along the shin
        window.wait_until(lambda s: len(s['slides']) == 1, 'the stroke makes a slide')
        self.assertRegex(window.state()['status'], r'^slide 1 is \d+\.\d times as long as the stroke: if that is not meant')
        window.key('ctrl+z')
        window.wait_until(lambda s: not s['slides'], 'it is taken back')
        window.drag(list(self.leg(window)[:2]))
        window.wait_until(lambda s: len(s['slides']) == 1, 'the stroke makes a slide')
        self.assertEqual(window.state()['status'], '')

    def test_a_slide_that_was_tilted_is_told_and_what_to_do_where_that_is_not_meant(self):
        window = self.open()
        window.settle()
        begin, end = [0.142, 1.437, 0.03], [0.25, 1.35, 0.03]  # across the shoulder, askew
        stroke = {'stroke': [middle(begin, end, i / 6) for i in range(7)], 'line_of_sight': [0.35, -0.06, -1]}
        self.assertAlmostEqual(window.run('add_slide', **stroke)['tilt'], 20, 6)
        self.assertRegex(window.state()['status'], r'^slide 1 is tilted by 20 degrees, for .* undo \(Ctrl\+Z\) and draw')
        window.key('ctrl+z')
        self.assertEqual(window.wait_until(lambda s: not s['slides'], 'it is taken back')['status'], '')
        # Fitted to the points alone, nothing is tilted.
        knee = [0.138, 0.3, 0]
        ring = [[knee[0] + 0.06 * math.cos(a), knee[1] + 0.03 * math.cos(a), 0.06 * math.sin(a)]
                for a in (math.pi * i / 8 for i in range(16))]
        said = window.run('add_slide', stroke=ring, line_of_sight=[0.3, -0.6, -1], complete=False)
        self.assertNotIn('tilt', said)
        self.assertEqual(window.state()['status'], '')

    def length(self, vector):
        return sum(x * x for x in vector)**0.5


class Keys(WindowTest):
    scene = 'biped.glb'

    def test_the_tabulator_alone_goes_through_the_attributes_and_sets_them(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist'])
        for _ in range(30):
            window.key('Tab')
            if window.state()['focus'] == 'slide_name':
                break
        self.assertEqual(window.state()['focus'], 'slide_name')
        window.key('ctrl+a')
        window.type('belly')
        order = ['slide_centre_0', 'slide_centre_1', 'slide_centre_2', 'slide_rotation_0', 'slide_rotation_1',
                 'slide_rotation_2', 'slide_radii_0', 'slide_radii_1']
        for name in order:
            window.key('Tab')
            self.assertEqual(window.state()['focus'], name)
            if name in ('slide_centre_1', 'slide_radii_1'):
                window.type('1.08' if name == 'slide_centre_1' else '0.25')  # what was there is selected
        window.key('shift+Tab')
        self.assertEqual(window.state()['focus'], 'slide_radii_0')
        belly = next(slide for slide in window.settle()['slides'] if slide['name'] == 'belly')
        self.assertAlmostEqual(belly['center'][1], 1.08, 12)
        self.assertAlmostEqual(sum(x * x for x in belly['v'])**0.5, 0.25, 12)

    def test_slides_are_pasted_into_another_window(self):
        first = self.open()
        first.settle()
        first.run('select', slides=['waist', 'neck'])
        first.key('ctrl+c')
        first.wait_until(lambda s: s['status'] == 'Copied 2 slides', 'they are copied')
        second = self.open('biped.off')
        second.settle()
        second.key('ctrl+v')
        state = second.wait_until(lambda s: len(s['slides']) == 2, 'they are pasted')
        self.assertEqual({slide['name'] for slide in state['slides']}, {'waist', 'neck'})
        copied = {slide['name']: slide for slide in first.state()['slides']}
        for slide in state['slides']:
            for a, b in zip(slide['center'], copied[slide['name']]['center']):
                self.assertAlmostEqual(a, b, 12)


class Replay(WindowTest):
    scene = 'biped.glb'

    def choose(self, window, letter, title, name):
        window.focus('main_window')
        window.key('alt+f', letter)
        window.focus_dialog(title)
        time.sleep(0.3)
        window.type(name)
        window.key('Return')

    def test_what_was_recorded_is_run_again_by_another_window(self):
        window = self.open()
        window.settle()
        script = path('by_menu.jsonl')
        self.choose(window, 'd', 'Record', script)
        window.wait_until(lambda s: 'Recording to by_menu.jsonl' in s['status'], 'it says so')
        window.focus('main_window')
        self.assertIn('record_script', window.state()['marks'])
        window.run('select', slides=['left_knee'])
        window.key('f', 'w')
        window.settle()
        at = window.where(handle=0)
        window.drag([(at['x'], at['y']), (at['x'] + 25, at['y'] + 18)], pause=0.03)
        window.key('Delete')
        window.key('ctrl+z')
        window.run('select', slides=['left_knee'])
        window.key('alt+s', 'a', 'x')
        window.run('show', what='grid', on=False)
        window.settle()
        window.key('alt+f', 'd')
        recorded = window.wait_until(lambda s: 'recording is ended' in s['status'], 'it says so')
        self.assertNotIn('record_script', recorded['marks'])
        window.close()
        again = self.open('biped.off')
        again.settle()
        self.choose(again, 'u', 'Run a script', script)
        again.wait_until(lambda s: 'Ran ' in s['status'] and 'by_menu.jsonl' in s['status'], 'it says so')
        state = again.settle()
        self.assertEqual(state['slides'], recorded['slides'])
        self.assertEqual(len(state['slides']), 18)
        self.assertNotIn('show_grid', state['marks'])

    def test_a_script_that_cannot_be_run_names_its_line(self):
        with open(path('wrong.jsonl'), 'w') as file:
            file.write('# a comment\n{"command": "select", "slides": ["waist"]}\n{"command": "no such"}\n')
        window = self.open()
        window.settle()
        self.choose(window, 'u', 'Run a script', path('wrong.jsonl'))
        window.focus_dialog('The script stopped')
        window.click_widget('OK')
        state = window.wait_until(lambda s: 'Stopped after 1 of 2 commands of wrong.jsonl' in s['status'], 'it says so')
        self.assertEqual(state['selection'], ['waist'])

    def test_a_script_that_works_for_long_can_be_cancelled_and_the_window_answers_meanwhile(self):
        frames = path('frames_of_script')
        with open(path('long.jsonl'), 'w') as file:
            for command in ({'command': 'remove_slides', 'slides': ['neck']}, {'command': 'wait'},
                            {'command': 'turntable', 'folder': frames, 'frames': 300}):
                file.write(json.dumps(command) + '\n')
        window = self.open()
        before = window.settle()
        self.choose(window, 'u', 'Run a script', path('long.jsonl'))
        deadline = time.monotonic() + 60
        while not (os.path.isdir(frames) and len(os.listdir(frames)) > 1):
            self.assertLess(time.monotonic(), deadline, 'no frames were drawn')
            time.sleep(0.1)
        asked = time.monotonic()
        window.state()
        self.assertLess(time.monotonic() - asked, 3, 'the window did not answer')
        window.shot('script_runs')
        window.click_widget('Cancel')
        state = window.wait_until(lambda s: 'Stopped after 2 of 3 commands of long.jsonl' in s['status'], 'it says so')
        self.assertEqual(len(state['slides']), len(before['slides']) - 1)
        self.assertLess(len(os.listdir(frames)), 300)
        window.focus('main_window')
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == len(before['slides']), 'Undo takes back what it did')


if __name__ == '__main__':
    run_tests()
