# SPDX-License-Identifier: BSD-3-Clause
"""What is asked when a scene is opened beside an autosave or a lock that was left there.

    python3 recovery_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import glob
import os
import shutil
import time

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest

OFTEN = {'CAGEWRIGHT_AUTOSAVE_MS': '300'}


class QuestionTest(WindowTest):
    def setUp(self):
        super().setUp()
        for left in glob.glob(path('.*.lock')) + glob.glob(path('*_recovered_*')):
            os.remove(left)
        shutil.copy(path('biped.glb'), path('left.glb'))

    def slides(self, window):
        return [slide['name'] for slide in window.settle()['slides']]

    def question(self, window, title, name):
        """What a question box says, once it is there."""
        window.focus_dialog(title)
        time.sleep(0.3)
        window.shot(name)
        return ' '.join(window.where(widget=label).get('text', '')
                        for label in ('qt_msgbox_label', 'qt_msgbox_informativelabel')
                        if window.ask(command='where', widget=label)['ok'])

    def wait_for_file(self, name):
        end = time.monotonic() + 20
        while not os.path.exists(name):
            self.assertLess(time.monotonic(), end, name)
            time.sleep(0.1)
        time.sleep(0.5)


class Recovering(QuestionTest):
    def crash(self, scene='left.glb', minutes=0):
        """Leaves an autosave without the slide brow, or with one slide more, that many minutes old."""
        window = self.open(scene, environment=OFTEN)
        if scene.endswith('.glb'):
            window.settle()
            window.run('remove_slides', slides=['brow'])
        else:
            window.run('add_slide', point=[0.138, 0.3, 0.05])
        saved = path('.left.glb.autosave.glb')
        self.wait_for_file(saved)
        window.crash()
        for file in (saved, path('left.glb')):
            if minutes and os.path.exists(file):
                written = os.path.getmtime(file) - 60 * minutes
                os.utime(file, (written, written))
        return saved

    def test_the_question_tells_how_old_the_changes_are_and_what_no_does(self):
        self.crash(minutes=3)
        window = self.open('left.glb')
        asked = self.question(window, 'Recover', 'recover')
        for words in ('last written 3 minutes ago', 'No opens the scene as it was saved', 'left_recovered_1.glb'):
            self.assertIn(words, asked)

    def test_no_opens_what_was_saved_and_keeps_the_changes_aside(self):
        saved = self.crash()
        with open(saved, 'rb') as file:
            changes = file.read()
        window = self.open('left.glb')
        self.question(window, 'Recover', None)
        window.click_widget('No')
        window.wait_until(lambda s: s['has_scene'], 'it is open')
        self.assertIn('brow', self.slides(window))
        self.assertIn('left_recovered_1.glb', window.state()['status'])
        with open(path('left_recovered_1.glb'), 'rb') as file:
            self.assertEqual(file.read(), changes)
        self.assertFalse(os.path.exists(saved))
        window.close()
        kept = self.open('left_recovered_1.glb')
        self.assertNotIn('brow', self.slides(kept))

    def test_no_keeps_the_changes_of_a_model_too_and_never_writes_over_what_was_kept_before(self):
        os.remove(path('left.glb'))
        shutil.copy(path('biped.off'), path('left.off'))
        self.crash('left.off')
        with open(path('left_recovered_1.glb'), 'wb') as file:
            file.write(b'before')
        window = self.open('left.off')
        asked = self.question(window, 'Recover', 'recover_model')
        self.assertIn('No opens the model, of which no scene was saved', asked)
        self.assertIn('left_recovered_2.glb', asked)
        window.click_widget('No')
        window.wait_until(lambda s: s['has_scene'], 'it is open')
        self.assertEqual(self.slides(window), [])
        self.assertTrue(os.path.exists(path('left_recovered_2.glb')))
        with open(path('left_recovered_1.glb'), 'rb') as file:
            self.assertEqual(file.read(), b'before')

    def test_cancel_leaves_everything_as_it_was(self):
        saved = self.crash()
        window = self.open('left.glb')
        self.question(window, 'Recover', None)
        window.click_widget('Cancel')
        self.assertFalse(window.state()['has_scene'])
        self.assertTrue(os.path.exists(saved))
        self.assertFalse(os.path.exists(path('.left.glb.lock')))
        self.assertEqual(glob.glob(path('*_recovered_*')), [])

    def test_it_is_told_where_the_changes_cannot_be_put_aside(self):
        saved = self.crash()
        window = self.open('left.glb')
        self.question(window, 'Recover', None)
        os.remove(saved)
        window.click_widget('No')
        state = window.wait_until(lambda s: s['status'], 'it says so')
        self.assertIn('could not be put aside: No such file', state['status'])
        self.assertIn('brow', self.slides(window))


class Locks(QuestionTest):
    def lock(self, text='4711\ncagewright_window\nfar-away\n'):
        """As a window on another machine leaves it."""
        with open(path('.left.glb.lock'), 'w') as file:
            file.write(text)

    def test_a_lock_of_another_machine_is_asked_about_by_its_name(self):
        self.lock()
        window = self.open('left.glb')
        asked = self.question(window, 'Open elsewhere', 'lock')
        for words in ('process 4711 on far-away', path('.left.glb.lock'), 'cannot be told from this machine'):
            self.assertIn(words, asked)
        window.click_widget('Cancel')
        self.assertFalse(window.state()['has_scene'])
        self.assertTrue(os.path.exists(path('.left.glb.lock')))

    def test_opened_anyway_the_lock_stays_and_no_autosave_is_written(self):
        self.lock()
        window = self.open('left.glb', environment=OFTEN)
        self.question(window, 'Open elsewhere', None)
        window.click_widget('Open Anyway')
        self.assertIn('brow', self.slides(window))
        self.assertIn('open in another window', window.state()['title'])
        window.run('remove_slides', slides=['brow'])
        time.sleep(1)
        self.assertFalse(os.path.exists(path('.left.glb.autosave.glb')))
        with open(path('.left.glb.lock')) as file:
            self.assertIn('far-away', file.read())

    def test_without_the_lock_the_scene_and_its_autosave_are_this_windows(self):
        self.lock()
        window = self.open('left.glb', environment=OFTEN)
        self.question(window, 'Open elsewhere', None)
        window.click_widget('Remove Lock and Open')
        self.assertIn('brow', self.slides(window))
        self.assertNotIn('another window', window.state()['title'])
        window.run('remove_slides', slides=['brow'])
        self.wait_for_file(path('.left.glb.autosave.glb'))
        with open(path('.left.glb.lock')) as file:
            self.assertNotIn('far-away', file.read())

    def test_what_the_other_machine_did_not_save_is_offered_once_its_lock_is_removed(self):
        window = self.open('left.glb', environment=OFTEN)
        window.settle()
        window.run('remove_slides', slides=['brow'])
        self.wait_for_file(path('.left.glb.autosave.glb'))
        window.crash()
        self.lock()
        again = self.open('left.glb')
        self.question(again, 'Open elsewhere', None)
        again.click_widget('Remove Lock and Open')
        again.focus_dialog('Recover')
        again.click_widget('Yes')
        again.wait_until(lambda s: s['has_scene'], 'it is open')
        self.assertNotIn('brow', self.slides(again))

    def test_a_lock_that_does_not_say_whose_it_is_is_asked_about_too(self):
        self.lock('')
        window = self.open('left.glb')
        self.assertIn('another window, (.left.glb.lock)', self.question(window, 'Open elsewhere', None))

    def test_a_window_of_this_machine_is_not_asked_about(self):
        first = self.open('left.glb')
        first.settle()
        second = self.open('left.glb')
        self.assertIn('brow', self.slides(second))


if __name__ == '__main__':
    run_tests()
