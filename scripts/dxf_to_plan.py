#!/usr/bin/env python3
"""Runs roomwright.dxf_to_plan from the project's folder, without an installation; --help is its manual."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))

from roomwright.commands import dxf_to_plan

if __name__ == "__main__":
    sys.exit(dxf_to_plan())
