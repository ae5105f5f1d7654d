# SPDX-License-Identifier: BSD-3-Clause
"""What docs/first-cage.md promises: strokes by mouse make a certified cage, which is there again when the scene that was
saved is opened.

    python3 tutorial_test.py PROGRAM TESTDATA STROKES_FOLDER REAL_MODELS [unittest's arguments]

REAL_MODELS may be empty. CAGEWRIGHT_KEEP_SHOTS=FOLDER keeps the screenshots; CAGEWRIGHT_STROKE_PACE=SECONDS waits before
each stroke, as a person does."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from first_cage import FirstCage
from window_driver import Server, Window, is_green, is_red, is_selected

PROGRAM, TESTDATA, STROKES, REAL_MODELS = sys.argv[1:5] if len(sys.argv) > 4 else [''] * 4


def is_cage(r, g, b):
    """An edge of the cage."""
    return b > 200 and 120 < g < b and r < 150


def is_problem(r, g, b):
    """What is said in the view of a slide that fails, and its dashes."""
    return r > 200 and 100 < g < 180 and b < 120


def is_stroke(r, g, b):
    return r > 235 and 205 < g < 240 and 95 < b < 135


def setUpModule():
    global server, folder
    server = Server()
    folder = tempfile.mkdtemp(prefix='cagewright-tutorial-test-')


def tearDownModule():
    server.close()
    shutil.rmtree(folder, ignore_errors=True)


def path(name):
    return os.path.join(folder, name)


def faces(obj):
    return [line for line in obj.splitlines() if line.startswith('f ')]


class FirstCageTest:
    """Of `model`, a file in the test's folder."""

    def test_strokes_by_mouse_make_a_certified_cage_that_is_saved_and_opened_again(self):
        name = os.path.splitext(self.model)[0]
        self.session = FirstCage(server, PROGRAM, path(self.model), os.path.join(STROKES, name + '.strokes.json'),
                                 float(os.environ.get('CAGEWRIGHT_STROKE_PACE', 0)))
        self.addCleanup(self.session.close)
        self.assertEqual(len(self.session.strokes), self.strokes)
        seen = []
        for stage in self.session.stages():
            with self.subTest(stage):
                self.window = self.session.window
                self.state, self.view = self.window.state(), self.window.view()
                self.shot = self.window.shot('%s_%s' % (name, stage))
                getattr(self, 'see_' + stage)()
            seen.append(stage)
        self.assertEqual([stage for stage in seen if stage != 'problem'],
                         ['opened', 'stroke', 'first_slide', 'half', 'all', 'saved', 'reopened'])
        print('%s: %d strokes drawn and the cage certified in %.0f s' % (name, self.strokes, self.session.seconds),
              file=sys.stderr)

    def count(self, is_wanted):
        return self.shot.count(self.view, is_wanted)

    def see_certified(self, slides):
        self.assertEqual(len(self.state['slides']), slides)
        self.assertTrue(self.state['cage']['certified'], self.state)
        # Advice there may be: of few slides a cage is large.
        self.assertEqual([problem for problem in self.state['problems'] if not problem['is_advice']], [])
        self.assertIn('Certified', self.window.where(widget='verdict')['text'])
        self.assertGreater(self.count(is_cage), 800)

    def export_cage(self, file, window=None):
        (window or self.window).run('export_cage', path=path(file))
        with open(path(file), encoding='utf-8') as text:
            return text.read()

    def see_opened(self):
        self.assertEqual(self.state['slides'], [])
        self.assertIn('Draw Slides', self.window.where(widget='help')['text'])
        self.assertLess(self.count(is_red), 60)  # an axis in the corner
        self.assertLess(self.count(is_green), 60)

    def see_stroke(self):
        self.assertEqual(self.state['slides'], [])
        self.assertGreater(self.count(is_stroke), 100)
        self.assertGreater(self.count(is_cage), 200)

    def see_first_slide(self):
        self.see_certified(1)
        self.assertGreater(self.count(is_selected), 20)

    def see_half(self):
        self.see_certified(self.session.half)

    def see_all(self):
        self.see_certified(self.strokes)
        self.assertGreater(self.count(is_red), 300)
        self.assertGreater(self.count(is_green), 300)
        self.drawn, self.cage = self.state['slides'], self.export_cage('before.obj')
        run = subprocess.run([PROGRAM, 'check', path(self.model), path('before.obj')], stdout=subprocess.PIPE)
        self.assertEqual(run.returncode, 0, run.stdout)

    def see_saved(self):
        self.assertTrue(os.path.exists(self.session.scene))
        self.assertNotIn('*', self.state['title'])

    def see_reopened(self):
        self.assertEqual(self.session.exit_code, 0)
        self.see_certified(self.strokes)
        self.assertGreater(self.count(is_red), 300)
        self.see_same_slides()
        self.see_same_cage()

    def see_same_slides(self):
        self.assertEqual([slide['name'] for slide in self.state['slides']], [slide['name'] for slide in self.drawn])
        for slide, drawn in zip(self.state['slides'], self.drawn):
            size = max(map(abs, drawn['u'] + drawn['v']))
            for vector in ('center', 'u', 'v'):
                for now, before in zip(slide[vector], drawn[vector]):
                    self.assertAlmostEqual(now / size, before / size, 9, slide['name'])

    def see_same_cage(self):
        """The saved one, to the bit. The one that is made of the reopened slides has the same faces; its vertices may be
        elsewhere, since the slides' last digits are."""
        without_plugin = Window(server, PROGRAM, environment={'CAGEWRIGHT_PLUGIN': path('none.so')})
        self.addCleanup(without_plugin.close)
        without_plugin.run('open', path=self.session.scene)
        self.assertEqual(self.export_cage('stored.obj', without_plugin), self.cage)
        self.assertEqual(faces(self.export_cage('after.obj')), faces(self.cage))


class OwnModel(FirstCageTest, unittest.TestCase):
    model, strokes = 'biped.off', 14

    def setUp(self):
        subprocess.run([TESTDATA, folder, '--only', 'biped'], check=True, stdout=subprocess.DEVNULL)

    def see_problem(self):
        self.assertEqual(self.state['problems'][0]['slides'], ['slide 4', 'slide 9'])
        self.assertRegex(self.state['problems'][0]['sentence'], "^'slide 4' meets 'slide 9' at .*: move one of them$")
        self.assertTrue(self.state['cage']['failed'])
        self.assertIn('last good cage', self.window.where(widget='verdict')['text'])
        self.assertIn('Ctrl+Z', self.window.where(widget='hint')['text'])
        self.assertGreater(self.count(is_problem), 100)


class RealModel(FirstCageTest, unittest.TestCase):
    model, strokes = 'armadillo.off', 23

    def setUp(self):
        if not REAL_MODELS:
            self.skipTest('armadillo is a real model: configure with -DCAGEWRIGHT_REAL_MODELS=DIR')
        shutil.copy(os.path.join(REAL_MODELS, self.model), folder)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1] + sys.argv[5:], verbosity=2)
