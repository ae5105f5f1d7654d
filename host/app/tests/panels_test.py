# SPDX-License-Identifier: BSD-3-Clause
"""The panels round the view: what is typed into them, and how much room they take.

    python3 panels_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import os
import shutil
import tempfile
import time

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest


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

    def test_the_report_says_of_how_many_slides_the_last_good_cage_is_where_there_are_others_now(self):
        window = self.open('biped.off')
        window.settle()
        window.run('add_slide', name='shin', point=[0.138, 0.3, 0.05])
        self.assertTrue(window.settle()['cage']['certified'])
        window.run('paste_slides', slides=[{'name': 'low', 'point': [0.138, 0.7, 0.05], 'normal': [0, 1, 0]},
                                           {'name': 'tilted', 'point': [0.138, 0.7, 0.05], 'normal': [0.5, 1, 0]}])
        self.assertTrue(window.settle()['cage']['failed'])
        self.assertEqual(window.where(widget='verdict')['text'],
                         'The last good cage, of 1 slide: the 3 as they are now give none')

    def test_the_verdict_can_be_read_in_both_themes_also_where_the_theme_is_changed(self):
        def contrast(window, name):
            """Of the verdict's strongest pixels and its ground, as WCAG 2 has it."""
            at = window.where(widget='verdict')
            shot = window.shot(name)

            def luminance(pixel):
                parts = [c / 255 for c in pixel]
                parts = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055)**2.4 for c in parts]
                return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]
            seen = [luminance(shot.at(x, y)) for x in range(at['x'], at['x'] + at['width'])
                    for y in range(at['y'], at['y'] + at['height'])]
            ground = max(set(seen), key=seen.count)
            return max((max(it, ground) + 0.05) / (min(it, ground) + 0.05) for it in seen)
        window = self.open()
        window.settle()
        self.assertIn('Certified', window.where(widget='verdict')['text'])
        window.move(700, 450)
        self.assertGreater(contrast(window, 'verdict_dark'), 4.5)
        window.key('alt+v', 'k')
        window.settle()
        self.assertGreater(contrast(window, 'verdict_light'), 4.5)

    def type_into(self, window, name, text, end='Return'):
        field = window.where(widget=name)
        window.click(field['x'] + 10, field['y'] + field['height'] / 2)
        window.key('ctrl+a')
        window.type(text) if text else window.key('Delete')
        window.key(end)

    def said(self, window, *words):
        return window.wait_until(lambda s: all(word in s['status'] for word in words), ' '.join(words))

    def test_undo_after_a_name_was_taken_is_the_scenes_and_escape_gives_up_what_is_typed(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist'])
        window.click_widget('slide_name')
        window.key('ctrl+a')
        window.type('belly')
        window.key('Return')
        window.wait_until(lambda s: 'belly' in [slide['name'] for slide in s['slides']], 'it is renamed')
        window.key('ctrl+z')
        state = window.wait_until(lambda s: 'waist' in [slide['name'] for slide in s['slides']], 'it has its name again')
        self.assertEqual(window.where(widget='slide_name')['text'], 'waist')
        window.type('wa')
        window.key('Escape')
        self.assertEqual(window.where(widget='slide_name')['text'], 'waist')
        window.key('Tab')
        self.assertEqual(window.state()['undo'], state['undo'])
        self.assertIn('waist', [slide['name'] for slide in window.state()['slides']])

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

    def test_a_number_that_is_taken_clears_no_sentence_but_a_refusal(self):
        window = self.open()
        window.settle()
        window.run('select', slides=['waist'])
        self.type_into(window, 'slide_radii_0', '0')
        self.said(window, 'above 0')
        window.run('save_copy', path=path('since.glb'))
        self.type_into(window, 'slide_radii_0', '0.3')
        state = window.wait_until(lambda s: s['undo'], 'it is taken')
        self.assertEqual(state['status'], 'Saved a copy as since.glb')

    def test_a_number_that_is_taken_leaves_the_sentence_about_an_autosave_that_failed(self):
        shutil.copy(path('biped.glb'), path('unsafe.glb'))
        window = self.open('unsafe.glb', environment={'CAGEWRIGHT_AUTOSAVE_MS': '300'})
        window.settle()
        os.mkdir(path('.unsafe.glb.autosave.glb'))  # no file can be put there
        self.addCleanup(os.rmdir, path('.unsafe.glb.autosave.glb'))
        window.run('select', slides=['waist'])
        self.type_into(window, 'slide_radii_0', '0')
        self.said(window, 'above 0')
        window.run('remove_slides', slides=['brow'])
        window.run('select', slides=['waist'])
        self.said(window, 'The autosave failed')
        self.type_into(window, 'slide_radii_0', '0.3')
        self.assertIn('The autosave failed',
                      window.wait_until(lambda s: 'change' in s['undo'], 'it is taken')['status'])

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


class Sizes(WindowTest):
    scene = 'biped.glb'
    panels = ('outliner', 'problems', 'tabs', 'report')

    def shown(self, window):
        """Also behind other tabs."""
        return [name for name in self.panels if window.ask(command='where', widget=name)['ok']]

    def seen(self, window):
        at = {name: window.where(widget=name) for name in self.shown(window)}
        return [name for name in at if at[name]['x'] >= 0 and at[name]['y'] >= 0]  # hidden tabs are off the screen

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

    def test_the_tool_bars_overflow_is_seen_in_the_dark(self):
        window = self.open()
        window.settle()
        window.resize(700, 500)
        at = window.where(widget='qt_toolbar_ext_button')
        inside = (at['x'] + 2, at['y'] + 2, at['width'] - 4, at['height'] - 4)
        shot = window.shot('overflow')
        dark, bright = (shot.count(inside, is_it) for is_it in (lambda r, g, b: max(r, g, b) < 90,
                                                                lambda r, g, b: min(r, g, b) > 140))
        self.assertGreater(dark, 8)
        self.assertGreater(bright, 3 * dark)

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

    def toggle(self, window, name):
        """View > Panels."""
        window.focus('main_window')
        window.key('alt+v', 'n', *['Down'] * self.panels.index(name), 'Return')
        time.sleep(0.5)  # it moves into its place

    def test_the_field_that_advice_names_is_shown_also_in_a_panel_that_was_hidden_or_behind_others(self):
        window = self.open('biped.off')
        window.settle()
        window.run('add_slide', name='shin', point=[0.138, 0.3, 0.05])
        state = window.settle()
        at = next(i for i, problem in enumerate(state['problems']) if 'enclose.in_plane' in problem['sentence'])

        def shows_the_field():
            window.focus('main_window')
            row = window.where(widget='problems')['rows'][at]
            window.click(row['x'], row['y'])
            window.wait_until(lambda s: s['focus'] == 'enclose.in_plane', 'the field can be typed into')
            time.sleep(0.3)
            field, dock = (window.where(widget=name) for name in ('enclose.in_plane', 'tabs'))
            self.assertGreaterEqual(field['y'], dock['y'])
            self.assertLessEqual(field['y'] + field['height'], dock['y'] + dock['height'])
            self.assertGreaterEqual(field['x'], 0)
            frame = window.shot('framed_field').count(
                (field['x'], field['y'], field['width'], 1), lambda r, g, b: b > 200 and r < 150)
            self.assertGreater(frame, field['width'] * 0.9, 'where the keys go is seen')

        self.toggle(window, 'tabs')
        self.assertEqual(self.shown(window), ['outliner', 'problems', 'report'])
        shows_the_field()
        window.shot('field_of_hidden_panel')
        window.resize(700, 500)
        for y in range(70, 450, 15):
            window.click(8, y)
            time.sleep(0.1)
            if self.seen(window) == ['problems']:
                break
        shows_the_field()
        self.assertEqual(self.seen(window), ['tabs'])
        window.shot('field_in_small_window')

    def test_panels_that_hide_the_view_can_be_reset(self):
        window = self.open()
        window.settle()
        before = self.heights(window), window.view()
        x, y, width, height = window.view()
        window.drag([(x + width + 2, y + height / 2), (x + 5, y + height / 2)])
        time.sleep(0.3)
        self.assertLess(window.view()[2], 60)
        self.drag_down(window, 'attributes_dock', -80)
        self.toggle(window, 'problems')
        window.focus('main_window')
        window.key('alt+v', 'n', 'r')
        window.wait_until(lambda s: self.shown(window) == list(self.panels), 'they are all there')
        window.wait_until(lambda s: (self.heights(window), window.view()) == before, 'they are as at first')

    def heights(self, window):
        at = {name: window.ask(command='where', widget=name + '_dock')
              for name in ('outliner', 'problems', 'attributes', 'report')}
        return {name: at[name]['height'] for name in at if at[name]['ok']}

    def drag_down(self, window, upper, by):
        """The border below a panel."""
        at = window.where(widget=upper)
        x, y = at['x'] + at['width'] / 2, at['y'] + at['height'] + 2
        window.drag([(x, y), (x, y + by)])
        time.sleep(0.3)

    def test_a_panel_that_was_hidden_and_is_shown_in_a_small_window_is_a_tab_and_stays(self):
        window = self.open()
        window.settle()
        self.toggle(window, 'outliner')
        self.assertEqual(self.shown(window), ['problems', 'tabs', 'report'])
        window.resize(700, 500)
        self.toggle(window, 'outliner')
        window.shot('small_shown')
        self.assertEqual(self.seen(window), ['outliner'])
        window.resize(1400, 900)
        self.assertEqual(self.shown(window), list(self.panels))
        window.shot('large_shown')
        outliner, problems = window.where(widget='outliner_dock'), window.where(widget='problems_dock')
        self.assertLess(outliner['y'] + outliner['height'], problems['y'] + 1)

    def test_the_only_panel_of_a_small_window_can_be_hidden_and_shown(self):
        window = self.open()
        window.settle()
        for name in ('problems', 'tabs', 'report'):
            self.toggle(window, name)
        window.resize(700, 500)
        self.toggle(window, 'outliner')
        self.assertEqual(self.shown(window), [])
        self.toggle(window, 'tabs')
        self.assertEqual(self.seen(window), ['tabs'])
        self.toggle(window, 'report')
        self.assertEqual(self.seen(window), ['report'])
        window.resize(1400, 900)
        self.assertEqual(self.seen(window), ['tabs', 'report'])

    def test_a_panel_that_is_hidden_in_a_small_window_stays_so(self):
        window = self.open()
        window.settle()
        window.resize(700, 500)
        self.toggle(window, 'problems')
        window.resize(1400, 900)
        self.assertEqual(self.shown(window), ['outliner', 'tabs', 'report'])
        window.resize(700, 500)
        self.toggle(window, 'problems')
        window.resize(1400, 900)
        self.assertEqual(self.seen(window), list(self.panels))

    def test_panels_are_as_high_as_they_were_once_the_window_is_as_large_as_it_was(self):
        window = self.open()
        window.settle()
        self.drag_down(window, 'outliner_dock', 150)
        self.drag_down(window, 'attributes_dock', -80)
        before = self.heights(window)
        self.assertGreater(before['outliner'], before['problems'] + 100)
        for size in ((700, 500), (1400, 560), (1000, 900)):
            with self.subTest(size):
                window.resize(*size)
                window.resize(1400, 900)
                window.wait_until(lambda s: self.heights(window) == before, 'they are as high as %r' % before)

    def reset(self, window):
        window.focus('main_window')
        window.key('alt+v', 'n', 'r')
        time.sleep(0.5)

    def test_reset_panels_puts_back_what_was_hidden_moved_and_pressed_together(self):
        window = self.open()
        window.settle()
        before, seen = self.heights(window), self.share(window)
        self.drag_down(window, 'attributes_dock', -100)
        self.drag_down(window, 'outliner_dock', 150)
        self.toggle(window, 'problems')
        self.assertNotEqual(self.heights(window), before)
        self.reset(window)
        window.wait_until(lambda s: self.heights(window) == before, 'they are as high as at first')
        self.assertEqual(self.seen(window), list(self.panels))
        self.assertEqual(self.share(window), seen)

    def test_panels_that_were_reset_in_a_small_window_are_as_at_first_when_it_is_large(self):
        home = tempfile.mkdtemp(prefix='cagewright-home-')
        self.addCleanup(shutil.rmtree, home, True)
        window = self.open(home=home)
        window.settle()
        before = self.heights(window)
        self.drag_down(window, 'attributes_dock', -100)
        window.resize(900, 560)
        self.reset(window)
        self.assertEqual(len(self.seen(window)), 1)  # tabs
        window.resize(1400, 900)
        window.wait_until(lambda s: self.heights(window) == before, 'they are as high as at first')
        window.resize(900, 560)
        self.reset(window)
        window.key('ctrl+q')
        self.assertEqual(window.process.wait(20), 0)
        again = self.open(home=home)
        again.settle()
        again.resize(1400, 900)
        again.wait_until(lambda s: self.heights(again) == before, 'they are as high as at first')

    def test_the_pointer_may_be_on_a_border_between_panels_while_they_become_tabs_and_back(self):
        window = self.open()
        window.settle()
        for upper in ('attributes_dock', 'outliner_dock') * 3:
            with self.subTest(upper):
                self.drag_down(window, upper, -10)
                window.resize(700, 500)
                window.move(350, 250)
                at = window.where(widget='view')
                window.move(at['x'] - 2, at['y'] + at['height'] / 2)
                time.sleep(0.2)
                window.resize(1400, 900)
                window.move(700, 450)
                self.assertEqual(self.seen(window), list(self.panels))

    def test_what_was_done_to_panels_is_there_after_the_window_was_closed_small(self):
        home = tempfile.mkdtemp(prefix='cagewright-home-')
        self.addCleanup(shutil.rmtree, home, True)
        window = self.open(home=home)
        window.settle()
        self.drag_down(window, 'attributes_dock', -80)
        before = self.heights(window)
        window.resize(700, 500)
        self.toggle(window, 'problems')
        window.key('ctrl+q')
        self.assertEqual(window.process.wait(20), 0)
        again = self.open(home=home)
        again.settle()
        self.assertEqual(self.shown(again), ['outliner', 'tabs', 'report'])
        again.resize(1400, 900)
        self.assertEqual(self.shown(again), ['outliner', 'tabs', 'report'])
        self.assertEqual(self.heights(again)['report'], before['report'])

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


if __name__ == '__main__':
    run_tests()
