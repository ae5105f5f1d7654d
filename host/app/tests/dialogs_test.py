# SPDX-License-Identifier: BSD-3-Clause
"""Saving and exporting through the menus and file dialogs, by mouse and keyboard.

    python3 dialogs_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import os
import shutil
import subprocess
import tempfile
import time

from window_case import path, PROGRAM, run_tests, setUpModule, tearDownModule, WindowTest
from window_driver import obey_permissions


def wait_for(holds, what, seconds=60):
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            raise AssertionError('not within %g s: %s' % (seconds, what))
        time.sleep(0.05)


class DialogTest(WindowTest):
    scene = 'biped.glb'

    def setUp(self):
        super().setUp()
        self.folder = tempfile.mkdtemp(prefix='cagewright-dialog-')
        self.addCleanup(shutil.rmtree, self.folder, True)

    def in_folder(self, name):
        return os.path.join(self.folder, name)

    def answer(self, window, title, text):
        """Types into the dialog of that title and ends it."""
        window.focus_dialog(title)
        time.sleep(0.3)
        window.key('ctrl+a')
        window.type(text)
        window.key('Return')

    def closed_folder(self):
        """With a scene in it, for programs that obey permissions."""
        closed = self.in_folder('closed')
        os.mkdir(closed)
        shutil.copy(path('biped.glb'), closed)
        os.chmod(closed, 0o555)
        self.addCleanup(os.chmod, closed, 0o755)
        if subprocess.run(['touch', os.path.join(closed, 'written')], preexec_fn=obey_permissions,
                          stderr=subprocess.DEVNULL).returncode == 0:
            self.skipTest('root cannot be kept from writing here (prctl)')
        return closed

    def status(self, window, text):
        return window.wait_until(lambda s: text in s['status'], 'the status line says: ' + text)


class Plugins(DialogTest):
    def show(self, window):
        window.key('alt+f')
        window.key('g')
        window.focus_dialog('Plug-ins')

    def text(self, window, words):
        window.wait_until(lambda s: words in window.where(widget='plugin_text')['text'], 'it says: ' + words)
        return window.where(widget='plugin_text')['text']

    def dismiss(self, window, title):
        window.focus_dialog(title)
        window.click_widget('OK')
        window.focus_dialog('Plug-ins')

    def test_what_is_loaded_is_shown_and_not_unloaded_while_the_scene_uses_it(self):
        window = self.open()
        window.settle()
        self.show(window)
        text = self.text(window, 'cagewright_plugin.so')
        for word in ('Version', 'ABI', 'Parameters'):
            self.assertIn(word, text)
        window.click_widget('Unload')
        self.dismiss(window, 'Not unloaded')
        self.text(window, 'cagewright_plugin.so')
        window.run('close')
        window.click_widget('Unload')
        self.text(window, 'No plug-in is loaded')

    def test_another_file_is_loaded_and_one_that_is_no_plugin_leaves_things_as_they_are(self):
        window = self.open()
        window.settle()
        window.run('close')
        self.show(window)
        loaded = self.text(window, 'cagewright_plugin.so')
        with open(self.in_folder('broken.so'), 'w') as file:
            file.write('no plug-in')
        window.click_widget('Load ...')
        self.answer(window, 'Load a plug-in', self.in_folder('broken.so'))
        self.dismiss(window, 'Not loaded')
        with open(os.path.join(os.path.dirname(PROGRAM), 'cagewright_plugin.so'), 'rb') as file:
            half = file.read(300000)
        with open(self.in_folder('half.so'), 'wb') as file:
            file.write(half)
        window.click_widget('Load ...')
        self.answer(window, 'Load a plug-in', self.in_folder('half.so'))
        self.dismiss(window, 'Not loaded')
        self.assertEqual(self.text(window, 'File'), loaded)
        other = self.in_folder('other.so')
        shutil.copy(os.path.join(os.path.dirname(PROGRAM), 'cagewright_plugin.so'), other)
        window.click_widget('Load ...')
        self.answer(window, 'Load a plug-in', other)
        self.text(window, other)
        window.run('open', path=path('biped.glb'))
        window.wait_until(lambda s: s['cage']['certified'], 'the other one makes the cage')


class Saving(DialogTest):
    def test_save_as_writes_another_scene_which_is_then_the_open_one(self):
        window = self.open()
        window.settle()
        window.key('ctrl+shift+s')
        self.answer(window, 'Save as', self.in_folder('other.gltf'))
        state = self.status(window, 'Saved other.gltf')
        self.assertIn('other.gltf', state['title'])
        window.focus('main_window')
        window.run('remove_slides', slides=['brow'])
        window.key('ctrl+s')
        window.wait_until(lambda s: s['saved'], 'saved again, without a question')
        window.close()
        again = self.open(self.in_folder('other.gltf'))
        self.assertEqual(len(again.settle()['slides']), 16)

    def test_save_as_that_is_given_up_or_fails_leaves_the_scene_as_it_was(self):
        window = self.open()
        title = window.settle()['title']
        window.key('ctrl+shift+s')
        window.focus_dialog('Save as')
        window.key('Escape')
        window.focus('main_window')
        window.key('ctrl+shift+s')
        self.answer(window, 'Save as', self.in_folder('other.obj'))
        window.focus_dialog('Not saved')
        window.click_widget('OK')
        self.assertEqual(window.state()['title'], title)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_scene_that_cannot_be_written_where_it_is_can_be_saved_under_another_name_at_once(self):
        closed = self.closed_folder()
        window = self.open(os.path.join(closed, 'biped.glb'), before=obey_permissions)
        window.settle()
        window.run('remove_slides', slides=['brow'])
        window.settle()
        window.focus('main_window')
        window.key('ctrl+s')
        window.focus_dialog('Not saved')
        window.key('Escape')
        window.focus('main_window')
        self.assertFalse(window.ask(command='where', widget='Save As ...')['ok'])
        window.key('ctrl+s')
        window.focus_dialog('Not saved')
        window.click_widget('Save As ...')
        self.answer(window, 'Save as', self.in_folder('elsewhere.glb'))
        state = self.status(window, 'Saved elsewhere.glb')
        self.assertTrue(state['saved'])
        self.assertEqual(os.listdir(closed), ['biped.glb'])

    def test_a_recording_that_cannot_be_written_is_told_in_a_box(self):
        closed = self.closed_folder()
        window = self.open(before=obey_permissions)
        window.settle()
        window.key('alt+f', 'd')
        self.answer(window, 'Record a script', os.path.join(closed, 'r.jsonl'))
        window.focus_dialog('Not recorded')
        self.assertIn('Permission denied', window.where(widget='qt_msgbox_label')['text'])
        window.click_widget('OK')
        self.assertNotIn('record_script', window.state()['marks'])
        self.assertFalse(window.ask(command='record', path=os.path.join(closed, 'r.jsonl'))['ok'])
        self.assertEqual(os.listdir(closed), ['biped.glb'])

    def test_a_name_without_an_ending_gets_the_chosen_filters_and_a_scene_of_that_name_is_asked_about(self):
        shutil.copy(path('biped.glb'), self.in_folder('taken.glb'))
        window = self.open()
        title = window.settle()['title']
        window.run('remove_slides', slides=['brow'])
        window.settle()
        for answer in ('No', 'Yes'):
            window.key('ctrl+shift+s')
            self.answer(window, 'Save as', self.in_folder('taken'))
            window.focus_dialog('Replace it')
            if answer == 'No':
                window.shot('replace_it')
            window.click_widget(answer)
            window.focus('main_window')
            if answer == 'No':
                self.assertEqual(window.state()['title'].replace('*', ''), title)
        self.status(window, 'Saved taken.glb')
        self.assertFalse(os.path.exists(self.in_folder('taken')))
        window.key('ctrl+shift+s')
        self.answer(window, 'Save as', self.in_folder('free'))
        self.status(window, 'Saved free.glb')

    def test_saving_the_scene_of_a_model_asks_where_another_has_its_name(self):
        shutil.copy(path('biped.off'), self.in_folder('taken.off'))
        shutil.copy(path('biped.glb'), self.in_folder('taken.glb'))
        window = self.open(self.in_folder('taken.off'))
        window.settle()
        window.run('add_slide', point=[0.138, 0.3, 0.05])
        window.settle()
        window.key('ctrl+s')
        self.answer(window, 'Save as', self.in_folder('free.glb'))
        self.status(window, 'Saved free.glb')
        with open(path('biped.glb'), 'rb') as before, open(self.in_folder('taken.glb'), 'rb') as after:
            self.assertEqual(after.read(), before.read())


class Opening(DialogTest):
    def test_a_path_that_is_typed_whole_into_the_folder_that_is_shown_is_opened(self):
        window = self.open('biped.off')
        window.settle()
        for name, slides in (('biped.glb', 17), ('biped.off', 0), ('biped.glb', 17)):
            window.focus('main_window')
            window.key('ctrl+o')
            self.answer(window, 'Open', path(name))
            window.wait_until(lambda s: s['has_scene'] and len(s['slides']) == slides, name + ' is open', 20)
            window.settle()


class Exporting(DialogTest):
    def test_the_cage_is_exported_as_a_mesh_that_encloses_the_model(self):
        window = self.open()
        window.settle()
        window.key('ctrl+e')
        self.answer(window, 'Export the cage', self.in_folder('cage.obj'))
        self.status(window, 'Exported the cage to cage.obj')
        subprocess.run([PROGRAM, 'check', path('biped.off'), self.in_folder('cage.obj')], check=True,
                       stdout=subprocess.DEVNULL)

    def test_it_is_said_where_the_cage_that_is_written_is_not_that_of_the_slides(self):
        window = self.open()
        window.settle()
        waist = next(slide for slide in window.state()['slides'] if slide['name'] == 'waist')
        window.run('add_slide', name='tilted', center=waist['center'], u=waist['u'], v=[0, 0.1, 0.1])
        self.assertTrue(window.settle()['cage']['failed'])
        window.key('ctrl+e')
        self.answer(window, 'Export the cage', self.in_folder('cage.obj'))
        why = 'the last good cage: the slides as they are now give none'
        self.status(window, 'Exported to cage.obj: ' + why)
        window.run('save', path=self.in_folder('failed.glb'))
        self.status(window, 'Saved failed.glb with ' + why)

    def test_it_is_said_where_the_cage_that_is_written_is_that_of_slides_before_for_want_of_a_plugin(self):
        scene = self.in_folder('moved.glb')
        shutil.copy(path('biped.glb'), scene)
        window = self.open(scene, environment={'CAGEWRIGHT_PLUGIN': self.in_folder('none.so')})
        window.run('save')
        self.status(window, 'Saved moved.glb')
        self.assertEqual(window.state()['status'], 'Saved moved.glb')
        window.run('change_slide', slide='waist', move=[0, 0.02, 0])
        window.run('save')
        self.status(window, 'Saved moved.glb with the cage that it had: without a plug-in that of the slides as they are '
                            'now is not made')

    def test_it_is_said_where_the_cage_that_is_written_was_outdated_when_its_solve_was_cancelled(self):
        window = self.open()
        window.settle()
        window.run('set_parameter', id='refine.delta', value=0.05)  # slow: seconds
        window.focus('main_window')
        window.key('Escape')
        self.assertFalse(window.settle()['cage']['is_of_now'])
        window.run('save', path=self.in_folder('old.glb'))
        self.status(window, 'Saved old.glb with an older cage: that of the slides as they are now was not made')

    def test_a_picture_is_exported(self):
        window = self.open()
        window.settle()
        window.key('alt+f', 'p')
        self.answer(window, 'Export a picture', self.in_folder('view.png'))
        self.status(window, 'Exported a picture to view.png')
        with open(self.in_folder('view.png'), 'rb') as file:
            self.assertEqual(file.read(4), b'\x89PNG')

    def test_names_without_an_ending_get_one(self):
        window = self.open()
        window.settle()
        window.key('ctrl+e')
        self.answer(window, 'Export the cage', self.in_folder('cage'))
        self.status(window, 'Exported the cage to cage.obj')
        window.focus('main_window')
        window.key('alt+f', 'p')
        self.answer(window, 'Export a picture', self.in_folder('view'))
        self.status(window, 'Exported a picture to view.png')

    def test_an_export_that_fails_says_so_in_a_box_with_the_endings_that_can_be(self):
        window = self.open()
        window.settle()
        window.key('ctrl+e')
        self.answer(window, 'Export the cage', self.in_folder('cage.txt'))
        window.focus_dialog('Not exported')
        self.assertIn('cage.txt: a cage is exported as .obj, .off, .ply, .stl, .glb or .gltf',
                      window.where(widget='qt_msgbox_label')['text'])
        window.click_widget('OK')
        window.focus('main_window')
        window.key('alt+f', 'p')
        self.answer(window, 'Export a picture', self.in_folder('view.jpg'))
        window.focus_dialog('Not exported')
        self.assertIn('a picture is written as .png', window.where(widget='qt_msgbox_label')['text'])
        window.click_widget('OK')
        self.assertEqual(os.listdir(self.folder), [])

    def turntable(self, window, frames):
        window.focus('main_window')
        window.key('alt+f', 't')
        self.answer(window, 'Folder for', self.folder)
        self.answer(window, 'Turntable', str(frames))

    def frames(self):
        return sorted(name for name in os.listdir(self.folder) if name.endswith('.png'))

    def test_a_turntable_is_exported(self):
        window = self.open()
        window.settle()
        self.turntable(window, 3)
        self.status(window, 'Exported the frames of a turn to ' + self.folder)
        self.assertEqual(self.frames(), ['frame_0001.png', 'frame_0002.png', 'frame_0003.png'])

    def test_a_turntable_shows_how_far_it_is_and_can_be_cancelled(self):
        window = self.open()
        window.settle()
        self.turntable(window, 300)
        wait_for(lambda: len(self.frames()) > 1, 'frames are written')
        self.assertTrue(window.ask(command='where', widget='Cancel')['ok'])
        window.shot('turntable')
        window.click_widget('Cancel')
        state = self.status(window, 'Cancelled: frames 1 to ')
        written = len(self.frames())
        self.assertLess(written, 300)
        self.assertIn('1 to %d of 300 are in ' % written, state['status'])
        self.assertEqual(len(state['slides']), 17)
        window.focus('main_window')
        window.key('ctrl+a')
        window.wait_until(lambda s: len(s['selection']) == 17, 'the window goes on')


if __name__ == '__main__':
    run_tests()
