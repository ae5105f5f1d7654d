# SPDX-License-Identifier: BSD-3-Clause
"""A real window on an X server of its own, steered by real mouse and keyboard events (xdotool) and seen by screenshots
(ImageMagick). What is where it tells itself, through `--commands`."""
import ctypes
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time

SCREEN = (1400, 900)


class Picture:
    """A screenshot: rows of RGB bytes."""

    def __init__(self, width, height, pixels):
        self.width, self.height, self.pixels = width, height, pixels

    def at(self, x, y):
        i = 3 * (y * self.width + x)
        return tuple(self.pixels[i:i + 3])

    def count(self, rectangle, is_wanted):
        """Pixels within (x, y, width, height) of which is_wanted(r, g, b) holds."""
        x0, y0, width, height = rectangle
        total = 0
        for y in range(max(0, y0), min(self.height, y0 + height)):
            row = self.pixels[3 * (y * self.width + max(0, x0)):3 * (y * self.width + min(self.width, x0 + width))]
            total += sum(1 for i in range(0, len(row), 3) if is_wanted(row[i], row[i + 1], row[i + 2]))
        return total

    def differs(self, other, rectangle):
        """Pixels within the rectangle that are not the same."""
        x0, y0, width, height = rectangle
        total = 0
        for y in range(y0, y0 + height):
            begin, end = 3 * (y * self.width + x0), 3 * (y * self.width + x0 + width)
            a, b = self.pixels[begin:end], other.pixels[begin:end]
            if a != b:
                total += sum(1 for i in range(0, len(a), 3) if a[i:i + 3] != b[i:i + 3])
        return total

    def part(self, rectangle):
        """The picture within (x, y, width, height)."""
        x, y, width, height = rectangle
        rows = (self.pixels[3 * (row * self.width + x):3 * (row * self.width + x + width)]
                for row in range(y, y + height))
        return Picture(width, height, b''.join(rows))

    def save(self, path):
        """As PNG, for people to look at."""
        header = b'P6 %d %d 255\n' % (self.width, self.height)
        subprocess.run(['convert', 'ppm:-', path], input=header + self.pixels, check=True)


def is_red(r, g, b):
    """A slide's ellipse."""
    return r > 170 and g < 90 and b < 90


def is_green(r, g, b):
    """A section."""
    return g > 130 and r < 110 and b < 120


def is_selected(r, g, b):
    """A selected slide's ellipse."""
    return r > 200 and 140 < g < 240 and b < 120


class Server:
    """An X server without a window manager."""

    def __init__(self, scale=1):
        read, write = os.pipe()
        screen = '%dx%dx24' % (SCREEN[0] * scale, SCREEN[1] * scale)
        self.process = subprocess.Popen(
            ['Xvfb', '-displayfd', str(write), '-screen', '0', screen, '-noreset', '-nolisten', 'tcp'],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            self.display = ':' + number.readline().strip()

    def release(self, button):
        """What a window that was killed has left pressed."""
        subprocess.run(['xdotool', 'mouseup', str(button)], env=dict(os.environ, DISPLAY=self.display), check=True)

    def close(self):
        self.process.terminate()
        self.process.wait()


class HangingCopy:
    """A program that has copied something and never answers who asks for it, as one that hangs."""

    def __init__(self, display):
        self.x11 = ctypes.CDLL('libX11.so.6')
        for function in (self.x11.XOpenDisplay, self.x11.XDefaultRootWindow, self.x11.XCreateSimpleWindow,
                         self.x11.XInternAtom, self.x11.XGetSelectionOwner):
            function.restype = ctypes.c_void_p  # as wide as pointers and X's ids are
        self.connection = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))
        root = ctypes.c_ulong(self.x11.XDefaultRootWindow(self.connection))
        window = self.x11.XCreateSimpleWindow(self.connection, root, 0, 0, 1, 1, 0, ctypes.c_ulong(0), ctypes.c_ulong(0))
        clipboard = ctypes.c_ulong(self.x11.XInternAtom(self.connection, b'CLIPBOARD', 0))
        self.x11.XSetSelectionOwner(self.connection, clipboard, ctypes.c_ulong(window), ctypes.c_ulong(0))
        assert self.x11.XGetSelectionOwner(self.connection, clipboard) == window

    def close(self):
        self.x11.XCloseDisplay(self.connection)


def obey_permissions():
    """Of a process that is about to be: takes from root the right to write where permissions do not let it."""
    drop_from_bounding_set, dac_override = 24, 1
    if os.geteuid() == 0:
        ctypes.CDLL(None).prctl(drop_from_bounding_set, dac_override, 0, 0, 0)


