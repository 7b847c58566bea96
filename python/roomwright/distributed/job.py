"""The identity of the work. The first driver writes it into the store; later ones must want the same."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass
from pathlib import Path

from .failure import Failure
from .inputs import Inputs
from .listing import Division, room_count
from .store import Store, digest

# Names of levels never begin with a dot.
FOLDER = ".cluster"
JOB = f"{FOLDER}/job.json"
RECORDS = f"{FOLDER}/records"
ERRORS = f"{FOLDER}/errors"
# One file for each unit some of whose levels could not be made.
FLAWED = f"{FOLDER}/flawed"

# The largest array of AWS Batch.
MOST_UNITS = 10_000
# `bake` has these set for each unit, or would change other files.
REFUSED_OPTIONS = ("--out", "--shard", "--force", "--prune", "--watch", "--threads", "--cache", "--catalog", "--edits",
                   "--progress", "--quiet", "--json", "-o", "--list-levels", "--only-levels")


@dataclass(frozen=True)
class Job:
    """All that the output depends on, and how it is divided."""

    program: str
    inputs: str
    arguments: list[str]
    units: int
    levels: int
    rooms: int
    # The lists of levels that the units are baked from, by their hash.
    division: str

    def record(self, unit: int) -> str:
        return f"{RECORDS}/manifest.{unit}-of-{self.units}.json"

    @property
    def program_name(self) -> str:
        return f"{FOLDER}/program-{self.program}"

    @property
    def inputs_name(self) -> str:
        return f"{FOLDER}/inputs-{self.inputs}.tar.gz"

    @property
    def lists(self) -> str:
        return f"{FOLDER}/units-{self.division}"

    @property
    def levels_name(self) -> str:
        return f"{self.lists}/levels.json"

    def list_of(self, unit: int) -> str:
        return f"{self.lists}/{unit}.json"

    @property
    def key(self) -> str:
        """A name for what a machine keeps of it."""
        return f"{self.program[:16]}-{self.inputs[:16]}"


def check_options(options: list[str]) -> None:
    """Refuses options of `bake` that are no business of a unit."""
    for option in options:
        if option.split("=")[0] in REFUSED_OPTIONS:
            raise Failure(f"{option.split('=')[0]} cannot be given to the units; see `cluster.py --help`")


def new_job(program: Path, inputs: Inputs, options: list[str], division: Division) -> Job:
    levels = division.listed["levels"]
    return Job(digest(program, "sha256"), inputs.sha256, [*inputs.arguments, *options],
               len(division.units), len(levels), room_count(levels), division.sha256)


def read_job(store: Store) -> Job | None:
    """The job in a store."""
    content = store.read(JOB)
    return None if content is None else parse(content)


def parse(content: bytes) -> Job:
    try:
        return Job(**json.loads(content))
    except (ValueError, TypeError) as error:
        raise Failure(f"{JOB} in the store is no job of this script: {error}") from error


def agree(store: Store, wanted: Job, program: Path, inputs: Inputs, division: Division) -> Job:
    """Puts program, inputs, lists and job into the store, in this order; or checks that the job there is the same one."""
    found = read_job(store)
    if found is None:
        for name, put in ((wanted.program_name, lambda name: store.put(program, name)),
                          (wanted.inputs_name, lambda name: store.write(name, inputs.archive))):
            if not store.has(name):
                put(name)
        division.put(store, wanted.lists)
        found = parse(store.create(JOB, json.dumps(asdict(wanted), indent=1).encode()))
    differing = differences(found, wanted)
    if differing:
        raise Failure(f"the store holds another job: it differs in {', '.join(differing)}. Choose another place with --to, "
                      "or empty that one")
    return found


def differences(found: Job, wanted: Job) -> list[str]:
    """How two jobs differ, the division into units left aside: it changes no byte of the result."""
    names = {"program": "the program", "inputs": "the plans or the configuration", "arguments": "the options of bake"}
    return [words for field, words in names.items() if getattr(found, field) != getattr(wanted, field)]
