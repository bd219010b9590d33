"""The build backend of pyproject.toml: CMake builds the compiled module and the program, setuptools packs them.

A wheel is packed in a folder of its own: the tree is not written to but for build/python, where CMake builds, and
where that cannot be written CMake builds in a temporary folder. `--config-settings=build-dir=PATH` takes a folder that
CMake has configured before, as ./run python does. There is no source distribution and no editable installation: a
wheel is made from the tree.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

import setuptools
from setuptools import build_meta

_tree = Path(__file__).resolve().parent.parent


def _configure(build: Path) -> None:
    options = [
        "-D", "CMAKE_BUILD_TYPE=Release",
        "-D", "CMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG",
        "-D", "CMAKE_UNITY_BUILD=ON",
        "-D", "LIBRATION_BUILD_TESTS=OFF",
        "-D", "LIBRATION_BUILD_PYTHON=ON",
        "-D", f"Python3_EXECUTABLE={sys.executable}",
    ]  # fmt: skip
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    subprocess.run(["cmake", "-S", str(_tree), "-B", str(build), *generator, *options], check=True)


def _build_folder(stack: Path) -> Path:
    build = _tree / "build" / "python"
    try:
        build.mkdir(parents=True, exist_ok=True)
        (build / "writable").touch()
    except OSError:
        build = stack / "cmake"
        build.mkdir()
    return build


def _compiled(settings: dict | None, stack: Path, package: Path) -> None:
    given = (settings or {}).get("build-dir")
    build = Path(given) if given else _build_folder(stack)
    if not given:
        _configure(build)
    subprocess.run(["cmake", "--build", str(build), "--target", "libration-wheel", "--parallel"], check=True)
    for component, prefix in (("python", package), ("command", package / "program")):
        install = ["cmake", "--install", str(build), "--component", component, "--prefix", str(prefix), "--strip"]
        subprocess.run(install, check=True, stdout=subprocess.DEVNULL)


@contextmanager
def _staged():
    """A folder with what setuptools reads, as the working folder."""
    before = os.getcwd()
    has_ext_modules = setuptools.Distribution.has_ext_modules
    with tempfile.TemporaryDirectory(prefix="libration-wheel-") as folder:
        stack = Path(folder)
        shutil.copy(_tree / "pyproject.toml", stack)
        ignored = shutil.ignore_patterns("__pycache__", "tests", "build_with_cmake.py", "bundle_libraries.py")
        shutil.copytree(_tree / "python", stack / "python", ignore=ignored)
        shutil.copy(_tree / "check" / "libration_check.py", stack / "python" / "libration")
        try:
            os.chdir(stack)
            # Modules that CMake compiled make the wheel one of this platform too.
            setuptools.Distribution.has_ext_modules = lambda _: True
            yield stack
        finally:
            setuptools.Distribution.has_ext_modules = has_ext_modules
            os.chdir(before)


def get_requires_for_build_wheel(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    with _staged():
        return build_meta.prepare_metadata_for_build_wheel(metadata_directory)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with _staged() as stack:
        _compiled(config_settings, stack, stack / "python" / "libration")
        return build_meta.build_wheel(wheel_directory)


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("there is no source distribution: make a wheel from the tree")
