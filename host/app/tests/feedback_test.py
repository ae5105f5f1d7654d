# SPDX-License-Identifier: BSD-3-Clause
"""What the window says and shows about what was done: themes, status line, outliner, menus.

    python3 feedback_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import json
import os
import shutil
import time

from window_case import path, run_tests, SCENES, setUpModule, tearDownModule, WindowTest
from window_driver import HangingCopy


def rectangle(at):
    return at['x'], at['y'], at['width'], at['height']


def is_orange(r, g, b):
    """What marks a problem's place."""
    return r > 220 and 60 < g < 130 and b < 60


def is_pale_red(r, g, b):
    """A failure's sentence on dark."""
    return r > 200 and 90 < g < 170 and 80 < b < 160 and r > g + 60


class Themes(WindowTest):
    scene = 'biped.glb'

    def test_the_outliner_has_the_colours_of_the_theme_that_was_changed_to(self):
        outliners = []
        for theme in ('dark', 'light'):
            window = self.open(None, '--theme', theme)
            window.settle()
            window.move(700, 450)
            outliners.append(window.shot('outliner_' + theme).part(rectangle(window.where(widget='outliner'))))
            if theme == 'dark':
                window.key('alt+v', 'k')  # to light; the menu's mark has followed --theme
                window.settle()
                changed = window.shot('outliner_changed').part(rectangle(window.where(widget='outliner')))
            window.close()
        whole = (0, 0, outliners[0].width, outliners[0].height)
        self.assertGreater(outliners[0].differs(outliners[1], whole), 0.9 * whole[2] * whole[3])
        self.assertEqual(changed.differs(outliners[1], whole), 0)


