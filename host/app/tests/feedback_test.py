# SPDX-License-Identifier: BSD-3-Clause
"""What the window says and shows about what was done: themes, numbers, status line, outliner, menus.

    python3 feedback_test.py PROGRAM TESTDATA SLIDES_FOLDER SCENES_FOLDER [unittest's arguments]
"""
from window_case import run_tests, setUpModule, tearDownModule, WindowTest


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


if __name__ == '__main__':
    run_tests()
