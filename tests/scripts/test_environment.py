"""Scripts that are started by a Python without their modules."""

import shutil
import subprocess
import sys
import tomllib

import pytest
from conftest import ROOT

from roomwright import environment as environments

TOOLS = ("validate.py", "convert.py", "dxf_to_plan.py")
PICTURES = ("render.py", "gallery.py", "contact_sheet.py")


@pytest.fixture
def project(tmp_path):
    """The scripts in a folder where nothing is set up."""
    for folder in ("scripts", "python"):
        shutil.copytree(ROOT / folder, tmp_path / folder, ignore=shutil.ignore_patterns("node_modules", "__pycache__"))
    return tmp_path


@pytest.fixture
def installed(tmp_path):
    """The package alone, as an installation has it."""
    shutil.copytree(ROOT / "python", tmp_path / "packages", ignore=shutil.ignore_patterns("node_modules", "__pycache__"))
    return tmp_path / "packages"


def run_bare(project, script, *arguments):
    """By this Python without any module but its own."""
    return subprocess.run([sys.executable, "-S", f"scripts/{script}", *arguments], cwd=project, capture_output=True,
                          text=True, timeout=60)


@pytest.mark.parametrize("script", [*TOOLS, *PICTURES])
def test_without_its_environment_a_script_says_which_command_sets_it_up(project, script):
    done = run_bare(project, script, "out")
    assert (done.returncode, done.stdout) == (2, "")
    assert "Traceback" not in done.stderr and f"{script}: this Python, {sys.executable}, has no numpy, " in done.stderr
    if script in TOOLS:
        assert "\n  source scripts/set_up.sh && set_up_python\n  .venv/bin/python scripts/" in done.stderr
    else:
        assert ".venv-render/bin/pip install -r scripts/requirements-render.txt\n" in done.stderr


@pytest.mark.parametrize("script", ["blender_import.py", "blender_export.py"])
def test_blender_s_add_ons_say_it_too(project, script):
    wants = ["out", "--save", "a.blend"] if script == "blender_import.py" else ["a.blend", "--out", "a.glb"]
    done = run_bare(project, script, *wants)
    assert done.returncode == 2 and "Traceback" not in done.stderr
    assert ".venv-render/bin/pip install -r scripts/requirements-render.txt" in done.stderr


@pytest.mark.parametrize("script", [*TOOLS, *PICTURES])
def test_the_manual_needs_no_environment(project, script):
    done = run_bare(project, script, "--help")
    assert done.returncode == 0 and script in done.stdout and done.stderr == ""


def test_a_script_goes_on_in_the_environment_that_is_set_up(project):
    for folder in (".venv", ".venv-render"):
        python = project / folder / "bin" / "python"
        python.parent.mkdir(parents=True)
        python.write_text(f'#!/bin/sh\necho "{folder}: $*"\nexit 7\n')
        python.chmod(0o755)
    done = run_bare(project, "validate.py", "out", "--json")
    assert (done.returncode, done.stdout) == (7, ".venv: scripts/validate.py out --json\n")
    done = run_bare(project, "blender_import.py", "out", "--save", "a.blend")
    assert (done.returncode, done.stdout) == (7, ".venv-render: scripts/blender_import.py out --save a.blend\n")


def test_the_command_that_is_named_is_there():
    assert "\nset_up_python() {" in (ROOT / "scripts" / "set_up.sh").read_text()
    assert (ROOT / "scripts" / "requirements-render.txt").is_file()


@pytest.mark.parametrize("module, extra", [("validate", "validate"), ("convert", "usd"), ("dxf_to_plan", "dxf"), ("blender.import_command", "blender")])
def test_an_installed_package_names_the_extra_that_it_lacks(installed, module, extra):
    done = subprocess.run([sys.executable, "-S", "-m", f"roomwright.{module}", "out"], cwd=installed, capture_output=True, text=True,
                          timeout=60)
    assert (done.returncode, done.stdout) == (2, "")
    assert "Traceback" not in done.stderr and done.stderr.endswith(f'{sys.executable} -m pip install "roomwright[{extra}]"\n')


def test_a_module_goes_on_in_the_environment_that_is_set_up(project):
    python = project / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text('#!/bin/sh\necho "$*"\n')
    python.chmod(0o755)
    done = subprocess.run([sys.executable, "-S", "-m", "roomwright.validate", "out"], cwd=project / "python", capture_output=True,
                          text=True, timeout=60)
    assert done.stdout == "-m roomwright.validate out\n"


@pytest.mark.parametrize("module, environment", [("validate", environments.TOOLS), ("convert", environments.CONVERSION),
                                                 ("dxf_to_plan", environments.DRAWINGS)])
def test_a_command_asks_for_every_module_that_it_imports(module, environment):
    absent = sorted({*environments.TOOLS.modules, "bpy", "ezdxf", "mujoco", "ray", "yaml"} - set(environment.modules))
    code = f"import sys; sys.modules.update(dict.fromkeys({absent})); import roomwright.{module}"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT / "python", capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_what_judges_floors_alone_loads_no_usd():
    code = "import sys, roomwright.validate; print('pxr' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT / "python", capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"


@pytest.mark.parametrize("environment", [environments.TOOLS, environments.CONVERSION, environments.DRAWINGS])
def test_an_extra_installs_every_module_of_its_command(environment):
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    wanted = extras[environment.extra]
    wanted = [*wanted, *(extras["usd"] if "roomwright[usd]" in wanted else [])]
    named = {"pxr": "usd-core", "PIL": "Pillow", "yaml": "PyYAML"}
    missing = [module for module in environment.modules if not any(line.startswith(named.get(module, module) + ">") for line in wanted)]
    assert missing == []
