# SPDX-License-Identifier: BSD-3-Clause
"""The outliner, and the list of problems with the marks and places that go with it.

    python3 outliner_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import json
import time

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest


def is_orange(r, g, b):
    """What marks a problem's place."""
    return r > 220 and 60 < g < 130 and b < 60


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


if __name__ == '__main__':
    run_tests()
