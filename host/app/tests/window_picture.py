# SPDX-License-Identifier: BSD-3-Clause
"""Makes the picture of the window in the documents.

    python3 window_picture.py PROGRAM MODEL SLIDES PICTURE.png
"""
import os
import subprocess
import sys
import tempfile

from window_driver import Server, Window


def main(program, model, slides, picture):
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, os.path.splitext(os.path.basename(model))[0] + '.glb')
        subprocess.run([program, 'cage', model, '--slides', slides, '-o', scene, '--quiet'], check=True,
                       stdout=subprocess.DEVNULL)
        server = Server()
        window = Window(server, program, scene)
        try:
            window.settle()
            window.run('select', slides=['left_elbow'])
            window.key('w')
            window.settle()
            window.shot().save(picture)
        finally:
            window.close()
            server.close()


if __name__ == '__main__':
    main(*sys.argv[1:5])
