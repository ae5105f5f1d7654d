# SPDX-License-Identifier: BSD-3-Clause
"""What the window says and shows about what was done: themes, status line, menus.

    python3 feedback_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import os
import shutil
import time

from window_case import path, run_tests, SCENES, setUpModule, tearDownModule, WindowTest
from window_driver import HangingCopy


def rectangle(at):
    return at['x'], at['y'], at['width'], at['height']


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
