# SPDX-License-Identifier: BSD-3-Clause
"""Slides in the window, steered by mouse and keyboard as a person would, and looked at.

    python3 slides_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import time
from random import Random

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest
from window_driver import is_green, is_red, is_selected


class Looking(WindowTest):
    scene = 'biped.glb'

    def test_frames_of_a_view_that_stands_still_are_the_same(self):
        """The model is kept as a picture with its depths from the third on."""
        window = self.open()
        window.settle()
        window.key('a')
        first = window.shot('first_frame')
        for key in 'wqwqwq':
            window.key(key)
        time.sleep(0.3)
        self.assertEqual(window.shot('kept_frame').differs(first, window.view()), 0)

    def test_card_and_processor_draw_the_same_but_for_the_edges_of_lines(self):
        shots = []
        for graphics in ('card', 'processor'):
            window = self.open(None, '--graphics', graphics)
            window.settle()
            window.key('a')
            window.run('select', slides=['waist'])
            window.key('w')
            window.settle()
            shots.append(window.shot(graphics))
            view = window.view()
            window.close()
        self.assertGreater(shots[0].count(view, is_red), 100)
        self.assertLess(shots[0].differs(shots[1], view), 0.02 * view[2] * view[3])

    def test_z_up_stands_models_on_end_that_lie_and_the_next_window_has_it(self):
        window = self.open()
        window.settle()

        def lies_above(point):
            foot, at = window.where(point=[0, 0, 0]), window.where(point=point)
            return at['y'] < foot['y'] - 50 - 4 * abs(at['x'] - foot['x'])  # leans a little, in perspective

        self.assertTrue(lies_above([0, 1, 0]))
        self.assertFalse(lies_above([0, 0, 1]))
        window.key('alt+v', 'z')
        window.wait_until(lambda s: 'z_up' in s['marks'], 'it is marked')
        self.assertTrue(lies_above([0, 0, 1]))
        self.assertFalse(lies_above([0, 1, 0]))
        x, y, width, height = window.view()
        window.drag([(x + width // 2, y + height - 60), (x + width // 2 + 60, y + height - 60)], button=3)
        self.assertTrue(lies_above([0, 0, 1]), 'tumbling keeps what is up')
        window.shot('z_up')
        home = window.home
        window.close(keep_home=True)
        window = self.open(home=home)
        window.settle()
        self.assertIn('z_up', window.state()['marks'])
        self.assertTrue(lies_above([0, 0, 1]))
        window.run('up', axis='y')
        self.assertNotIn('z_up', window.state()['marks'])
        self.assertTrue(lies_above([0, 1, 0]))

    def test_a_window_drawn_by_either_follows_its_size_and_the_mouse(self):
        for graphics in ('card', 'processor'):
            with self.subTest(graphics):
                window = self.open(None, '--graphics', graphics)
                window.settle()
                window.xdotool('search', '--onlyvisible', '--name', 'Cagewright', 'windowsize', 900, 600)
                for _ in range(50):
                    x, y, width, height = window.view()
                    if x + width < 900 and y + height < 600:
                        break
                    time.sleep(0.1)
                window.settle()
                window.key('a')
                before = window.shot('small_' + graphics)
                self.assertGreater(before.count((x, y, width, height), is_red), 50)
                window.drag([(x + width // 2, y + height // 2), (x + width // 2 + 60, y + height // 2)], button=3)
                after = window.shot('turned_' + graphics)
                self.assertGreater(after.differs(before, (x, y, width, height)), 1000)
                window.close()

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
        window.wait_until(lambda s: len(s['slides']) == 1, 'it is a slide')
        state = window.settle()
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
        self.assertRegex(window.where(widget='speed')['text'], r'^cage (\d\d+|\d\.\d)/s, \d+ ms \(95 %: \d+ ms\), frame \d+ ms$')
        window.shot('speed')
        window.release()
        window.wait_until(lambda s: s['cage']['certified'], 'the whole cage is made')
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

    def test_undo_takes_back_a_drag_that_goes_on_and_nothing_before_it_and_no_other_key_is_heard(self):
        window = self.open()
        window.settle()
        window.run('remove_slides', slides=['brow'])
        self.select(window, 'left_knee')
        before = window.state()
        window.key('w')
        time.sleep(0.3)
        at = window.where(handle=2)
        there = (at['x'] + 25, at['y'] + 18)
        window.drag([(at['x'], at['y']), there], pause=0.03, release=False)
        window.wait_until(lambda s: s['cage']['is_of_editing'], 'the cage follows')
        window.key('Delete', 'ctrl+shift+z', 'ctrl+d', 'm', 'ctrl+a', 'd', 'Tab', 'Delete', 'shift+Tab', 'ctrl+d')
        state = window.state()
        self.assertEqual((state['slides'], state['undo'], state['selection'], state['cage']['is_of_editing']),
                         (before['slides'], before['undo'], ['left_knee'], True))
        window.key('ctrl+z')
        window.wait_until(lambda s: not s['cage']['is_of_editing'], 'the drag is given up')
        window.key('ctrl+z', 'Delete')  # the button is held still
        window.release()
        state = window.settle()
        self.assertEqual((state['slides'], state['undo']), (before['slides'], before['undo']))
        window.key('ctrl+z')
        window.wait_until(lambda s: len(s['slides']) == len(before['slides']) + 1, 'the step before is taken back')

    def test_undo_takes_back_the_first_drag_and_the_first_stroke_of_a_scene(self):
        window = self.open()
        before = window.settle()
        self.assertEqual(before['undo'], '')
        window.key('d')
        window.drag(list(self.leg(window)[:2]), pause=0.03, release=False)
        window.key('ctrl+z')
        window.release()
        state = window.settle()
        self.assertEqual((len(state['slides']), state['undo']), (len(before['slides']), ''))
        window.key('q')
        self.select(window, 'left_knee')
        window.key('w')
        time.sleep(0.3)
        at = window.where(handle=2)
        window.drag([(at['x'], at['y']), (at['x'] + 25, at['y'] + 18)], pause=0.03, release=False)
        window.wait_until(lambda s: s['cage']['is_of_editing'], 'the cage follows')
        window.key('z')
        window.wait_until(lambda s: not s['cage']['is_of_editing'], 'the drag is given up')
        window.release()
        state = window.settle()
        self.assertEqual((state['slides'], state['undo']), (before['slides'], ''))

    def test_undo_takes_back_a_stroke_that_is_being_drawn_and_nothing_before_it(self):
        window = self.open()
        before = window.settle()
        window.run('remove_slides', slides=['brow'])
        window.settle()
        window.key('d')
        window.drag(list(self.leg(window)[:2]), pause=0.03, release=False)
        window.key('Delete')
        self.assertEqual(window.state()['status'], '', 'a key that is not heard has no answer')
        window.key('z')
        window.release()
        state = window.settle()
        self.assertEqual(len(state['slides']), len(before['slides']) - 1)

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


if __name__ == '__main__':
    run_tests()
