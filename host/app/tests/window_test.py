# SPDX-License-Identifier: BSD-3-Clause
"""The window, steered by mouse and keyboard as a person would, and looked at.

    python3 window_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from random import Random

from window_driver import SCREEN, Server, Window, is_green, is_red, is_selected

PROGRAM, TESTDATA, SLIDES, SCENES = sys.argv[1:5] if len(sys.argv) > 4 else [''] * 4


def setUpModule():
    global server, folder
    server = Server()
    folder = tempfile.mkdtemp(prefix='cagewright-window-test-')
    subprocess.run([TESTDATA, folder, '--only', 'biped'], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([PROGRAM, 'cage', path('biped.off'), '--slides', os.path.join(SLIDES, 'biped.slides.json'), '-o',
                    path('biped.glb'), '--quiet'], check=True, stdout=subprocess.DEVNULL)


def tearDownModule():
    server.close()
    shutil.rmtree(folder, ignore_errors=True)


def path(name):
    return os.path.join(folder, name)


def middle(a, b, share=0.5):
    return [x + share * (y - x) for x, y in zip(a, b)]


class WindowTest(unittest.TestCase):
    scene = 'biped.off'

    def setUp(self):
        """Windows are killed: on a slow machine an autosave is left, and the next test would be asked to recover it."""
        for left in glob.glob(path('.*.autosave.glb')):
            os.remove(left)

    def open(self, name=None, *arguments, **options):
        window = Window(server, PROGRAM, path(name or self.scene), *arguments, **options)
        self.addCleanup(window.close)
        return window

    def leg(self, window, share=0.5):
        """Two points of the screen beside the left shin, left and right of it, and one on it."""
        knee, ankle = [0.138, 0.51, 0.018], [0.16, 0.12, -0.01]
        at = window.where(point=middle(knee, ankle, share))
        beside = window.where(point=middle([knee[0] + 0.06, *knee[1:]], [ankle[0] + 0.06, *ankle[1:]], share))
        reach = abs(beside['x'] - at['x'])
        return (at['x'] - reach * 0.5, at['y']), (at['x'] + reach * 0.5, at['y']), (at['x'], at['y'])


class Looking(WindowTest):
    scene = 'biped.glb'

    def test_shows_slides_red_and_sections_green_and_hides_them(self):
        window = self.open()
        window.settle()
        view = window.view()
        shot = window.shot('scene')
        self.assertGreater(shot.count(view, is_red), 200)
        self.assertGreater(shot.count(view, is_green), 200)
        window.run('show', what='slides', on=False)
        window.run('show', what='sections', on=False)
        bare = window.shot()
        self.assertLess(bare.count(view, is_red), 60)  # an axis in the corner
        self.assertLess(bare.count(view, is_green), 60)

    def test_shows_a_certified_cage(self):
        window = self.open()
        state = window.settle()
        self.assertTrue(state['cage']['certified'])
        self.assertEqual(state['problems'], [])
        view = window.view()
        with_cage = window.shot()
        window.run('show', what='cage', on=False)
        self.assertGreater(with_cage.differs(window.shot(), view), 5000)

    def test_alt_and_mouse_move_the_camera_as_maya_does(self):
        window = self.open()
        window.settle()
        x, y, width, height = window.view()
        middle_of_view = (x + width / 2, y + height / 2)
        for button in (1, 2, 3):
            before = window.shot()
            window.drag([middle_of_view, (middle_of_view[0] + 90, middle_of_view[1] + 25)], button=button, keys=['alt'])
            self.assertGreater(window.shot('camera_%d' % button).differs(before, window.view()), 5000, button)
        before = window.shot()
        window.click(*middle_of_view, button=4)
        self.assertGreater(window.shot().differs(before, window.view()), 2000)
        window.key('a')
        framed = window.shot('framed')
        self.assertGreater(framed.count(window.view(), is_red), 100)

    def test_keys_change_what_is_drawn(self):
        window = self.open()
        window.settle()
        view = window.view()
        shots = {}
        for key in ('5', '4', '7', '8', '6'):
            window.key(key)
            shots[key] = window.shot('key_' + key)
            window.key('5')
        self.assertGreater(shots['4'].differs(shots['5'], view), 3000)
        self.assertGreater(shots['7'].differs(shots['5'], view), 3000)

    def test_looks_from_all_sides_and_without_perspective(self):
        window = self.open()
        window.settle()
        front = window.run('look', axis='front') and window.shot()
        top = window.run('look', axis='top') and window.shot('top')
        self.assertGreater(front.differs(top, window.view()), 5000)
        window.run('projection', orthographic=True)
        self.assertGreater(window.shot().differs(top, window.view()), 500)


class Drawing(WindowTest):
    def test_a_stroke_across_a_limb_is_a_slide_and_the_cage_follows_the_mouse(self):
        window = self.open()
        window.settle()
        window.key('d')
        left, right, _ = self.leg(window)
        view = window.view()
        window.drag([left, right], pause=0.03, release=False)
        followed = window.wait_until(lambda s: s['cage']['is_of_editing'], 'the cage follows the stroke', 20)
        self.assertEqual(followed['slides'], [])
        self.assertGreater(window.shot('stroke').count(view, lambda r, g, b: r > 170 and g < 150 and b < 150), 20)
        window.release()
        state = window.settle()
        self.assertEqual(len(state['slides']), 1)
        self.assertTrue(state['cage']['certified'], state)
        # Round the shin: as thick as that, and across it.
        slide = state['slides'][0]
        self.assertLess(max(map(abs, slide['u'])), 0.1)
        self.assertLess(abs(slide['u'][1]), 0.04)
        self.assertGreater(window.shot('slide').count(view, is_red), 20)
        self.assertIn('slide', state['undo'])

    def test_a_click_is_a_slide_across_the_limb(self):
        window = self.open()
        window.settle()
        window.key('d')
        window.click(*self.leg(window)[2])
        state = window.wait_until(lambda s: len(s['slides']) == 1, 'a click makes a slide')
        u, v = state['slides'][0]['u'], state['slides'][0]['v']
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        self.assertGreater(abs(normal[1]), 0.9 * sum(x * x for x in normal)**0.5)

    def test_escape_gives_a_stroke_up(self):
        window = self.open()
        window.settle()
        window.key('d')
        left, right, _ = self.leg(window)
        window.drag([left, right], release=False)
        window.key('Escape')
        time.sleep(0.5)
        window.release()
        state = window.settle()
        self.assertEqual(state['slides'], [])
        self.assertEqual(state['undo'], '')

    def test_a_stroke_may_begin_and_end_beside_the_limb(self):
        window = self.open()
        window.settle()
        window.key('d')
        left, right, middle_of_leg = self.leg(window)
        reach = 2.2 * (middle_of_leg[0] - left[0])
        window.drag([(middle_of_leg[0] - reach, left[1]), (middle_of_leg[0] + reach, left[1])])
        state = window.wait_until(lambda s: len(s['slides']) == 1, 'the stroke makes a slide')
        self.assertLess(max(map(abs, state['slides'][0]['u'])), 0.1)

    def test_a_stroke_that_misses_the_model_says_so_and_the_right_button_turns(self):
        window = self.open()
        window.settle()
        window.key('d')
        x, y, width, height = window.view()
        path_beside = [(x + 30, y + height - 30), (x + 200, y + height - 60)]
        window.drag(path_beside)
        state = window.wait_until(lambda s: s['status'], 'it says so')
        self.assertIn('misses the model', state['status'])
        self.assertEqual(state['slides'], [])
        before = window.shot()
        window.drag(path_beside, button=3)
        self.assertGreater(window.shot().differs(before, window.view()), 3000)

    def test_undo_and_redo_by_keys(self):
        window = self.open()
        window.settle()
        window.key('d')
        for share in (0.3, 0.7):
            window.drag(list(self.leg(window, share)[:2]))
            window.settle()
        self.assertEqual(len(window.state()['slides']), 2)
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == 1, '1 slides')
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == 0, '0 slides')
        window.key('ctrl+shift+z')
        window.key('ctrl+y')
        window.wait_until(lambda s: len(s['slides']) == 2, '2 slides')


class Editing(WindowTest):
    scene = 'biped.glb'

    def select(self, window, name):
        window.run('select', slides=[name])
        window.run('frame', what='selection')
        window.settle()

    def slide(self, state, name):
        return next(slide for slide in state['slides'] if slide['name'] == name)

    def test_a_click_selects_a_slide_in_the_view(self):
        window = self.open()
        window.settle()
        slide = self.slide(window.state(), 'waist')
        window.key('q')
        at = window.where(point=[c + u for c, u in zip(slide['center'], slide['u'])])
        window.click(at['x'], at['y'])
        window.wait_until(lambda s: s['selection'] == ['waist'], 'selected')
        self.assertGreater(window.shot('selected').count(window.view(), is_selected), 20)

    def test_the_cage_follows_a_drag_and_its_speed_is_shown(self):
        window = self.open()
        window.settle()
        self.select(window, 'left_knee')
        window.run('show', what='speed', on=True)
        window.key('w')
        time.sleep(0.3)
        at = window.where(handle=2)
        path = [(at['x'] + 3 * (i % 2), at['y'] + 2 * (i % 3)) for i in range(40)]
        window.drag(path, pause=0.02, release=False)
        state = window.wait_until(lambda s: s['speed']['cages'] > 3, 'cages follow')
        self.assertTrue(state['cage']['is_of_editing'])
        self.assertGreater(state['speed']['per_second'], 1)
        self.assertGreater(state['speed']['percentile_95_ms'], state['speed']['frame_ms'] / 2)
        time.sleep(0.6)
        self.assertRegex(window.where(widget='speed')['text'], r'^cage \d+/s, \d+ ms \(95 %: \d+ ms\), frame \d+ ms$')
        window.shot('speed')
        window.release()
        self.assertTrue(window.settle()['cage']['certified'])
        self.assertGreater(window.state()['speed']['cages'], 3)

    def test_a_drag_of_a_handle_moves_the_slide_in_one_step_of_undo(self):
        window = self.open()
        window.settle()
        self.select(window, 'left_knee')
        before = self.slide(window.state(), 'left_knee')
        window.key('w')
        time.sleep(0.3)
        moved = None
        for handle in range(3):
            at = window.where(handle=handle)
            window.drag([(at['x'], at['y']), (at['x'] + 25, at['y'] + 18)], pause=0.03)
            state = window.settle()
            moved = self.slide(state, 'left_knee')
            if moved['center'] != before['center']:
                break
        window.shot('moved')
        self.assertNotEqual(moved['center'], before['center'])
        self.assertIn('move', state['undo'])
        window.key('ctrl+z')
        window.wait_until(lambda s: self.slide(s, 'left_knee')['center'] == before['center'], 'undone')

    def test_keys_delete_and_duplicate_and_mirror(self):
        window = self.open()
        window.settle()
        count = len(window.state()['slides'])
        self.select(window, 'left_knee')
        window.key('ctrl+d')
        window.wait_until(lambda s: len(s['slides']) == count + 1, 'a copy')
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == count, 'no copy')
        window.run('select', slides=['left_knee'])
        window.key('Delete')
        window.wait_until(lambda s: len(s['slides']) == count - 1, 'one less')
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == count, 'as many')
        window.run('remove_slides', slides=['right_knee'])
        window.run('select', slides=['left_knee'])
        window.key('m')
        state = window.wait_until(lambda s: len(s['slides']) == count, 'a mirrored one')
        self.assertLess(min(slide['center'][0] for slide in state['slides']
                            if abs(slide['center'][1] - 0.51) < 0.03), -0.05)

    def test_numbers_in_the_attribute_editor_move_a_slide(self):
        window = self.open()
        window.settle()
        self.select(window, 'waist')
        field = window.where(widget='slide_centre_1')
        window.click(field['x'] + 10, field['y'] + field['height'] / 2)
        window.key('ctrl+a')
        window.type('1.08')
        window.key('Return')
        window.wait_until(lambda s: abs(self.slide(s, 'waist')['center'][1] - 1.08) < 1e-4, 'the number counts')

    def test_keys_undo_and_redo_a_random_session_to_the_same_files(self):
        random = Random(6)
        window = self.open()

        def saved():
            window.settle()
            window.run('save_copy', path=path('session.glb'))
            with open(path('session.glb'), 'rb') as file:
                return file.read()

        def any_slide():
            return random.choice(window.state()['slides'])['name']

        def some_cut():
            at = random.choice(window.state()['slides'])
            return dict(point=at['center'], normal=[random.uniform(-1, 1), 1, 0])

        commands = {
            'rename_slide': lambda: dict(slide=any_slide(), name='cut %d' % random.randint(0, 99)),
            'change_slide': lambda: dict(slide=any_slide(), move=[0, random.uniform(-0.01, 0.01), 0]),
            'duplicate_slides': lambda: dict(slides=[any_slide()]),
            'mirror_slides': lambda: dict(slides=[any_slide()]),
            'remove_slides': lambda: dict(slides=[any_slide()]),
            'snap_slides': lambda: dict(slides=[any_slide()]),
            'add_slide': some_cut,
            'set_parameter': lambda: dict(id='orient.lambda', value=random.choice([0, 2, 4, 8])),
            'reset_parameters': dict,
        }
        begin, steps = saved(), 0
        while steps < 24:
            name = random.choice(list(commands))
            steps += window.ask(command=name, **commands[name]())['ok']
        # Slides that have a cage.
        window.run('reset_parameters')
        window.run('remove_slides', slides=[slide['name'] for slide in window.state()['slides']])
        window.run('add_slide', name='knee', point=[0.138, 0.51, 0.018], normal=[0, 1, 0])
        end = saved()
        self.assertTrue(window.state()['cage']['is_of_now'])
        for key, label, expected in (('ctrl+z', 'undo', begin), ('ctrl+shift+z', 'redo', end)):
            presses = 0
            while window.state()[label]:
                window.key(key)
                presses += 1
                self.assertLess(presses, 100)
            self.assertGreater(presses, 12)
            self.assertTrue(saved() == expected, key)

    def test_copies_go_to_another_scene(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist', 'neck'])
        window.key('ctrl+c')
        window.run('open', path=path('biped.off'))
        window.settle()
        window.focus('main_window')
        window.key('ctrl+v')
        window.wait_until(lambda s: sorted(slide['name'] for slide in s['slides']) == ['neck', 'waist'], 'pasted')


class Problems(WindowTest):
    scene = 'biped.glb'

    def test_a_failing_slide_is_marked_where_it_is_and_the_last_good_cage_stays(self):
        window = self.open()
        good = window.settle()
        waist = next(slide for slide in good['slides'] if slide['name'] == 'waist')
        before = window.shot()
        # Tilted against the waist's: their loops cross.
        window.run('add_slide', name='tilted', point=waist['center'], normal=[0.35, 1, 0])
        state = window.settle()
        self.assertTrue(state['cage']['failed'])
        self.assertEqual(state['cage']['triangles'], good['cage']['triangles'])
        named = {name for problem in state['problems'] for name in problem['slides']}
        self.assertEqual(named, {'tilted', 'waist'})
        self.assertIn("'tilted'", state['problems'][0]['sentence'])
        shot = window.shot('problem')
        self.assertGreater(shot.differs(before, window.view()), 300)
        at = window.where(widget='problems')
        window.click(at['x'] + 40, at['y'] + 12)
        window.wait_until(lambda s: set(s['selection']) == named, 'both are selected')
        self.assertGreater(window.shot('problem_framed').differs(shot, window.view()), 5000)
        window.key('ctrl+z')
        window.wait_until(lambda s: not s['problems'] and not s['cage']['failed'], 'undo takes the problem away')


class Scenes(WindowTest):
    def open_scene(self, name):
        window = Window(server, PROGRAM, os.path.join(SCENES, name))
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

    def test_what_the_plugin_would_know_survives_without_it(self):
        window = Window(server, PROGRAM, environment={'CAGEWRIGHT_PLUGIN': path('none.so')})
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
        end = time.monotonic() + 20
        while not os.path.exists(saved) and time.monotonic() < end:
            time.sleep(0.1)
        time.sleep(0.5)
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
        server.release(1)
        left = autosaved()
        expect_saved(left)
        again = self.open('killed.glb', home=home)
        again.focus_dialog('Recover')
        again.click_widget('Yes')
        state = again.wait_until(lambda s: s['slides'], 'recovered')
        self.assertIn('edit %d' % left, [slide['name'] for slide in state['slides']])

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
    unittest.main(argv=sys.argv[:1] + sys.argv[5:], verbosity=2)
