"""Imported first by the scripts: lets them import the package `roomwright` from the project's folder, without an installation."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))
