#!/usr/bin/env python3
"""Runs roomwright.blender.export_command from the project's folder, without an installation; --help is its manual."""

import sys
from pathlib import Path

# Blender's --python leaves the script's folder out.
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))

from roomwright.commands import blender_export

if __name__ == "__main__":
    sys.exit(blender_export())
