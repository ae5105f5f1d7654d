# SPDX-License-Identifier: BSD-3-Clause
"""What the window says and shows about what was done: themes, numbers, status line, outliner, menus.

    python3 feedback_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
import shutil

from window_case import path, run_tests, setUpModule, tearDownModule, WindowTest


def rectangle(at):
    return at['x'], at['y'], at['width'], at['height']


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
                window.key('alt+v', 'd')  # to light; the menu's mark has followed --theme
                window.settle()
                changed = window.shot('outliner_changed').part(rectangle(window.where(widget='outliner')))
            window.close()
        whole = (0, 0, outliners[0].width, outliners[0].height)
        self.assertGreater(outliners[0].differs(outliners[1], whole), 0.9 * whole[2] * whole[3])
        self.assertEqual(changed.differs(outliners[1], whole), 0)


class Telling(WindowTest):
    scene = 'biped.glb'

    def test_the_sentence_of_what_failed_goes_when_the_next_thing_succeeds(self):
        window = self.open()
        window.settle()
        window.key('ctrl+v')
        window.wait_until(lambda s: 'clipboard holds no slides' in s['status'], 'it says so')
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

    def test_a_file_that_cannot_be_opened_is_told_until_one_can(self):
        window = self.open(path('none.glb'))
        window.wait_until(lambda s: 'none.glb' in s['status'], 'it says so')
        window.run('open', path=path('biped.off'))
        self.assertEqual(window.state()['status'], '')


if __name__ == '__main__':
    run_tests()
