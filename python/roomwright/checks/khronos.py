"""The Khronos glTF validator."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

from .report import Fault

# What runs it, with the lock file that `npm ci` sets it up by.
FOLDER = Path(__file__).resolve().parents[1] / "khronos"


def is_installed() -> bool:
    return shutil.which("node") is not None and (FOLDER / "node_modules" / "gltf-validator").is_dir()


def check_khronos(files: list[Path]) -> list[Fault]:
    """Runs the Khronos validator over some files."""
    command = ["node", str(FOLDER / "validate_gltf.mjs"), "-"]
    listed = "".join(f"{file.resolve()}\n" for file in files)
    done = subprocess.run(command, input=listed, capture_output=True, text=True, errors="surrogateescape", check=False)
    reports = [json.loads(line) for line in done.stdout.split("\n") if line]
    if len(reports) != len(files):
        return [Fault(str(files[0]), "khronos", "", f"the validator did not run: {done.stderr.strip()[-300:]}")]
    faults = []
    for file, report in zip(files, reports):
        for message in report["messages"]:
            if message["severity"] in ("error", "warning"):
                faults.append(Fault(str(file), "khronos", message["pointer"],
                                    f"{message['severity']} {message['code']}: {message['message']}"))
        if report["errors"] + report["warnings"] and not report["messages"]:
            faults.append(Fault(str(file), "khronos", "", "errors without a message"))
    return faults
