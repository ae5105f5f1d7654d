# SPDX-License-Identifier: BSD-3-Clause
"""The session of docs/first-cage.md: a model is opened, strokes are drawn on it, and the cage is saved and opened again,
all by mouse and keys. The test asserts each of its stages, and the tutorial's pictures are taken of them.

The strokes are those of testdata/strokes/MODEL.strokes.json: each is a path in shares of the view's rectangle, from its
upper left corner, and is drawn after the key that turns the view to that side has framed everything."""
import json
import os
import time

from window_driver import Window

SIDES = ['perspective', 'front', 'back', 'left', 'right', 'top', 'bottom']  # Alt+0, Alt+1 ...
SHAPE = 808 / 816  # the view's width over its height, with which the paths were drawn
CAGE_TIMEOUT = 240


class FirstCage:
    """`pace`: seconds before each stroke, as a person looks where it goes. `seconds`: from taking the tool to the
    certified cage of all strokes, without screenshots and the mistake."""

    def __init__(self, server, program, model, strokes, pace=0):
        with open(strokes, encoding='utf-8') as file:
            session = json.load(file)
        self.strokes, self.half = session['strokes'], session['half']
        self.mistake, self.side_to_show = session.get('mistake'), session['looks_good_from']
        self.server, self.program, self.model = server, program, model
        self.scene = os.path.splitext(model)[0] + '.glb'  # where Ctrl+S puts it
        self.window, self.side, self.pace, self.seconds = None, None, pace, 0

    def close(self):
        if self.window:
            self.window.close()

    def stages(self):
        """Yields each stage's name, when it is reached and not gone on from."""
        self.open_window()
        self.choose_file(self.model)
        yield 'opened'
        yield from self.draw()
        self.window.key('ctrl+s')
        self.window.wait_until(lambda state: state['saved'], 'Ctrl+S saves', CAGE_TIMEOUT)
        yield 'saved'
        self.window.key('ctrl+q')
        self.exit_code = self.window.process.wait(60)
        self.open_window()
        self.choose_file(self.scene)
        self.window.settle(CAGE_TIMEOUT)
        self.look(self.side_to_show)
        yield 'reopened'

    def open_window(self):
        self.close()
        self.window, self.side = Window(self.server, self.program), None

    def choose_file(self, path):
        """In the dialog of File > Open."""
        self.window.key('ctrl+o')
        self.window.focus_dialog('^Open$')
        self.window.type(path)
        self.window.key('Return')
        self.window.wait_until(lambda state: state['has_scene'], path + ' is opened')
        self.window.focus('main_window')
        self.window.settle()

    def draw(self):
        begin = time.monotonic()
        self.window.key('d')
        self.stroke(self.strokes[0], release=False)
        self.window.wait_until(lambda state: state['cage']['is_of_editing'] and not state['solving'],
                               'the cage follows the stroke', CAGE_TIMEOUT)
        self.seconds = time.monotonic() - begin
        yield 'stroke'
        begin = time.monotonic()
        self.window.release()
        self.wait_for_cage(1)
        self.seconds += time.monotonic() - begin
        yield 'first_slide'
        self.draw_some(1, self.half)
        yield 'half'
        if self.mistake:
            yield from self.make_a_mistake()
        self.draw_some(self.half, len(self.strokes))
        self.window.key('q', 'ctrl+shift+a')
        self.look(self.side_to_show)
        yield 'all'

    def draw_some(self, first, last):
        begin = time.monotonic()
        for count, stroke in enumerate(self.strokes[first:last], first + 1):
            self.stroke(stroke)
            self.window.wait_until(lambda state: len(state['slides']) == count, stroke['name'] + ' is a slide')
        self.wait_for_cage(last)
        self.seconds += time.monotonic() - begin

    def make_a_mistake(self):
        self.stroke(self.mistake)
        self.window.wait_until(lambda state: state['problems'], 'the problem is said')
        self.window.settle()
        yield 'problem'
        self.window.key('ctrl+z')
        self.wait_for_cage(self.half)

    def stroke(self, stroke, release=True):
        self.look(stroke['view'])
        time.sleep(self.pace)
        x, y, width, height = self.window.view()
        assert abs(width / height / SHAPE - 1) < 0.03, 'the view is %d x %d: draw the strokes anew' % (width, height)
        self.window.drag([(x + width * right, y + height * down) for right, down in stroke['path']], release=release)

    def look(self, side):
        if side != self.side:
            self.window.key('alt+%d' % SIDES.index(side))
            self.window.state()  # answered when the key has been
            self.side = side

    def wait_for_cage(self, slides):
        return self.window.wait_until(
            lambda state: len(state['slides']) == slides and not state['solving'] and state['cage']['is_of_now']
            and not state['cage']['is_of_editing'], 'the cage of %d slides' % slides, CAGE_TIMEOUT)
