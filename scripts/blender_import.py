#!/usr/bin/env python3
"""Opens baked floors in Blender, sorted into collections, and saves them: a floor, a building or a whole bake.

  python scripts/blender_import.py BAKE... --save building.blend [--levels PATTERN] [--no-ceilings] [--asset-catalog]
  blender --background --python scripts/blender_import.py -- BAKE... --save building.blend

BAKE is a .glb or .gltf, a building's folder, or a bake with its manifest.json. The first line needs Blender's Python
module, scripts/requirements-render.txt. Exit 0: saved. 1: a floor or the saving failed, nothing is written. 2: nothing
could start.

In Blender's window the same is File > Import > Roomwright bake, after scripts/pack_blender_extension.py has made the
extension and Edit > Preferences > Get Extensions > Install from Disk has installed it.
"""

import sys
from pathlib import Path

# Blender's --python leaves the script's folder out.
sys.path.insert(0, str(Path(__file__).resolve().parent))
import environment

environment.require(environment.BLENDER, __name__)

from blender.import_command import main

if __name__ == "__main__":
    sys.exit(main(manual=__doc__))