class Window:
    """`cagewright view` with a home of its own, so that no settings of the user's are read or written."""

    def __init__(self, server, program, *arguments, home=None, environment=None,
                 errors=None, before=None):
        self.home = home or tempfile.mkdtemp(prefix='cagewright-window-')
        self.environment = dict(os.environ, DISPLAY=server.display, HOME=self.home,
                                XDG_CONFIG_HOME=os.path.join(self.home, 'config'), QT_QPA_PLATFORM='xcb',
                                **(environment or {}))
        self.process = subprocess.Popen([program, 'view', '--commands', *map(str, arguments)], env=self.environment,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors, preexec_fn=before)
        self.pending = b''
        self.settle()
        self.focus('main_window')

    # ---- what the window says

    def ask(self, timeout=60, **command):
        """Runs a command and returns its answer; 'ok' tells whether it went well."""
        return self.ask_line(json.dumps(command), timeout)

    def ask_line(self, line, timeout=60):
        """The same of any text."""
        self.process.stdin.write(line.encode() + b'\n')
        self.process.stdin.flush()
        end = time.monotonic() + timeout
        while b'\n' not in self.pending:
            ready, _, _ = select.select([self.process.stdout], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise AssertionError('no answer within %g s to %s' % (timeout, line))
            more = os.read(self.process.stdout.fileno(), 1 << 20)
            if not more:
                raise AssertionError('the window has gone (exit code %r)' % self.process.wait())
            self.pending += more
        line, self.pending = self.pending.split(b'\n', 1)
        return json.loads(line)

    def run(self, command, **arguments):
        answer = self.ask(command=command, **arguments)
        assert answer['ok'], answer
        return answer

    def state(self):
        return self.run('state')

    def where(self, **what):
        return self.run('where', **what)

    def wait_until(self, holds, what, timeout=60):
        """Polls the state; returns the first of which holds(state) is true."""
        end = time.monotonic() + timeout
        while time.monotonic() < end:
            state = self.state()
            if holds(state):
                return state
            time.sleep(0.03)
        raise AssertionError('not within %g s: %s; %r' % (timeout, what, state))

    def settle(self, timeout=120):
        """Until no cage is being made, and what is to be drawn is drawn."""
        state = self.wait_until(lambda s: not s['solving'], 'the cage is made', timeout)
        time.sleep(0.25)
        self.state()
        return state

    def view(self):
        at = self.where(widget='view')
        return at['x'], at['y'], at['width'], at['height']

    # ---- mouse and keys

    def xdotool(self, *arguments):
        subprocess.run(['xdotool', *map(str, arguments)], env=self.environment, check=True, stdout=subprocess.DEVNULL,
                       timeout=60)

    def focus(self, _name):
        """Keys go to the window on top: there is no window manager that would see to it."""
        self.xdotool('search', '--sync', '--onlyvisible', '--all', '--pid', self.process.pid, '--name',
                     'Cagewright|cagewright', 'windowfocus')

    def focus_dialog(self, title):
        self.xdotool('search', '--sync', '--onlyvisible', '--name', title, 'windowfocus')

    def resize(self, width, height):
        self.xdotool('search', '--sync', '--onlyvisible', '--pid', self.process.pid, '--name', 'Cagewright|cagewright',
                     'windowsize', width, height)

        def has_size(_):
            at = self.where(widget='main_window')
            return (at['width'], at['height']) == (width, height)

        self.wait_until(has_size, 'it has that size')
        time.sleep(0.3)

    def move(self, x, y):
        self.xdotool('mousemove', round(x), round(y))

    def click(self, x, y, button=1, keys=()):
        self.move(x, y)
        for key in keys:
            self.xdotool('keydown', key)
        self.xdotool('click', button)
        for key in keys:
            self.xdotool('keyup', key)

    def click_widget(self, name):
        at = self.where(widget=name)
        self.click(at['x'] + at['width'] / 2, at['y'] + at['height'] / 2)

    def drag(self, points, button=1, keys=(), pause=0.02, release=True):
        """Along points of the screen, with steps between as a hand has them."""
        self.move(*points[0])
        for key in keys:
            self.xdotool('keydown', key)
        self.xdotool('mousedown', button)
        for (x0, y0), (x1, y1) in zip(points, points[1:]):
            steps = max(2, int(max(abs(x1 - x0), abs(y1 - y0)) / 8))
            for i in range(1, steps + 1):
                self.move(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps)
                time.sleep(pause)
        if release:
            self.release(button, keys)

    def release(self, button=1, keys=()):
        self.xdotool('mouseup', button)
        for key in keys:
            self.xdotool('keyup', key)

    def key(self, *keys):
        self.xdotool('key', *keys)
        time.sleep(0.1)

    def type(self, text):
        self.xdotool('type', '--delay', '5', '--', text)

    # ---- pictures

    def shot(self, keep=None):
        time.sleep(0.2)
        whole = subprocess.run(['import', '-window', 'root', '-silent', 'miff:-'], env=self.environment, check=True,
                               stdout=subprocess.PIPE).stdout
        size = subprocess.run(['identify', '-format', '%w %h', 'miff:-'], input=whole, check=True, stdout=subprocess.PIPE)
        pixels = subprocess.run(['convert', 'miff:-', '-depth', '8', 'rgb:-'], input=whole, check=True,
                                stdout=subprocess.PIPE)
        width, height = map(int, size.stdout.split())
        picture = Picture(width, height, pixels.stdout)
        folder = os.environ.get('CAGEWRIGHT_KEEP_SHOTS')
        if folder and keep:
            picture.save(os.path.join(folder, keep + '.png'))
        return picture

    # ---- the end

    def close(self, keep_home=False):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        if not keep_home:
            shutil.rmtree(self.home, ignore_errors=True)

    def crash(self):
        self.process.send_signal(signal.SIGKILL)
        self.close(keep_home=True)