class Telling(WindowTest):
    scene = 'biped.glb'

    def broken_scene(self):
        with open(path('broken.glb'), 'wb') as file:
            file.write(b'glTF')
        return path('broken.glb')

    def test_the_sentence_of_what_failed_goes_when_the_next_thing_succeeds(self):
        window = self.open()
        window.settle()
        self.assertFalse(window.ask(command='select', slides=['nobody'])['ok'])  # answered, not told
        self.assertEqual(window.state()['status'], '')
        window.key('ctrl+o')
        window.focus_dialog('Open')
        time.sleep(0.3)
        window.key('ctrl+a')
        window.type(self.broken_scene())
        window.key('Return')
        window.wait_until(lambda s: 'broken.glb' in s['status'], 'it says so')
        window.focus_dialog('Not opened')
        self.assertIn('broken.glb', window.where(widget='qt_msgbox_label')['text'])
        shot = window.shot('not_opened')
        window.click_widget('OK')
        self.assertGreater(shot.count(rectangle(window.where(widget='status_bar')), is_pale_red), 50)
        window.focus('main_window')
        window.key('ctrl+a')
        state = window.wait_until(lambda s: s['selection'], 'all are selected')
        self.assertEqual(state['status'], '')
        window.key('ctrl+c')
        window.wait_until(lambda s: s['status'] == 'Copied 17 slides', 'it says so')
        self.assertEqual(window.shot().count(rectangle(window.where(widget='status_bar')), is_pale_red), 0)

    def test_a_tool_tip_over_a_failure_is_no_failure_and_the_failure_is_there_again_afterwards(self):
        window = self.open()
        window.settle()
        window.run('select', slides=[])
        window.key('Delete')
        failure = window.wait_until(lambda s: s['status'].startswith('Select a slide first'), 'it is said')['status']
        bar = window.where(widget='status_bar')
        inside = (bar['x'] + 4, bar['y'] + 2, 500, bar['height'] - 4)

        def reddish(r, g, b):
            return r > 150 and g < 0.75 * r and b < 0.75 * r

        self.assertGreater(window.shot('failure').count(inside, reddish), 50)
        at = window.where(widget='Frame All')
        window.move(at['x'] + 10, at['y'] + 10)
        window.wait_until(lambda s: s['status'] not in ('', failure), 'a tip')
        self.assertEqual(window.shot('tip_over_failure').count(inside, reddish), 0)
        x, y, width, height = window.view()
        window.move(x + width // 2, y + height // 2)
        window.wait_until(lambda s: s['status'] == failure, 'the failure again')
        window.wait_until(lambda s: window.shot('failure_again').count(inside, reddish) > 50, 'in its colour', 10)
        window.key('ctrl+a')
        window.wait_until(lambda s: s['status'] == '', 'it goes when something succeeds')

    def test_a_save_is_told(self):
        shutil.copy(path('biped.glb'), path('told.glb'))
        window = self.open('told.glb')
        window.settle()
        window.key('ctrl+s')
        window.wait_until(lambda s: s['status'] == 'Saved told.glb', 'it says so')

    def test_a_copy_is_told(self):
        window = self.open()
        window.settle()
        window.run('save_copy', path=path('told_copy.glb'))
        self.assertEqual(window.state()['status'], 'Saved a copy as told_copy.glb')

    def test_an_autosave_that_fails_is_told_and_the_window_goes_on(self):
        shutil.copy(path('biped.glb'), path('unsafe.glb'))
        window = self.open('unsafe.glb', environment={'CAGEWRIGHT_AUTOSAVE_MS': '300'})
        window.settle()
        os.mkdir(path('.unsafe.glb.autosave.glb'))  # no file can be put there
        self.addCleanup(os.rmdir, path('.unsafe.glb.autosave.glb'))
        window.run('remove_slides', slides=['brow'])
        state = window.wait_until(lambda s: s['status'], 'it says so')
        self.assertIn('The autosave failed: ', state['status'])
        self.assertIn('.unsafe.glb.autosave.glb', state['status'])
        window.shot('autosave_failed')
        window.run('save')
        self.assertEqual(window.state()['status'], 'Saved unsafe.glb')

    def test_a_file_that_cannot_be_opened_is_told_until_one_can(self):
        window = self.open(path('none.glb'))
        window.wait_until(lambda s: 'none.glb' in s['status'], 'it says so')
        window.focus_dialog('Not opened')
        self.assertFalse(window.ask(command='open', path=self.broken_scene())['ok'])  # answered, without a box
        window.run('open', path=path('biped.off'))  # which takes the first file's box away
        self.assertEqual(window.state()['status'], '')
        self.assertFalse(window.ask(command='where', widget='qt_msgbox_label')['ok'])


    def test_a_key_that_needs_a_slide_says_so_where_none_is_selected(self):
        window = self.open()
        before = window.settle()
        for key in ('Delete', 'ctrl+d', 'm'):
            window.key('ctrl+shift+a')
            window.wait_until(lambda s: not s['status'], 'the line is empty')
            window.key(key)
            self.assertIn('Select a slide first', window.state()['status'])
        self.assertEqual(window.state()['slides'], before['slides'])
        window.key('ctrl+a', 'Delete')
        state = window.wait_until(lambda s: not s['slides'], 'they are removed')
        self.assertEqual(state['status'], '')


class Outliner(WindowTest):
    scene = 'biped.glb'

    def rows(self, window):
        return {row['texts'][0]: row for row in window.where(widget='outliner')['rows']}

    def test_what_is_folded_up_stays_so_and_what_is_scrolled_to_stays_in_view(self):
        window = self.open()
        window.settle()
        mesh = self.rows(window)['biped']
        window.click(mesh['x'], mesh['y'])
        window.key('Left')
        self.assertEqual(list(self.rows(window)), ['biped'])
        window.run('rename_slide', slide='waist', name='belly')
        window.run('select', slides=['belly'])
        window.run('duplicate_slides', slides=['belly'])
        window.settle()
        self.assertEqual(list(self.rows(window)), ['biped'])
        window.key('Right')  # the keys are still the row's
        self.assertIn('belly', self.rows(window))
        for k in range(30):
            window.run('duplicate_slides', slides=['neck'])
        window.run('select', slides=['neck'])
        window.settle()
        at = window.where(widget='outliner')
        window.move(at['x'] + 60, at['y'] + 100)
        window.xdotool('click', '--repeat', 3, '--delay', 20, 5)
        before = list(self.rows(window))
        self.assertNotIn('neck', before)
        window.run('set_parameter', id='orient.lambda', value=2)
        window.run('change_slide', slide='belly', move=[0, 0.001, 0])
        self.assertEqual(list(self.rows(window)), before)

    def test_a_double_click_on_either_column_renames_the_slide(self):
        window = self.open()
        window.settle()
        for old, new, is_kind in (('waist', 'belly', False), ('belly', 'girdle', True)):
            row, at = self.rows(window)[old], window.where(widget='outliner')
            window.move(row['x'] + (at['x'] + at['width'] - row['x']) * 0.75 if is_kind else row['x'], row['y'])
            window.xdotool('click', '--repeat', 2, '--delay', 60, 1)
            time.sleep(0.3)
            window.key('ctrl+a')
            window.type(new)
            window.key('Return')
            window.wait_until(lambda s: any(slide['name'] == new for slide in s['slides']), 'it is called ' + new)
            self.assertEqual(self.rows(window)[new]['texts'][1], 'slide')

    def test_f2_renames_the_slide_that_was_selected_last_also_from_the_view_and_with_the_outliner_hidden(self):
        window = self.open()
        window.settle()
        self.assertIn('rename', window.state()['disabled'])
        for old, new in (('waist', 'belly'), ('neck', 'nape')):
            window.run('select', slides=['brow', old])
            window.focus('main_window')
            window.key('F2')
            time.sleep(0.5)
            window.key('ctrl+a')
            window.type(new)
            window.key('Return')
            state = window.wait_until(lambda s: any(slide['name'] == new for slide in s['slides']), 'it is ' + new)
            self.assertEqual(len(state['slides']), 17)
            window.click_widget('view')
            window.key('alt+v', 'n', 'Return')  # the outliner is hidden
            window.wait_until(lambda s: not window.ask(command='where', widget='outliner')['ok'], 'it is hidden')

    def kind(self, window, kind):
        window.wait_until(lambda s: self.rows(window)['biped cage']['texts'][1] == kind, 'it says ' + kind)

    def test_says_what_there_is_of_the_cage(self):
        window = self.open()
        window.settle()
        self.kind(window, 'cage, live')
        waist = next(slide for slide in window.state()['slides'] if slide['name'] == 'waist')
        window.run('add_slide', name='tilted', point=waist['center'], normal=[0.35, 1, 0])
        self.kind(window, 'cage, last good')
        self.assertIn('These slides give no cage', window.where(widget='hint')['text'])
        window.key('ctrl+z')
        self.kind(window, 'cage, live')
        window.run('set_parameter', id='refine.delta', value=0.05)  # slow: seconds
        self.kind(window, 'cage, being made')
        window.key('Escape')
        self.kind(window, 'cage, outdated')
        self.assertIn('G makes it', window.where(widget='hint')['text'])

    def open_model(self):
        with open(path('biped.off')) as file:
            lines = file.read().splitlines()
        with open(path('open.off'), 'w') as file:
            vertices, faces, edges = lines[1].split()
            file.write('\n'.join([lines[0], '%s %d %s' % (vertices, int(faces) - 1, edges)] + lines[2:-1]) + '\n')
        return 'open.off'

    def test_a_slide_at_fault_is_marked_also_where_it_is_selected(self):
        window = self.open()
        window.settle()
        waist = next(slide for slide in window.state()['slides'] if slide['name'] == 'waist')
        window.run('add_slide', name='tilted', point=waist['center'], normal=[0.35, 1, 0])
        window.settle()
        window.run('select', slides=['waist'])
        window.move(700, 450)
        shot = window.shot('fault_selected')
        at = window.where(widget='outliner')

        def marks(name):
            row = self.rows(window)[name]
            return shot.count((at['x'], row['y'] - 8, at['width'], 16), lambda r, g, b: r > 180 and g > 140 and b < 120)
        self.assertGreater(marks('waist'), 20)
        self.assertEqual(marks('neck'), 0)

    def test_a_slide_that_advice_names_has_a_mark_of_another_colour_and_says_it_among_its_numbers(self):
        window = self.open('biped.off')
        window.settle()
        window.run('add_slide', name='belly', point=[0, 0.9, 0], normal=[0, 1, 0])
        advice = next(problem for problem in window.settle()['problems'] if problem['slides'])
        self.assertTrue(advice['is_advice'], advice)
        self.assertEqual(advice['slides'], ['belly'])
        window.run('select', slides=[])
        window.move(700, 450)
        shot = window.shot('advice_mark')
        at, row = window.where(widget='outliner'), self.rows(window)['belly']
        beside = (at['x'], row['y'] - 8, at['width'], 16)
        self.assertGreater(shot.count(beside, lambda r, g, b: b > 140 and r < 120), 10)  # the blue of an i
        self.assertEqual(shot.count(beside, lambda r, g, b: r > 180 and b < 120), 0)  # neither a warning nor red
        window.run('select', slides=['belly'])
        self.assertEqual(window.where(widget='slide_state')['text'], advice['sentence'])

    def test_the_names_of_a_deep_tree_are_whole_and_can_be_scrolled_to(self):
        nodes = [{'name': 'node of the depth %d' % i, 'children': [i + 1]} for i in range(14)]
        with open(path('deep.gltf'), 'w') as file:
            json.dump({'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}],
                       'nodes': nodes + [{'name': 'node of the depth 14'}]}, file)
        window = self.open('deep.gltf')
        window.settle()
        before = window.shot('deep')
        at = window.where(widget='outliner')
        self.assertEqual(len(self.rows(window)), 15)
        for _ in range(40):
            window.click(at['x'] + 100, at['y'] + 100, button=7)  # the wheel, to the right
        deep = self.rows(window)['node of the depth 14']
        self.assertGreater(window.shot('deep_scrolled').differs(before, (at['x'], at['y'], at['width'], at['height'])),
                           1000)
        self.assertLess(deep['x'], at['x'] + at['width'])

    def test_says_that_a_scene_has_no_mesh(self):
        with open(path('meshless.gltf'), 'w') as file:
            json.dump({'asset': {'version': '2.0'}, 'scenes': [{'nodes': [0]}], 'nodes': [{'name': 'root'}]}, file)
        window = self.open('meshless.gltf')
        state = window.state()
        self.assertEqual(state['status'], path('meshless.gltf') + ': no node has a mesh, so there is nothing to cage')
        self.assertFalse(window.ask(command='where', widget='help')['ok'])  # nothing to draw on
        window.move(700, 450)
        window.wait_until(lambda s: s['status'] == '', 'the sentence is gone', timeout=30)
        self.assertIn('No node of this scene has a mesh', window.where(widget='hint')['text'])

    def test_says_that_a_model_gives_no_cage_and_why(self):
        window = self.open(self.open_model())
        window.wait_until(lambda s: s['problems'], 'it says why')
        self.assertEqual(self.rows(window)['cage']['texts'][1], 'none: see Problems')
        self.assertIn('This model gives no cage', window.where(widget='hint')['text'])
        self.assertFalse(window.ask(command='where', widget='help')['ok'])  # nothing to draw on

    def test_a_problem_that_is_clicked_is_marked_at_its_place_until_it_is_gone(self):
        window = self.open(self.open_model())
        window.wait_until(lambda s: s['problems'], 'it says why')
        view = window.view()
        edges = window.shot('open_edges').count(view, is_orange)
        self.assertLess(edges, 50)  # of one triangle
        problem = window.where(widget='problems')['rows'][0]
        before = window.where(point=window.run('wait')['problems'][0]['place'])
        window.click(problem['x'], problem['y'])
        for _ in range(50):  # until it is framed
            at = window.where(point=window.run('wait')['problems'][0]['place'])
            if at != before:
                break
            time.sleep(0.1)
        shot = window.shot('marked')
        self.assertGreater(shot.count((at['x'] - 30, at['y'] - 30, 60, 60), is_orange), 50)
        window.run('look', axis='back')
        at = window.where(point=window.run('wait')['problems'][0]['place'])
        self.assertGreater(window.shot().count((at['x'] - 30, at['y'] - 30, 60, 60), is_orange), 50)
        window.run('open', path=path('biped.off'))
        window.settle()
        self.assertEqual(window.shot().count(view, is_orange), 0)

    def test_a_problem_whose_place_the_model_hides_is_looked_at_from_its_side(self):
        window = self.open(self.open_model())
        window.wait_until(lambda s: s['problems'], 'it says why')
        place = window.run('wait')['problems'][0]['place']
        edges = {}
        for axis in ('left', 'right', 'front', 'back', 'top', 'bottom'):
            window.run('look', axis=axis)
            window.run('frame', what='all')
            problem = window.where(widget='problems')['rows'][0]
            window.click(problem['x'], problem['y'])
            time.sleep(0.3)
            at = window.where(point=place)
            # Beside the ring's mark: the triangle's edges, which nothing hides.
            shot = window.shot('hidden_from_' + axis)
            edges[axis] = shot.count((at['x'] - 60, at['y'] - 60, 120, 120), is_orange)
        self.assertLess(max(edges.values()), 3 * min(edges.values()), edges)

    def test_keys_in_the_problems_list_show_the_place_as_a_click_does(self):
        window = self.open()
        window.settle()
        waist = next(slide for slide in window.state()['slides'] if slide['name'] == 'waist')
        for name, side in (('far', 9), ('farther', 12)):
            window.run('add_slide', name=name, center=[side, 1, 0], u=waist['u'], v=waist['v'])
        state = window.wait_until(lambda s: len(s['problems']) > 1, 'both are problems')
        first, last = state['problems'][0]['slides'], state['problems'][-1]['slides']
        self.assertNotEqual(first, last)
        row = window.where(widget='problems')['rows'][0]
        window.click(row['x'], row['y'])
        window.wait_until(lambda s: s['selection'] == first, 'the first is shown')
        at = window.where(point=[9, 1, 0])

        def shows(slides, away):
            window.wait_until(lambda s: s['selection'] == slides, 'it is shown: %r' % slides)
            window.wait_until(lambda s: (window.where(point=[9, 1, 0]) != at) == away, 'its place is framed')

        for key, slides, away in (('Down', last, True), ('Up', first, False), ('End', last, True),
                                  ('Home', first, False)):
            window.key(key)
            shows(slides, away)
        window.shot('problem_by_key')
        window.run('frame', what='all')
        window.key('Home')  # leads nowhere: shows where one is
        shows(first, False)

    def test_each_kind_of_advice_is_a_problem_of_its_own_and_a_click_shows_its_slide_and_place(self):
        window = self.open('biped.off')
        window.settle()
        window.run('add_slide', name='shin', point=[0.138, 0.3, 0.05])
        window.run('add_slide', name='tilted', center=[-0.01, 1.09, 0], u=[0.4, 0.33, 0], v=[0, 0, 0.3])
        window.run('add_slide', name='elbow', point=[0.46, 1.36, -0.02])
        window.settle()
        problems = window.run('wait')['problems']
        kinds = ('could not stay in its plane', 'times as large as the model', 'run into each other')
        for kind in kinds:
            self.assertEqual(sum(kind in problem['sentence'] for problem in problems), 1)
        self.assertFalse(any(all(kind in problem['sentence'] for kind in kinds) for problem in problems))
        self.assertTrue(all(problem['is_advice'] for problem in problems))
        rows = window.where(widget='problems')['rows']
        self.assertEqual([row['texts'][0] for row in rows], [problem['sentence'] for problem in problems])
        marked = named = 0
        for row, problem in zip(rows, problems):
            self.assertTrue(all("'%s'" % slide in problem['sentence'] for slide in problem['slides']))
            window.click(row['x'], row['y'])
            window.wait_until(lambda s: s['selection'] == problem['slides'], 'its slides are selected')
            if 'enclose.in_plane' in problem['sentence']:
                self.assertEqual(window.state()['focus'], 'enclose.in_plane')
                tabs = window.where(widget='tabs')
                field = window.where(widget='enclose.in_plane')
                self.assertTrue(tabs['y'] < field['y'] < tabs['y'] + tabs['height'] - field['height'], 'it is in view')
                named += 1
            if 'place' not in problem:
                continue
            marked += 1
            time.sleep(0.5)
            at = window.where(point=problem['place'])
            x, y, width, height = window.view()
            self.assertTrue(x < at['x'] < x + width and y < at['y'] < y + height, 'its place is in the view')
            shot = window.shot('advice_%d' % marked)
            self.assertGreater(shot.count((at['x'] - 30, at['y'] - 30, 60, 60), is_orange), 50)
        self.assertGreater(marked, 0)
        self.assertEqual(named, 2)  # the size, and limbs that run together

    def test_a_slide_far_away_does_not_keep_the_model_from_being_framed(self):
        window = self.open()
        window.settle()

        def height():
            return abs(window.where(point=[0, 0, 0])['y'] - window.where(point=[0, 1.7, 0])['y'])

        alone = height()
        window.run('add_slide', name='far', center=[90, 1, 0], u=[0.1, 0, 0], v=[0, 0, 0.1])
        window.key('a')
        window.wait_until(lambda s: height() < alone / 10, 'all is framed')
        window.key('shift+a')
        window.wait_until(lambda s: abs(height() - alone) < 0.1 * alone, 'the model is framed')
        window.shot('model_framed')


class Menus(WindowTest):
    scene = 'biped.glb'

    def test_paste_is_there_with_a_scene_and_says_so_where_no_slides_were_copied(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist', 'neck'])
        window.key('ctrl+c', 'ctrl+v')
        window.wait_until(lambda s: len(s['slides']) == 19, 'both are pasted')
        for slide, text in (('waist', 'no slides'), ('neck', '{"slides": 3}'), ('brow', '{"slides": []}')):
            with self.subTest(text):
                window.run('select', slides=[slide])
                field = window.where(widget='slide_name')
                window.click(field['x'] + 10, field['y'] + field['height'] / 2)
                window.key('ctrl+a')
                window.type(text)
                window.key('ctrl+a', 'ctrl+c', 'Return')
                x, y, width, height = window.view()
                window.click(x + width / 2, y + 20)
                window.wait_until(lambda s: not s['selection'] and s['focus'] == 'view', 'the view has the keys')
                window.key('ctrl+v')
                window.wait_until(lambda s: 'no slides: select some' in s['status'] and 'Ctrl+C' in s['status'],
                                  'it says so')
                self.assertEqual(len(window.state()['slides']), 19)
        window.shot('nothing_to_paste')
        window.run('close')
        self.assertIn('paste', window.state()['disabled'])

    def test_a_program_that_copies_and_never_answers_does_not_hold_the_window_up(self):
        window = self.open()
        window.settle()
        hanging = HangingCopy(window.environment['DISPLAY'])
        self.addCleanup(hanging.close)
        time.sleep(0.3)  # the window has heard of it
        begin = time.monotonic()
        window.key('ctrl+a')
        window.wait_until(lambda s: len(s['selection']) == 17, 'it answers')
        self.assertLess(time.monotonic() - begin, 1)

    def marks(self, window):
        return set(window.state()['marks'])

    def test_marks_follow_scripts_as_well_as_keys_and_menus(self):
        window = self.open()
        window.settle()
        begin = self.marks(window)
        self.assertLessEqual({'shaded', 'colours_plain', 'show_cage', 'show_grid', 'tool_select', 'dark'}, begin)
        self.assertFalse(begin & {'orthographic', 'wireframe', 'colours_parts', 'colours_coverage', 'show_speed'})
        window.run('show', what='cage', on=False)
        window.run('show', what='speed', on=True)
        window.run('show', what='wireframe', on=True)
        window.run('colours', by='coverage')
        window.run('projection', orthographic=True)
        scripted = begin - {'show_cage', 'shaded', 'colours_plain'} | {'show_speed', 'wireframe', 'colours_coverage',
                                                                       'orthographic'}
        self.assertEqual(self.marks(window), scripted)
        window.key('o', '5', '7')
        self.assertEqual(self.marks(window), scripted - {'orthographic', 'wireframe', 'colours_coverage'} |
                         {'shaded', 'colours_parts'})
        view = window.view()
        without = window.shot()
        window.key('alt+v', 'g')  # a mark that a script has taken away is set by one choice, not by two
        window.settle()
        self.assertIn('show_cage', self.marks(window))
        self.assertGreater(window.shot('marks').differs(without, view), 3000)

    def test_meshes_that_are_not_being_caged_can_be_hidden(self):
        shutil.copy(os.path.join(SCENES, 'nodes_several_meshes.glb'), path('several.glb'))
        window = self.open('several.glb')
        window.settle()
        self.assertIn('show_other_meshes', self.marks(window))
        window.move(700, 5)
        before = window.shot('other_meshes')
        window.run('show', what='other_meshes', on=False)
        window.settle()
        self.assertNotIn('show_other_meshes', self.marks(window))
        self.assertGreater(window.shot('other_meshes_hidden').differs(before, window.view()), 500)

    def test_the_key_and_the_button_mirror_across_the_plane_that_was_chosen_last(self):
        window = self.open()
        window.settle()

        def mirrored(act):
            window.run('select', slides=['neck'])
            before = {slide['name'] for slide in window.state()['slides']}
            act()
            state = window.wait_until(lambda s: len(s['slides']) > len(before), 'a slide more')
            new = next(slide for slide in state['slides'] if slide['name'] not in before)
            neck = next(slide for slide in state['slides'] if slide['name'] == 'neck')
            away = [abs(a - b) for a, b in zip(new['center'], neck['center'])]
            return 'xyz'[away.index(max(away))]

        window.run('change_slide', slide='neck', move=[0.01, 0, 0.1])
        self.assertEqual(mirrored(lambda: window.key('alt+s', 'a', 'y')), 'y')
        self.assertEqual(mirrored(lambda: window.key('m')), 'y')
        self.assertEqual(mirrored(lambda: window.click_widget('Mirror Across y')), 'y')
        self.assertEqual(mirrored(lambda: window.key('alt+s', 'a', 'z')), 'z')
        self.assertEqual(mirrored(lambda: window.key('m')), 'z')
        at = window.where(widget='Mirror Across z')
        window.move(at['x'] + 20, at['y'] + 10)
        time.sleep(1.2)
        self.assertIn('across z', window.where(widget='qtooltip_label')['text'])
        self.assertIn('mirror_z', self.marks(window))
        window.run('open', path=path('biped.off'))  # another scene: what was chosen for the first says nothing about it
        self.assertIn('mirror_x', self.marks(window))
        home = window.home
        window.close(keep_home=True)
        self.assertIn('mirror_x', self.marks(self.open(home=home)))


if __name__ == '__main__':
    run_tests()
