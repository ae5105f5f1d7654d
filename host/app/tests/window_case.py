# SPDX-License-Identifier: BSD-3-Clause
"""What tests of the window share: a server, the biped as model and as scene, and a window that is closed in the end."""
import glob
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from window_driver import Server, Window

PROGRAM, TESTDATA, SLIDES, SCENES = sys.argv[1:5] if len(sys.argv) > 4 else [''] * 4


def setUpModule():
    global server, folder
    server = Server()
    folder = tempfile.mkdtemp(prefix='cagewright-window-test-')
    subprocess.run([TESTDATA, folder, '--only', 'biped'], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([PROGRAM, 'cage', path('biped.off'), '--slides', os.path.join(SLIDES, 'biped.slides.json'), '-o',
                    path('biped.glb'), '--quiet'], check=True, stdout=subprocess.DEVNULL)


def tearDownModule():
    server.close()
    shutil.rmtree(folder, ignore_errors=True)


def path(name):
    return os.path.join(folder, name)


def middle(a, b, share=0.5):
    return [x + share * (y - x) for x, y in zip(a, b)]


class WindowTest(unittest.TestCase):
    scene = 'biped.off'

    def setUp(self):
        """Windows are killed: on a slow machine an autosave is left, and the next test would be asked to recover it."""
        for left in glob.glob(path('.*.autosave.glb')):
            os.remove(left)

    def open(self, name=None, *arguments, **options):
        window = Window(server, PROGRAM, path(name or self.scene), *arguments, **options)
        self.addCleanup(window.close)
        return window

    def leg(self, window, share=0.5):
        """Two points of the screen beside the left shin, left and right of it, and one on it."""
        knee, ankle = [0.138, 0.51, 0.018], [0.16, 0.12, -0.01]
        at = window.where(point=middle(knee, ankle, share))
        beside = window.where(point=middle([knee[0] + 0.06, *knee[1:]], [ankle[0] + 0.06, *ankle[1:]], share))
        reach = abs(beside['x'] - at['x'])
        return (at['x'] - reach * 0.5, at['y']), (at['x'] + reach * 0.5, at['y']), (at['x'], at['y'])


def run_tests():
    unittest.main(argv=sys.argv[:1] + sys.argv[5:], verbosity=2)
