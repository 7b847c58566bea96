"""What a machine keeps between units: the program and the plans of a job, and the textures that all units share."""

from __future__ import annotations

import os
import secrets
import shutil
import stat
import tempfile
from pathlib import Path
from typing import NamedTuple

from .failure import Failure
from .inputs import unpack
from .job import Job
from .store import Store

# Names another folder than that for temporary files, where that one is small.
FOLDER_VARIABLE = "ROOMWRIGHT_CLUSTER_FOLDER"


class Node(NamedTuple):
    """A machine that is ready for units of a job."""

    program: Path
    inputs: Path
    cache: Path
    scratch: Path


def prepare(store: Store, job: Job) -> Node:
    """Fetches what is not here yet. Several processes may do so at the same time."""
    folder = home()
    own = folder / job.key
    if not own.is_dir():
        fetch(store, job, own)
    scratch = folder / "scratch"
    scratch.mkdir(exist_ok=True)
    sweep(scratch)
    return Node(own / "roomwright", own / "inputs", cache_of(job.program), scratch)


def home() -> Path:
    """The folder of this machine for all jobs."""
    default = Path(tempfile.gettempdir()) / f"roomwright-cluster-{getattr(os, 'getuid', int)()}"
    folder = Path(os.environ.get(FOLDER_VARIABLE, default))
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    # Others could put a program of theirs into a folder that is not ours alone.
    if hasattr(os, "getuid") and folder.stat().st_uid != os.getuid():
        raise Failure(f"{folder} belongs to somebody else; name another folder with {FOLDER_VARIABLE}")
    return folder


def cache_of(program: str) -> Path:
    """The textures and models of a program, by its hash."""
    cache = home() / f"cache-{program[:16]}"
    cache.mkdir(exist_ok=True)
    return cache


def fetch(store: Store, job: Job, own: Path) -> None:
    """Fetches program and plans into a new folder, which takes its name when it is whole."""
    fresh = own.with_name(f"{own.name}.{secrets.token_hex(8)}")
    try:
        (fresh / "inputs").mkdir(parents=True)
        program, packed = store.read(job.program_name), store.read(job.inputs_name)
        if program is None or packed is None:
            raise Failure("the store lacks the program or the plans of its job")
        (fresh / "roomwright").write_bytes(program)
        (fresh / "roomwright").chmod(stat.S_IRWXU)
        unpack(packed, fresh / "inputs")
        fresh.rename(own)
    except OSError:
        # Another process was first.
        if not own.is_dir():
            raise
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def sweep(scratch: Path) -> None:
    """Removes what processes that were killed have left."""
    for folder in scratch.iterdir():
        owner = folder.name.split("-")[0]
        if owner.isdigit() and not is_alive(int(owner)):
            shutil.rmtree(folder, ignore_errors=True)


def is_alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True
