#!/usr/bin/env python3
"""Writes a level that was edited in Blender as a file that roomwright reads: `roomwright audit` judges it.

  python scripts/blender_export.py house.blend --level house/ground --out edited.glb
  blender --background --python scripts/blender_export.py -- house.blend --level house/ground --out edited.glb

The first line needs Blender's Python module, scripts/requirements-render.txt. Exit 0: written. 1: the export failed,
nothing is written. 2: nothing could start.

In Blender's window the same is File > Export > Roomwright floor, after scripts/pack_blender_extension.py has made the
extension and Edit > Preferences > Get Extensions > Install from Disk has installed it.
"""

import sys
from pathlib import Path

# Blender's --python leaves the script's folder out.
sys.path.insert(0, str(Path(__file__).resolve().parent))
import environment

environment.require(environment.BLENDER, __name__)

from blender.export_command import main

if __name__ == "__main__":
    sys.exit(main(manual=__doc__))
