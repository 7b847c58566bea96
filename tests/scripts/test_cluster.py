"""cluster.py ends with the bytes of one bake, whatever happened on the way."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

from roomwright.distributed import job as jobs
from roomwright.distributed.failure import Failure
from roomwright.distributed.inputs import pack
from roomwright.distributed.sizing import UNIT_SECONDS, cut, cut_into, read_costs, sample_of
from roomwright.distributed.store import Folder, Objects, repeated

SCRIPT = ROOT / "scripts" / "cluster.py"
TEMPLATES = ROOT / "docs" / "cluster"
PROGRAM = os.environ.get("ROOMWRIGHT_PROGRAM") or shutil.which("roomwright") or str(ROOT / "target/release/roomwright")
OPTIONS = ["--textures", "none"]
UNITS = 5
PLAN = """version: 1
id: {id}
walls: {{exterior: 0.3, interior: 0.1}}
levels:
  - id: "{{n}}"
    number: 1
    repeat: 4
    height: 3
    rooms:
      - {{id: bed, type: bedroom, rectangle: [0, 0, 4, 4]}}
      - {{id: study, type: study, rectangle: [4.1, 0, 4, 4]}}
    openings:
      - {{kind: door, at: [4.05, 2], rooms: [bed, study]}}
      - {{kind: window, at: [2, 0], width: 1.2}}
