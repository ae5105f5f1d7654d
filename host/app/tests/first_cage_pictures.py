# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of docs/first-cage.md, as the test of the tutorial draws them.

    python3 first_cage_pictures.py PROGRAM MODEL STROKES FOLDER

writes FOLDER/first-cage-STAGE.png."""
import os
import shutil
import sys
import tempfile

from first_cage import FirstCage
from window_driver import Server

# By stage: the name of the picture, and the widget that it shows; the window where there is none.
PICTURES = {
    'opened': [('opened', None)],
    'stroke': [('stroke', 'view')],
    'first_slide': [('first-slide', 'view')],
    'half': [('half', 'view')],
    'problem': [('problem', None)],
    'all': [('all', None), ('certificate', 'report_dock')],
}


def main(program, model, strokes, folder):
    with tempfile.TemporaryDirectory() as work:
        server = Server()
        session = FirstCage(server, program, shutil.copy(model, work), strokes)
        try:
            for stage in session.stages():
                for name, widget in PICTURES.get(stage, []):
                    picture = session.window.shot()
                    if widget:
                        at = session.window.where(widget=widget)
                        picture = picture.part((at['x'], at['y'], at['width'], at['height']))
                    picture.save(os.path.join(folder, 'first-cage-%s.png' % name))
                if stage == 'all':
                    break
        finally:
            session.close()
            server.close()


if __name__ == '__main__':
    main(*sys.argv[1:5])
