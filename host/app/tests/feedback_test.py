# SPDX-License-Identifier: BSD-3-Clause
"""What the window says and shows about what was done: themes, numbers, status line, outliner, menus.

    python3 feedback_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import os
import shutil
import tempfile
import time

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest


def rectangle(at):
    return at['x'], at['y'], at['width'], at['height']


def is_orange(r, g, b):
    """What marks a problem's place."""
    return r > 220 and 60 < g < 130 and b < 60


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
        window.focus('main_window')
        window.key('ctrl+a')
        state = window.wait_until(lambda s: s['selection'], 'all are selected')
        self.assertEqual(state['status'], '')
        window.key('ctrl+c')
        window.wait_until(lambda s: s['status'] == 'Copied 17 slides', 'it says so')

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
        window.run('open', path=path('biped.off'))
        self.assertEqual(window.state()['status'], '')


class Panels(WindowTest):
    scene = 'biped.glb'

    def test_numbers_keep_their_exponent_and_tell_all_digits(self):
        window = self.open()
        window.settle()
        window.run('change_slides', slides=[{'name': 'waist', 'center': [-4.78123456e-17, 1.08, -123456.789],
                                              'u': [0.2, 0, 0], 'v': [0, 0, 0.2]}])
        window.run('select', slides=['waist'])
        field = window.where(widget='slide_centre_0')
        self.assertRegex(field['text'], r'^-4\.\d+e-17$')
        # The leftmost pixels within the frame are empty: nothing is cut off.
        shot = window.shot('numbers')
        inside = (field['x'] + 3, field['y'] + 5, field['width'] - 6, field['height'] - 10)
        text = shot.count(inside, lambda r, g, b: min(r, g, b) > 150)
        self.assertGreater(text, 20)
        self.assertEqual(shot.count((*inside[:2], 2, inside[3]), lambda r, g, b: min(r, g, b) > 150), 0)
        window.move(field['x'] + 20, field['y'] + 10)
        time.sleep(1.2)
        self.assertIn('-4.78123456e-17', window.where(widget='qtooltip_label')['text'])

    def type_into(self, window, name, text, end='Return'):
        field = window.where(widget=name)
        window.click(field['x'] + 10, field['y'] + field['height'] / 2)
        window.key('ctrl+a')
        window.type(text) if text else window.key('Delete')
        window.key(end)

    def said(self, window, *words):
        return window.wait_until(lambda s: all(word in s['status'] for word in words), ' '.join(words))

    def test_a_number_that_is_refused_is_told_and_goes_back_to_what_it_was(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist'])
        before = window.where(widget='slide_radii_0')['text']
        for text, words in (('0', ['"waist"', 'above 0', 'not 0']), ('-1', ['above 0', 'not -1']),
                            ('wide', ['Radii 1: "wide" is no number, it stays 0.']),
                            ('', ['Radii 1: nothing was typed', 'it stays 0.']),
                            ('1e308', ['"waist"', 'finite'])):
            with self.subTest(text):
                self.type_into(window, 'slide_radii_0', text)
                state = self.said(window, *words)
                self.assertEqual(window.where(widget='slide_radii_0')['text'], before)
                self.assertEqual(state['undo'], '')
        window.shot('number_refused')
        self.type_into(window, 'slide_name', '')
        self.said(window, 'a slide needs a name')
        self.assertEqual(window.where(widget='slide_name')['text'], 'waist')

    def test_a_refusal_outlasts_the_click_that_ends_the_typing_but_not_the_next_number(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist'])
        self.type_into(window, 'slide_radii_0', '0', end='Tab')
        self.said(window, 'above 0')
        window.key('ctrl+a')  # of the next field
        x, y, width, height = window.view()
        window.type('x')
        window.click(x + width / 2, y + 20)  # nothing is there: what is selected is let go
        window.wait_until(lambda s: not s['selection'], 'nothing is selected')
        self.said(window, 'Radii 2: "x" is no number')
        window.run('select', slides=['waist'])
        self.type_into(window, 'slide_radii_0', '0.3')
        self.assertEqual(window.wait_until(lambda s: s['undo'], 'it is taken')['status'], '')

    def test_a_cage_that_comes_in_leaves_what_is_selected_in_a_field_to_be_typed_over(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist'])
        for name, text in (('slide_centre_1', '1.08'), ('slide_name', 'belly')):
            field = window.where(widget=name)
            window.click(field['x'] + 10, field['y'] + field['height'] / 2)
            window.key('ctrl+a')
            window.run('solve')
            window.settle()
            window.type(text)
            window.key('Return')
            window.settle()
        belly = next(slide for slide in window.state()['slides'] if slide['name'] == 'belly')
        self.assertAlmostEqual(belly['center'][1], 1.08, 12)

    def test_a_parameter_that_is_refused_is_told_with_its_range(self):
        window = self.open()
        window.settle()
        tabs = window.where(widget='tabs')
        window.click(tabs['x'] + 75, tabs['y'] + 12)  # the second tab
        before = window.where(widget='refine.delta')['text']
        for text, words in (('-1', ['"refine.delta"', 'has to be from 0 to']), ('nan', ['is no number', 'it stays'])):
            self.type_into(window, 'refine.delta', text)
            self.assertEqual(self.said(window, *words)['undo'], '')
            self.assertEqual(window.where(widget='refine.delta')['text'], before)
        self.type_into(window, 'refine.iterations', '2.5')
        self.said(window, '"refine.iterations"', 'a whole number')
        window.shot('parameter_refused')

    def test_the_report_is_as_wide_as_its_panel(self):
        window = self.open()
        window.settle()
        dock, report = window.where(widget='report_dock'), window.where(widget='report')
        scroll_bar = 10
        self.assertLessEqual(report['x'] + report['width'], dock['x'] + dock['width'] - scroll_bar)


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
        self.assertEqual(window.shot().count(view, is_orange), 0)
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
        window.run('add_slide', name='tilted', center=[0.02, 1.2, 0], u=[0.4, 0.25, 0], v=[0, 0, 0.3])
        window.settle()
        planes, size = window.run('wait')['problems']
        self.assertIn("the slides 'shin' could not stay in their planes", planes['sentence'])
        self.assertIn("times as large as the model", size['sentence'])
        self.assertIn("farthest near 'tilted'", size['sentence'])
        self.assertTrue(planes['is_advice'] and size['is_advice'])
        rows = window.where(widget='problems')['rows']
        self.assertEqual([row['texts'][0] for row in rows], [planes['sentence'], size['sentence']])
        for row, problem in zip(rows, (planes, size)):
            window.click(row['x'], row['y'])
            window.wait_until(lambda s: s['selection'] == problem['slides'], 'its slide is selected')
            time.sleep(0.5)
            at = window.where(point=problem['place'])
            x, y, width, height = window.view()
            self.assertTrue(x < at['x'] < x + width and y < at['y'] < y + height, 'its place is in the view')
            shot = window.shot('advice_' + problem['slides'][0])
            self.assertGreater(shot.count((at['x'] - 30, at['y'] - 30, 60, 60), is_orange), 50)

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


class Sizes(WindowTest):
    scene = 'biped.glb'
    panels = ('outliner', 'problems', 'tabs', 'report')

    def seen(self, window):
        at = {name: window.where(widget=name) for name in self.panels}
        return [name for name in self.panels if at[name]['x'] >= 0 and at[name]['y'] >= 0]  # hidden tabs are off the screen

    def share(self, window):
        """Of the window's width and height that the view has."""
        whole, (x, y, width, height) = window.where(widget='main_window'), window.view()
        return width / whole['width'], height / whole['height']

    def test_the_view_has_half_of_a_window_that_is_small_or_large(self):
        window = self.open()
        window.settle()
        for width, height in ((1400, 900), (700, 500), (1024, 768), (1200, 600), (660, 480), (1199, 599), (1400, 900)):
            with self.subTest(width=width):
                window.resize(width, height)
                wide, high = self.share(window)
                self.assertGreaterEqual(wide, 0.5)
                self.assertGreaterEqual(high, 0.5)
                window.shot('size_%d' % width)
                if (width, height) in ((1400, 900), (1200, 600)):
                    self.assertEqual(self.seen(window), list(self.panels))

    def test_in_a_small_window_the_panels_are_tabs_that_can_be_clicked(self):
        window = self.open()
        window.settle()
        window.resize(700, 500)
        self.assertEqual(self.seen(window), ['outliner'])
        opened = set()
        for y in range(70, 450, 15):
            window.click(8, y)
            time.sleep(0.1)
            opened.update(self.seen(window))
            self.assertEqual(len(self.seen(window)), 1)
        self.assertEqual(opened, set(self.panels))
        window.shot('small_last_tab')

    def test_a_window_that_was_closed_small_has_all_its_panels_when_it_is_large_again(self):
        home = tempfile.mkdtemp(prefix='cagewright-home-')
        self.addCleanup(shutil.rmtree, home, True)
        window = self.open(home=home)
        window.settle()
        window.resize(700, 500)
        window.focus('main_window')
        window.key('ctrl+q')
        self.assertEqual(window.process.wait(20), 0)
        again = self.open(home=home)
        again.settle()
        self.assertEqual(again.where(widget='main_window')['width'], 700)
        self.assertGreaterEqual(self.share(again)[0], 0.5)
        again.resize(1400, 900)
        self.assertEqual(self.seen(again), list(self.panels))
        again.shot('large_again')


class Menus(WindowTest):
    scene = 'biped.glb'

    def test_paste_is_there_only_where_slides_were_copied(self):
        window = self.open()
        window.settle()

        def can_paste(holds):
            window.wait_until(lambda s: ('paste' not in s['disabled']) == holds, 'paste: %r' % holds)

        can_paste(False)
        window.run('select', slides=['waist', 'neck'])
        window.key('ctrl+c')
        can_paste(True)
        window.key('ctrl+v')
        window.wait_until(lambda s: len(s['slides']) == 19, 'both are pasted')
        other = self.open('biped.off')
        other.settle()
        self.assertNotIn('paste', other.state()['disabled'])  # of another window
        other.close()
        for slide, text in (('waist', 'no slides'), ('neck', '{"slides": 3}'), ('brow', '{"slides": []}')):
            window.focus('main_window')
            window.run('select', slides=[slide])
            field = window.where(widget='slide_name')
            window.click(field['x'] + 10, field['y'] + field['height'] / 2)
            window.key('ctrl+a')
            window.type(text)
            window.key('ctrl+a', 'ctrl+c')
            can_paste(False)
            window.key('Return')
            x, y, width, height = window.view()
            window.click(x + width / 2, y + 20)
            window.key('ctrl+a')
            window.wait_until(lambda s: len(s['selection']) == 19, 'all are selected')
            window.key('ctrl+c')
            can_paste(True)
        window.run('close')
        can_paste(False)

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


if __name__ == '__main__':
    run_tests()
