"""The wheel and the source distribution, and the version."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path
from typing import List, Set

import pytest
from conftest import ROOT

import gtaharvest

SOURCE = ROOT / "python/src"

IMPORT_ALL = """
import importlib, pkgutil, gtaharvest
names = [module.name for module in pkgutil.walk_packages(gtaharvest.__path__, "gtaharvest.") if module.name != "gtaharvest.__main__"]
for name in ("gtaharvest", *names):
    try:
        importlib.import_module(name)
    except ModuleNotFoundError as missing:
        # The only module that needs an optional package.
        if (name, missing.name) != ("gtaharvest.torch_dataset", "torch"):
            raise
print(gtaharvest.__file__, *names)
"""


def run(*command: object) -> str:
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def source_files() -> Set[str]:
    return {
        path.relative_to(SOURCE).as_posix()
        for path in (SOURCE / "gtaharvest").rglob("*")
        if path.suffix in (".py", ".typed")
    }


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    pytest.importorskip("build")
    folder = tmp_path_factory.mktemp("built")
    run(ROOT / "python/build-wheel", folder)
    return folder


def imported(environment: Path) -> List[str]:
    """Imports every module in an environment; the names of the modules. None may come from the source tree."""
    file, *names = run(environment / "bin/python", "-I", "-c", IMPORT_ALL).split()
    assert Path(file).is_relative_to(environment)
    return names


def test_version_is_that_of_the_project() -> None:
    properties = (ROOT / "build/Version.props").read_text(encoding="utf-8")
    assert re.findall("<Version>(.*)</Version>", properties) == [gtaharvest.__version__]


def test_wheel_has_every_file_of_the_source(built: Path) -> None:
    (wheel,) = built.glob("*.whl")
    packed = {name for name in zipfile.ZipFile(wheel).namelist() if ".dist-info/" not in name}
    assert packed == source_files() and "gtaharvest/gym/env.py" in packed


def test_source_distribution_has_every_file_of_the_source(built: Path) -> None:
    (archive,) = built.glob("*.tar.gz")
    marker = "/src/"
    with tarfile.open(archive) as packed:
        names = {member.name.split(marker, 1)[1] for member in packed if member.isfile() and marker in member.name}
    assert {name for name in names if ".egg-info/" not in name} == source_files()


def test_every_module_of_the_installed_wheel_can_be_imported(built: Path, tmp_path: Path) -> None:
    pytest.importorskip("pip")
    (wheel,) = built.glob("*.whl")
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", tmp_path / "environment")
    site = next((tmp_path / "environment/lib").glob("python*/site-packages"))
    run(sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--target", site, wheel)
    names = imported(tmp_path / "environment")
    assert {name.replace(".", "/") for name in names} == {
        re.sub(r"(/__init__)?\.py$", "", name)
        for name in source_files() - {"gtaharvest/__init__.py", "gtaharvest/__main__.py"}
        if name.endswith(".py")
    }


def test_copied_folder_can_be_installed(tmp_path: Path) -> None:
    pytest.importorskip("pip")
    shutil.copytree(
        ROOT / "python", tmp_path / "copied", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info", "build")
    )
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", tmp_path / "environment")
    site = next((tmp_path / "environment/lib").glob("python*/site-packages"))
    run(
        sys.executable,
        "-m",
        "pip",
        "install",
        "--quiet",
        "--no-index",
        "--no-deps",
        "--no-build-isolation",
        "--target",
        site,
        tmp_path / "copied",
    )
    assert "gtaharvest.gym.env" in imported(tmp_path / "environment")