"""
needs_program = pytest.mark.skipif(not Path(PROGRAM).is_file(), reason=f"there is no program {PROGRAM}")


def lacks(*modules: str) -> list[str]:
    return [module for module in modules if importlib.util.find_spec(module) is None]


class City:
    """Plans of two buildings, a place for results, and what one bake makes of the plans."""

    def __init__(self, folder: Path):
        self.folder, self.plans, self.store = folder, folder / "plans", folder / "store"
        self.plans.mkdir()
        for name in ("alpha", "beta"):
            (self.plans / f"{name}.yaml").write_text(PLAN.format(id=name), encoding="utf-8")
        self.environment = {**os.environ, "ROOMWRIGHT_PROGRAM": PROGRAM, "ROOMWRIGHT_CACHE": "none",
                            "ROOMWRIGHT_CLUSTER_FOLDER": str(folder / "node")}
        subprocess.run([PROGRAM, "bake", self.plans, "--out", folder / "whole", "--quiet", *OPTIONS], check=True,
                       env=self.environment)

    def run(self, *arguments: object, code: int = 0, **variables: str) -> subprocess.CompletedProcess:
        command = [sys.executable, str(SCRIPT), *map(str, arguments)]
        done = subprocess.run(command, env={**self.environment, **variables}, capture_output=True, text=True)
        assert done.returncode == code, done.stdout + done.stderr
        return done

    def bake(self, *arguments: object, to: object = None, options=OPTIONS, **named) -> subprocess.CompletedProcess:
        return self.run("bake", self.plans, "--to", to or self.store, "--units", UNITS, *arguments, "--", *options, **named)

    def prepare(self) -> int:
        done = self.run("prepare", self.plans, "--to", self.store, "--units", UNITS, "--", *OPTIONS)
        return int(done.stdout)

    def assert_is_whole(self) -> None:
        assert contents(self.store) == contents(self.folder / "whole")


def contents(folder: Path) -> dict[str, str]:
    """The hash of every file that is not in a corner of its own."""
    paths = (path for path in folder.rglob("*") if path.is_file())
    named = {path.relative_to(folder).as_posix(): path for path in paths}
    return {name: hashlib.sha256(path.read_bytes()).hexdigest() for name, path in named.items() if name[0] != "."}


@pytest.fixture
def city(tmp_path) -> City:
    return City(tmp_path)


@needs_program
def test_units_in_local_processes_end_with_the_bytes_of_one_bake(city):
    first = city.bake()
    assert f"{UNITS} units baked, 0 kept, 0 failed" in first.stdout
    city.assert_is_whole()
    again = city.bake()
    assert f"0 units baked, {UNITS} kept" in again.stdout
    city.assert_is_whole()
    assert f"{UNITS} of {UNITS} units done" in city.run("status", city.store).stdout


@needs_program
def test_the_number_of_units_follows_from_measured_cost(city):
    done = city.run("bake", city.plans, "--to", city.store, "--", *OPTIONS)
    assert re.search(r"16 rooms on 8 levels at [\d.]+ ms .*: [1-8] units", done.stderr)
    city.assert_is_whole()


@needs_program
def test_a_new_driver_does_what_is_missing(city):
    city.prepare()
    for unit in (2, 4):
        city.run("unit", city.store, unit)
    assert f"2 of {UNITS} units done" in city.run("status", city.store).stdout
    assert "lacks 3 of 5 parts: 1, 3, 5" in city.run("merge", city.store, code=2).stderr
    assert "3 units baked, 2 kept" in city.bake().stdout
    city.assert_is_whole()


@needs_program
def test_a_unit_killed_before_its_record_is_done_again(city):
    city.bake()
    # As a kill between the first file and the record leaves it: one level missing, one cut short, no record, no manifest.
    (city.store / "alpha" / "1.glb").unlink()
    (city.store / "alpha" / "2.glb").write_bytes(b"glTF")
    for unit in (1, 2):
        (city.store / jobs.RECORDS / f"manifest.{unit}-of-{UNITS}.json").unlink()
    (city.store / "manifest.json").unlink()
    assert "2 units baked, 3 kept" in city.bake().stdout
    city.assert_is_whole()


def failing_program(folder: Path, body: str) -> Path:
    """A program that fails where `body` says, and goes on as the true one."""
    path = folder / "program.sh"
    path.write_text(f'#!/bin/sh\n{body}\nexec "{PROGRAM}" "$@"\n', encoding="utf-8")
    path.chmod(0o755)
    return path


@needs_program
def test_a_bake_that_is_killed_is_repeated(city):
    mark = city.folder / "mark"
    killed = failing_program(city.folder, f'case "$*" in *"--shard 3/"*) mkdir "{mark}" 2>/dev/null && kill -9 $$;; esac')
    done = city.bake("--program", killed)
    assert "1 attempts repeated" in done.stdout
    city.assert_is_whole()
    errors = [json.loads(path.read_text()) for path in (city.store / jobs.ERRORS).iterdir()]
    assert [(error["unit"], error["code"]) for error in errors] == [(3, -9)]


@needs_program
def test_a_unit_that_always_fails_stops_no_other_and_leaves_no_manifest(city):
    broken = failing_program(city.folder, 'case "$*" in *"--shard 3/"*) echo "no luck" >&2; exit 2;; esac')
    done = city.bake("--program", broken, code=1)
    assert "4 units baked, 0 kept, 1 failed" in done.stdout and "no luck" in done.stdout
    assert not (city.store / "manifest.json").exists()
    assert "1 failed" not in city.run("status", city.store).stdout


@needs_program
def test_another_job_in_the_same_place_is_refused(city):
    city.bake()
    refused = city.bake(options=[*OPTIONS, "--seed", "2"], code=2)
    assert "the options of bake" in refused.stderr
    plan = city.plans / "alpha.yaml"
    plan.write_text(plan.read_text().replace("height: 3", "height: 3.1"))
    assert "the plans or the configuration" in city.bake(code=2).stderr
    assert "--out" in city.bake(options=["--out", "x"], code=2).stderr
    assert contents(city.store) == contents(city.folder / "whole")


def test_a_store_that_fails_for_a_while_is_asked_again(monkeypatch, tmp_path):
    monkeypatch.setattr("roomwright.distributed.store.FIRST_PAUSE", 0.0)
    answers = iter([OSError("slow down"), OSError("slow down"), b"content"])

    def ask():
        answer = next(answers)
        if isinstance(answer, Exception):
            raise answer
        return answer

    assert repeated(ask) == b"content"

    def refuse():
        raise OSError("slow down")

    with pytest.raises(Failure, match="slow down"):
        repeated(refuse)


class Bucket:
    """A store of objects that says an ETag, in the words of fsspec; it spoils the first files that it is sent."""

    def __init__(self, spoil=lambda content: content, tag=lambda content: hashlib.md5(content).hexdigest()):
        self.files, self.spoiled, self.spoil, self.tag = {}, 0, spoil, tag

    def pipe_file(self, name: str, content: bytes) -> None:
        spoils = name not in self.files
        self.spoiled += spoils
        self.files[name] = self.spoil(content) if spoils else content

    def put_file(self, path: str, name: str) -> None:
        self.pipe_file(name, Path(path).read_bytes())

    def cat_file(self, name: str) -> bytes:
        return self.files[name]

    def info(self, name: str) -> dict:
        if name not in self.files:
            raise FileNotFoundError(name)
        return {"size": len(self.files[name]), "ETag": f'"{self.tag(self.files[name])}"'}

    def invalidate_cache(self) -> None:
        """Nothing is kept."""

    def store(self) -> Objects:
        store = Objects.__new__(Objects)
        store.system, store.root = self, "bucket"
        return store


@pytest.mark.parametrize("spoil", [lambda content: content[:-1] + b"?", lambda content: content[:3]])
def test_a_file_that_arrives_altered_or_cut_short_is_sent_again(monkeypatch, tmp_path, spoil):
    monkeypatch.setattr("roomwright.distributed.store.FIRST_PAUSE", 0.0)
    bucket = Bucket(spoil)
    (tmp_path / "1.glb").write_bytes(b"a level")
    store = bucket.store()
    store.put(tmp_path / "1.glb", "a/1.glb")
    store.write("record.json", b"content")
    assert bucket.spoiled == 2 and bucket.files == {"bucket/a/1.glb": b"a level", "bucket/record.json": b"content"}
    (tmp_path / "1.glb").write_bytes(b"a l3vel")
    assert not store.holds(tmp_path / "1.glb", "a/1.glb") and store.has("a/1.glb")


@pytest.mark.parametrize("tag", [lambda content: "0" * 32, lambda content: "0" * 32 + "-2"])
def test_tags_that_are_no_hash_of_the_content_stop_nothing(tmp_path, tag):
    bucket = Bucket(tag=tag)
    store = bucket.store()
    store.write("record.json", b"content")
    store.write("record.json", b"others")
    assert bucket.files == {"bucket/record.json": b"others"}


@needs_program
def test_a_file_that_the_disk_of_a_machine_damages_reaches_no_store(city):
    mark = city.folder / "mark"
    body = f"""case "$*" in *"--shard 3/"*) if mkdir "{mark}" 2>/dev/null; then
  "{PROGRAM}" "$@"; code=$?
  out=$(echo "$*" | sed 's/.*--out \\([^ ]*\\).*/\\1/')
  for level in "$out"/*/*.glb; do printf '?' | dd of="$level" bs=1 seek=99 conv=notrunc 2>/dev/null; break; done
  exit $code
fi;; esac"""
    done = city.bake("--program", failing_program(city.folder, body))
    assert "1 attempts repeated" in done.stdout
    city.assert_is_whole()
    errors = [json.loads(path.read_text()) for path in (city.store / jobs.ERRORS).iterdir()]
    assert len(errors) == 1 and "is not what the bake recorded" in errors[0]["reason"]


@needs_program
def test_tiles_are_refused_before_any_work(city):
    refused = city.run("bake", city.plans, "--to", city.store, "--", "--format", "tiles", code=2)
    assert "does not go with the format tiles" in refused.stderr and "roomwright tiles OUT" in refused.stderr
    assert not city.store.exists()


def test_only_the_first_of_two_drivers_creates_a_job(tmp_path):
    store = Folder(tmp_path)
    assert store.create("job.json", b"one") == b"one"
    assert store.create("job.json", b"two") == b"one"


def test_the_archive_of_plans_depends_on_their_content_only(tmp_path):
    for name in ("one", "two"):
        (tmp_path / name / "plans").mkdir(parents=True)
        (tmp_path / name / "plans" / "a.yaml").write_text("levels: []")
    os.utime(tmp_path / "one" / "plans" / "a.yaml", (1, 1))
    one, two = (pack([str(tmp_path / name / "plans")], [], [], []) for name in ("one", "two"))
    assert one == two
    with pytest.raises(Failure):
        pack([str(tmp_path / "nowhere")], [], [], [])


def test_units_become_shorter_towards_the_end_and_are_no_more_than_levels():
    seconds = [0.5 + index % 7 for index in range(4000)]
    units = cut(seconds, workers=8, start_seconds=0.1)
    costs = [sum(seconds[unit.start:unit.stop]) for unit in units]
    assert sorted(index for unit in units for index in unit) == list(range(4000))
    assert costs == sorted(costs, reverse=True) and max(costs) < UNIT_SECONDS + 7 and costs[-1] < 8
    # Whoever is idle takes the next unit: nobody waits longer at the end than a short unit takes.
    workers = [0.0] * 8
    for cost in costs:
        workers[workers.index(min(workers))] += cost
    assert max(workers) < 1.02 * sum(seconds) / 8
    assert len(cut([1.0] * 30, workers=100, start_seconds=0.0)) == 30
    assert len(cut([1e4] * 50_000, workers=8, start_seconds=1.0)) <= jobs.MOST_UNITS


def test_plans_that_take_long_to_read_are_read_by_fewer_units():
    units = cut([1.0] * 10_000, workers=4, start_seconds=6.0)
    assert len(units) * 6.0 < 0.05 * 10_000 and len(units) > 4


def test_a_sample_is_a_small_part_of_many_levels_and_comes_from_all_over_them():
    for count, rooms, expected in ((2, 3, 2), (100, 3, 3), (1000, 3, 5), (100_000, 3, 24), (1000, 40, 3), (100_000, 40, 3)):
        sample = sample_of([{"number": number, "rooms": {"bedroom": rooms}} for number in range(count)])
        assert len(sample) == expected and sample[-1]["number"] >= count / 2


def test_one_large_level_is_a_unit_of_its_own_and_the_first():
    units = cut([1.0] * 50 + [40.0] + [1.0] * 50, workers=2, start_seconds=0.01)
    assert units[0].stop == 51 and len(units[0]) <= 51 and all(50 not in unit for unit in units[1:])


def test_a_given_number_of_units_is_met():
    for count in (1, 3, 5, 8):
        units = cut_into([9.0, 1, 1, 1, 1, 1, 1, 9.0], count)
        assert len(units) == count and all(len(unit) for unit in units)
        assert sorted(index for unit in units for index in unit) == list(range(8))
    assert len(cut_into([1.0, 1.0], 5)) == 2


def test_rooms_cost_by_their_type():
    costs = read_costs()
    some = {"building": "a", "level": "1", "rooms": {"kitchen": 2, "of no known type": 1}}
    assert costs.of(some) == pytest.approx(costs.level + 2 * costs.rooms["kitchen"] + costs.room)


@pytest.fixture
def prepared(city) -> City:
    assert city.prepare() == UNITS
    return city


def finish(city: City) -> None:
    city.run("merge", city.store)
    city.assert_is_whole()


@needs_program
def test_the_slurm_script_does_the_unit_of_its_task(prepared):
    for task in range(1, UNITS + 1):
        variables = {"STORE": str(prepared.store), "SCRIPTS": str(ROOT / "scripts"), "SLURM_ARRAY_TASK_ID": str(task),
                     "PYTHON": sys.executable}
        subprocess.run(["bash", TEMPLATES / "slurm.sbatch"], env={**prepared.environment, **variables}, check=True)
    finish(prepared)


def run_shell(city: City, command: list[str], variable: str) -> None:
    """Runs the command of a container once for each index, counted from 0."""
    for index in range(UNITS):
        variables = {"STORE": str(city.store), "SCRIPTS": str(ROOT / "scripts"), variable: str(index)}
        subprocess.run(command, env={**city.environment, **variables}, check=True)


@needs_program
def test_the_kubernetes_job_does_the_unit_of_its_index(prepared):
    yaml = pytest.importorskip("yaml")
    job = yaml.safe_load((TEMPLATES / "kubernetes-job.yaml").read_text())
    assert job["spec"]["completionMode"] == "Indexed" and job["spec"]["template"]["spec"]["restartPolicy"] == "Never"
    container = job["spec"]["template"]["spec"]["containers"][0]
    assert {variable["name"] for variable in container["env"]} == {"STORE", "SCRIPTS"}
    run_shell(prepared, [*container["command"], *container["args"]], "JOB_COMPLETION_INDEX")
    finish(prepared)


@needs_program
def test_the_array_of_aws_batch_does_the_unit_of_its_index(prepared):
    job = json.loads((TEMPLATES / "aws-batch.json").read_text())
    assert 2 <= job["arrayProperties"]["size"] <= jobs.MOST_UNITS
    run_shell(prepared, job["containerOverrides"]["command"], "AWS_BATCH_JOB_ARRAY_INDEX")
    finish(prepared)


@needs_program
def test_the_steps_of_openjd_do_all_units_and_the_merge(prepared):
    yaml = pytest.importorskip("yaml")
    job = yaml.safe_load((TEMPLATES / "openjd.template.yaml").read_text())
    assert job["specificationVersion"] == "jobtemplate-2023-09"
    bake, merge = job["steps"]
    assert merge["dependencies"] == [{"dependsOn": "bake"}]
    values = {"Param.Store": str(prepared.store), "Param.Scripts": str(ROOT / "scripts"), "Param.Units": str(UNITS)}

    def filled(text: str, unit: int = 0) -> str:
        return re.sub(r"\{\{(.*?)\}\}", lambda found: {**values, "Task.Param.Unit": str(unit)}[found[1]], text)

    first, last = filled(bake["parameterSpace"]["taskParameterDefinitions"][0]["range"]).split("-")
    for step, units in ((bake, range(int(first), int(last) + 1)), (merge, [0])):
        action = step["script"]["actions"]["onRun"]
        for unit in units:
            arguments = [filled(argument, unit) for argument in action["args"]]
            subprocess.run([sys.executable, *arguments], env=prepared.environment, check=True)
    prepared.assert_is_whole()


@needs_program
def test_the_commands_of_the_page_work_as_they_are_written(city):
    text = (ROOT / "docs" / "cluster.md").read_text(encoding="utf-8")
    lines = [line.split()[2:] for line in text.splitlines() if line.startswith("    python scripts/cluster.py ")]
    assert {line[0] for line in lines} == {"bake", "status", "prepare", "unit", "merge"}
    # A folder stands for the bucket; Ray has a test of its own.
    places = {"plans/": str(city.plans), "s3://bucket/city": str(city.store), "out": str(city.folder / "out")}
    for line in lines:
        city.run(*(places.get(word, word) for word in line if word not in ("--ray", "--address", "auto")))
    assert (city.folder / "out" / "manifest.json").exists() and (city.store / "manifest.json").exists()


CLUSTER_LACKS = lacks("ray", "moto", "s3fs", "flask")


@needs_program
@pytest.mark.skipif(bool(CLUSTER_LACKS), reason=f"not installed: {', '.join(CLUSTER_LACKS)}")
def test_three_nodes_of_ray_and_a_failing_store_of_objects_end_with_the_bytes_of_one_bake(city):
    proof = Path(__file__).with_name("cluster_proof.py")
    done = subprocess.run([sys.executable, str(proof), str(city.plans), str(city.folder / "whole"), str(UNITS)],
                          env=city.environment, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
