# SPDX-License-Identifier: BSD-3-Clause
"""What is asked when a scene is opened beside an autosave or a lock that was left there.

    python3 recovery_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import glob
import os
import shutil
import subprocess
import time

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest
from window_driver import obey_permissions

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

    def folder_of_its_own(self):
        """Where permissions bind, also where root runs this."""
        folder = path('own')
        shutil.rmtree(folder, ignore_errors=True)
        os.mkdir(folder)
        self.addCleanup(os.chmod, folder, 0o755)
        os.chmod(folder, 0o555)
        if subprocess.run(['touch', os.path.join(folder, 'written')], preexec_fn=obey_permissions,
                          stderr=subprocess.DEVNULL).returncode == 0:
            self.skipTest('root cannot be kept from writing here (prctl)')
        os.chmod(folder, 0o755)
        return folder


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

    def test_a_scene_that_was_written_since_is_told_and_no_is_the_answer_of_the_enter_key(self):
        saved = self.crash(minutes=7)
        written = os.path.getmtime(saved) + 5 * 60
        os.utime(path('left.glb'), (written, written))
        window = self.open('left.glb')
        asked = self.question(window, 'Recover', 'recover_older')
        for words in ('last written 7 minutes ago', 'left.glb itself was written since, 2 minutes ago',
                      'to save what was recovered replaces that'):
            self.assertIn(words, asked)
        window.key('Return')
        window.wait_until(lambda s: s['has_scene'], 'it is open')
        self.assertIn('brow', self.slides(window))
        self.assertTrue(os.path.exists(path('left_recovered_1.glb')))

    def test_what_was_not_saved_can_be_recovered_where_the_scene_was_written_since(self):
        saved = self.crash(minutes=7)
        os.utime(path('left.glb'))
        window = self.open('left.glb')
        self.question(window, 'Recover', None)
        window.click_widget('Yes')
        window.wait_until(lambda s: s['has_scene'], 'it is open')
        self.assertNotIn('brow', self.slides(window))
        self.assertTrue(os.path.exists(saved))

    def test_what_is_recovered_while_a_script_is_recorded_is_in_it(self):
        self.crash()
        window = self.open()
        window.run('record', path=path('recovering.jsonl'))
        window.focus('main_window')
        window.key('ctrl+o')
        window.focus_dialog('Open')
        time.sleep(0.3)
        window.key('ctrl+a')
        window.type(path('left.glb'))
        window.key('Return')
        self.question(window, 'Recover', None)
        window.click_widget('Yes')
        window.wait_until(lambda s: s['has_scene'], 'it is open')
        window.run('remove_slides', slides=['neck'])
        window.run('record')
        slides = self.slides(window)
        window.close()
        again = self.open()
        with open(path('recovering.jsonl')) as file:
            for line in file:
                self.assertTrue(again.ask_line(line.strip())['ok'], line)
        self.assertEqual(self.slides(again), slides)
        self.assertNotIn('brow', slides)

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

    def test_no_of_a_model_does_not_promise_the_saved_scene(self):
        self.crash()
        shutil.copy(path('biped.off'), path('left.off'))
        window = self.open('left.off')
        asked = self.question(window, 'Recover', 'recover_model_beside_scene')
        self.assertIn('No opens the model left.off alone, without what was saved in left.glb', asked)
        self.assertNotIn('as it was saved', asked)
        window.click_widget('No')
        window.wait_until(lambda s: s['has_scene'], 'it is open')
        self.assertEqual(self.slides(window), [])
        self.assertTrue(os.path.exists(path('left_recovered_1.glb')))

    def test_no_of_a_scene_that_is_not_there_leaves_the_changes_where_they_are(self):
        saved = self.crash()
        os.remove(path('left.glb'))
        window = self.open('left.glb')
        asked = self.question(window, 'Recover', None)
        self.assertIn('left.glb itself is not there: No opens nothing', asked)
        self.assertIn('.left.glb.autosave.glb', asked)
        window.click_widget('No')
        window.wait_until(lambda s: 'left.glb' in s['status'], 'it says so')
        self.assertFalse(window.state()['has_scene'])
        self.assertTrue(os.path.exists(saved))

    def test_changes_that_cannot_be_put_aside_are_told_once_and_never_written_over(self):
        saved = self.crash()
        with open(saved, 'rb') as file:
            changes = file.read()
        folder = self.folder_of_its_own()
        for name in ('left.glb', '.left.glb.autosave.glb'):
            shutil.copy2(path(name), folder)
        saved = os.path.join(folder, os.path.basename(saved))
        os.chmod(folder, 0o555)
        window = self.open('own/left.glb', environment=OFTEN, before=obey_permissions)
        self.question(window, 'Recover', None)
        window.click_widget('No')
        state = window.wait_until(lambda s: s['status'], 'it says so')
        for words in ('what was not saved before stays in .left.glb.autosave.glb', 'Permission denied', 'Save As'):
            self.assertIn(words, state['status'])
        window.shot('not_put_aside')
        window.run('remove_slides', slides=['neck'])
        window.run('save_copy', path=path('told_since.glb'))
        time.sleep(1)
        self.assertEqual(window.state()['status'], 'Saved a copy as told_since.glb')  # not told again
        os.chmod(folder, 0o755)
        kept = os.path.join(folder, 'left_recovered_1.glb')
        self.wait_for_file(kept)
        self.wait_for_file(saved)
        with open(kept, 'rb') as file:
            self.assertEqual(file.read(), changes)
        self.assertIn('left_recovered_1.glb', window.state()['status'])
        with open(saved, 'rb') as file:
            self.assertNotEqual(file.read(), changes)

    def test_what_is_left_of_the_scene_that_is_saved_as_is_put_aside_too(self):
        saved = self.crash()
        with open(saved, 'rb') as file:
            changes = file.read()
        window = self.open('biped.glb', environment=OFTEN)
        window.settle()
        window.run('save', path=path('left.glb'))
        window.run('remove_slides', slides=['neck'])
        self.wait_for_file(path('left_recovered_1.glb'))
        with open(path('left_recovered_1.glb'), 'rb') as file:
            self.assertEqual(file.read(), changes)

    def test_it_is_told_where_the_changes_are_gone(self):
        saved = self.crash()
        window = self.open('left.glb')
        self.question(window, 'Recover', None)
        os.remove(saved)
        window.click_widget('No')
        state = window.wait_until(lambda s: s['status'], 'it says so')
        self.assertIn('what was not saved before is gone: another program has removed .left.glb.autosave.glb',
                      state['status'])
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

    def left_by_another_machine(self):
        """A scene with changes that were not saved, and the lock."""
        shutil.copy(path('biped.glb'), path('.left.glb.autosave.glb'))
        self.lock()
        self.of_others = self.read_lock()

    def read_lock(self):
        with open(path('.left.glb.lock')) as file:
            return file.read()

    def test_the_lock_stays_where_the_question_that_follows_is_cancelled(self):
        self.left_by_another_machine()
        window = self.open('left.glb')
        self.question(window, 'Open elsewhere', None)
        window.click_widget('Remove Lock and Open')
        self.question(window, 'Recover', None)
        window.click_widget('Cancel')
        self.assertFalse(window.state()['has_scene'])
        self.assertEqual(self.read_lock(), self.of_others)
        self.assertTrue(os.path.exists(path('.left.glb.autosave.glb')))

    def test_a_lock_that_it_did_not_ask_about_is_not_removed(self):
        self.lock()
        window = self.open('left.glb')
        asked = self.question(window, 'Open elsewhere', None)
        self.assertIn("write over each other's autosave", asked)
        self.lock('815\ncagewright_window\nfarther-away\n')
        theirs = self.read_lock()
        window.click_widget('Remove Lock and Open')
        time.sleep(0.5)
        self.assertFalse(window.state()['has_scene'])
        asked = self.question(window, 'Open elsewhere', 'lock_of_another')
        self.assertIn('Since you were asked another window has taken the lock', asked)
        self.assertIn('process 815 on farther-away', asked)
        self.assertEqual(self.read_lock(), theirs)
        window.click_widget('Remove Lock and Open')
        self.assertIn('brow', self.slides(window))
        self.assertNotIn('another window', window.state()['title'])

    def test_a_scene_that_a_command_opens_while_it_is_asked_stays_and_the_lock_too(self):
        self.lock()
        theirs = self.read_lock()
        window = self.open('left.glb')
        self.question(window, 'Open elsewhere', None)
        window.run('open', path=path('biped.off'))
        window.click_widget('Remove Lock and Open')
        time.sleep(0.5)
        state = window.settle()
        self.assertIn('biped', state['title'])
        self.assertEqual(self.read_lock(), theirs)

    def test_a_lock_that_cannot_be_removed_is_asked_about_again(self):
        folder = self.folder_of_its_own()
        self.lock()
        for name in ('left.glb', '.left.glb.lock'):
            shutil.copy2(path(name), folder)
        os.chmod(folder, 0o555)
        window = self.open('own/left.glb', before=obey_permissions)
        self.question(window, 'Open elsewhere', None)
        window.click_widget('Remove Lock and Open')
        time.sleep(0.5)
        self.assertIn('That lock could not be removed', self.question(window, 'Open elsewhere', None))
        window.click_widget('Open Anyway')
        window.wait_until(lambda s: 'open in another window' in s['title'], 'it is open')

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
