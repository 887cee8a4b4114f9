"""Builds the wheel: setuptools, with the extension module built and put in its place by CMake."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

from setuptools.build_meta import *  # noqa: F403  (the hooks that pip calls)
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

project = pathlib.Path(__file__).resolve().parent.parent
version = re.search(r"^project\(subcert VERSION ([0-9.]+)", (project / "CMakeLists.txt").read_text(), re.M)[1]


class BuildByCMake(build_py):
    """Instead of copying modules: installs the component `python`, of the finished build that SUBCERT_BUILD names, or
    of a new one."""

    def run(self) -> None:
        target = pathlib.Path(self.build_lib).resolve()
        finished = os.environ.get("SUBCERT_BUILD")
        if finished:
            install(finished, target)
            return
        with tempfile.TemporaryDirectory() as build:
            switches = {
                "CMAKE_BUILD_TYPE": "Release",
                "Python_EXECUTABLE": sys.executable,
                "SUBCERT_BUILD_TESTS": "OFF",
                "SUBCERT_BUILD_BENCH": "OFF",
                "SUBCERT_BUILD_PYTHON": "ON",
                "SUBCERT_USE_MPI": "OFF",
            }
            given = [f"-D{name}={value}" for name, value in switches.items()]
            subprocess.run(["cmake", "-S", str(project), "-B", build, *given], check=True)
            jobs = str(os.cpu_count() or 1)
            subprocess.run(["cmake", "--build", build, "-j", jobs, "--target", "subcert_python", "atlas"], check=True)
            install(build, target)


def install(build: str, target: pathlib.Path) -> None:
    """Puts modules and libraries of a finished build there."""
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", str(target)], check=True)


class PlatformWheel(bdist_wheel):
    """Not for any machine: it contains compiled code."""

    def finalize_options(self) -> None:
        super().finalize_options()
        self.root_is_pure = False
