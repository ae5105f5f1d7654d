# SPDX-License-Identifier: BSD-3-Clause
"""What the window's own overlay (View > Show Speed) says while slides are dragged with the mouse, each in turn.

    python3 overlay_bench.py PROGRAM MODEL SLIDES.json [SECONDS] [WIDTHxHEIGHT] [view's options]

The mouse goes to and fro along the slide's normal, a pixel at a time, 125 times a second; a drag takes SECONDS (3)."""
import json
import math
import statistics
import sys

from window_driver import SCREEN, Server, Window

STEP_S, REACH = 0.008, 8  # pixels


def to_and_fro(step):
    return abs((step + REACH) % (4 * REACH) - 2 * REACH) - REACH


def drag(window, slide, seconds):
    """The overlay's figures at the end of the drag; without cages where the handle could not be reached."""
    window.run('select', slides=[slide['name']])
    window.key('w')
    window.settle()
    center, tip = window.where(point=slide['center']), window.where(handle=2)
    along = [tip[k] - center[k] for k in 'xy']
    length = math.hypot(*along)
    if length < 1:
        return None
    path = ['mousemove', tip['x'], tip['y'], 'mousedown', 1]
    for step in range(int(seconds / STEP_S)):
        way = to_and_fro(step) / length
        path += ['mousemove', round(tip['x'] + way * along[0]), round(tip['y'] + way * along[1]), 'sleep', STEP_S - 0.002]
    window.xdotool(*path)
    speed = window.state()['speed']
    window.xdotool('mouseup', 1)
    window.key('z')
    window.settle()
    return speed if speed['cages'] > 1 else None


def show(name, speed):
    print('%-20s %10.1f %11.0f %9.0f %9.0f %7d' % (name, speed['per_second'], speed['median_ms'],
                                                  speed['percentile_95_ms'], speed['frame_ms'], speed['cages']), flush=True)


def main(program, model, slides_file, seconds=3, size='%dx%d' % SCREEN, *options):
    with open(slides_file) as file:
        slides = json.load(file)['slides']
    server = Server()
    window = Window(server, program, *options)
    try:
        window.xdotool('search', '--onlyvisible', '--name', 'Cagewright', 'windowsize', *size.split('x'))
        window.run('open', path=model)
        for slide in slides:
            window.run('add_slide', **slide)
        window.run('show', what='speed', on=True)
        window.run('frame')
        window.settle()
        print('window %s, view %dx%d' % (size, *window.view()[2:]))
        print('%-20s %10s %11s %9s %9s %7s' % ('slide', '/s', 'median ms', '95 % ms', 'frame ms', 'cages'))
        seen = []
        for slide in window.state()['slides']:
            speed = drag(window, slide, float(seconds))
            if speed is None:
                print('%-20s its handle points at the viewer, or nothing followed' % slide['name'])
                continue
            show(slide['name'], speed)
            seen.append(speed)
        if not seen:
            sys.exit('overlay_bench: nothing was dragged')
        show('median of slides', {key: statistics.median(speed[key] for speed in seen) for key in seen[0]})
        show('slowest slide', min(seen, key=lambda speed: speed['per_second']))
    finally:
        window.close()
        server.close()


if __name__ == '__main__':
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
