# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Build wheels of Relevo: the backend that pyproject.toml names, without dependencies.

The wheel contains an installation by CMake: the package, and libraries and programs as data, which
pip puts into lib/ and bin/ of the environment. Their relative paths are those of the installation,
so they find each other.

Settings of pip (--config-settings=NAME=VALUE):

  build-dir   a folder that Module/build.sh has built, which is installed as it is (default: build
              in build/wheel)
  cmake-args  arguments for CMake, separated by spaces

The environment variable RELEVO_VTK_SDK is a version of vtk-sdk. With it, the wheel is for PyPI's vtk
of this version, and contains the libraries in the package.

`relevo_build.py FOLDER` writes the metadata into a folder of packages. CMake calls it.
"""

from __future__ import annotations

import base64
import hashlib
import importlib.util
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile
from typing import Any

_SOURCE = pathlib.Path(__file__).resolve().parents[3]
_COMPONENTS = ("runtime", "programs", "python")


def _get_sdk() -> str:
    return os.environ.get("RELEVO_VTK_SDK", "")


def _read_project() -> dict[str, Any]:
    with open(_SOURCE / "pyproject.toml", "rb") as file:
        project: dict[str, Any] = tomllib.load(file)["project"]
    text = (_SOURCE / "CMakeLists.txt").read_text()
    found = re.search(r"^project\(Relevo\s+VERSION ([0-9.]+)", text, re.MULTILINE)
    assert found
    project["version"] = found[1]
    return project


def _make_metadata(project: dict[str, Any]) -> dict[str, str]:
    """Return names and contents of the files in the .dist-info folder."""
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {project['version']}",
        f"Summary: {project['description']}",
        f"License: {project['license']}",
        f"Requires-Python: {project['requires-python']}",
        *(f"Classifier: {own}" for own in project["classifiers"]),
        *([f"Requires-Dist: vtk=={_get_sdk()}", "Requires-Dist: numpy"] if _get_sdk() else []),
        "Description-Content-Type: text/markdown",
        "",
        (_SOURCE / project["readme"]).read_text(),
    ]
    entries = []
    for group, points in project["entry-points"].items():
        entries += [f"[{group}]", *(f"{name} = {value}" for name, value in points.items()), ""]
    return {"METADATA": "\n".join(lines), "entry_points.txt": "\n".join(entries)}


def _get_folder(project: dict[str, Any]) -> str:
    return f"{project['name']}-{project['version']}.dist-info"


def write_metadata(folder: str) -> None:
    """Write the .dist-info folder beside the package, so that Python finds its entry points."""
    project = _read_project()
    target = pathlib.Path(folder, _get_folder(project))
    target.mkdir(parents=True, exist_ok=True)
    for name, text in _make_metadata(project).items():
        (target / name).write_text(text)


def _make_sdk_arguments() -> list[str]:
    """Return arguments for CMake that use vtk-sdk.

    All files are in the package, because auditwheel adds libraries there. They find those of VTK in
    the package vtkmodules beside it.
    """
    found = importlib.util.find_spec("vtk_sdk")
    assert found and found.origin, "vtk-sdk is not installed"
    content = pathlib.Path(found.origin).parent / "content"
    return [
        f"-DCMAKE_PREFIX_PATH={content}",
        "-DRELEVO_PYTHON_DESTINATION=.",
        "-DCMAKE_INSTALL_LIBDIR=relevo",
        "-DCMAKE_INSTALL_BINDIR=relevo/bin",
        "-DRELEVO_VTK_FOLDER=vtkmodules",
    ]


def _make_environment() -> dict[str, str]:
    """Return the environment without the folders in which pip hides the system's packages."""
    environment = dict(os.environ)
    if not _get_sdk():
        folders = environment.pop("PYTHONPATH", "").split(os.pathsep)
        folders = [own for own in folders if own and "pip-build-env-" not in own]
        if folders:
            environment["PYTHONPATH"] = os.pathsep.join(folders)
    return environment


def _compile(folder: str, arguments: str) -> None:
    """Configure and build in a folder. A later call builds only what has changed."""
    python = getattr(sys, "_base_executable", sys.executable)
    environment = _make_environment()
    check = [python, "-c", "import vtkmodules"]
    found = subprocess.run(check, env=environment, capture_output=True)
    if found.returncode and not _get_sdk():
        sys.exit(
            f"relevo: error: {python} has no vtkmodules. Use the Python that VTK was built for, on"
            " Debian /usr/bin/python3 with the package python3-vtk9."
        )
    command = ["cmake", "-S", str(_SOURCE), "-B", folder, "-DRELEVO_WRAP_PYTHON=ON"]
    command.append(f"-DPython3_EXECUTABLE={python}")
    if not pathlib.Path(folder, "CMakeCache.txt").exists() and shutil.which("ninja"):
        command += ["-G", "Ninja"]
    if _get_sdk():
        command += _make_sdk_arguments()
    if shutil.which("ccache"):
        command += ["-DCMAKE_C_COMPILER_LAUNCHER=ccache", "-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
    subprocess.run([*command, *shlex.split(arguments)], env=environment, check=True)
    command = ["cmake", "--build", folder, "--parallel", str(os.cpu_count() or 1)]
    subprocess.run(command, env=environment, check=True)


def _install(settings: dict[str, str], prefix: str) -> None:
    """Install into a prefix, after building if necessary."""
    folder = settings.get("build-dir", "")
    if not folder:
        folder = str(_SOURCE / "build" / "wheel")
        _compile(folder, settings.get("cmake-args", ""))
    for component in _COMPONENTS:
        command = ["cmake", "--install", folder, "--prefix", prefix, "--component", component]
        subprocess.run([*command, "--strip"], check=True, stdout=subprocess.DEVNULL)


def _find_packages(prefix: pathlib.Path) -> pathlib.Path:
    """Return the folder that contains the package."""
    return next(prefix.rglob("relevo/py.typed")).parent.parent


def _find_files(prefix: pathlib.Path) -> list[pathlib.Path]:
    """Return the files of an installation.

    Wheels have no symbolic links. Of a library only the link is returned, because its name is that
    which the loader looks for.
    """
    files = [own for own in prefix.rglob("*") if own.is_file()]
    targets = {own.resolve() for own in files if own.is_symlink()}
    return sorted(own for own in files if own.is_symlink() or own.resolve() not in targets)


class _Wheel:
    """A wheel that is being written."""

    def __init__(self, path: pathlib.Path) -> None:
        self._archive = zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED)
        self._records: list[str] = []

    def add(self, name: str, contents: bytes, mode: int = 0o644) -> None:
        information = zipfile.ZipInfo(name)
        information.external_attr = (0o100000 | mode) << 16
        information.compress_type = zipfile.ZIP_DEFLATED
        self._archive.writestr(information, contents)
        digest = base64.urlsafe_b64encode(hashlib.sha256(contents).digest()).rstrip(b"=").decode()
        self._records.append(f"{name},sha256={digest},{len(contents)}")

    def close(self, record: str) -> None:
        self._records.append(f"{record},,")
        self._archive.writestr(record, "\n".join([*self._records, ""]))
        self._archive.close()


def get_requires_for_build_wheel(config_settings: dict[str, str] | None = None) -> list[str]:
    """Return the packages that a build needs, see PEP 517."""
    return [f"vtk-sdk=={_get_sdk()}", "cmake", "ninja"] if _get_sdk() else []


def _make_wheel_text(project: dict[str, Any]) -> tuple[str, str]:
    """Return the name of the wheel and the text of the file WHEEL."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[.-]", "_", sysconfig.get_platform())
    tag = f"{python}-{python}-{platform}"
    text = f"Wheel-Version: 1.0\nGenerator: relevo_build\nRoot-Is-Purelib: false\nTag: {tag}\n"
    return f"{project['name']}-{project['version']}-{tag}.whl", text


def prepare_metadata_for_build_wheel(
    metadata_directory: str, config_settings: dict[str, str] | None = None
) -> str:
    """Write the .dist-info folder of the wheel and return its name, see PEP 517."""
    project = _read_project()
    write_metadata(metadata_directory)
    folder = _get_folder(project)
    pathlib.Path(metadata_directory, folder, "WHEEL").write_text(_make_wheel_text(project)[1])
    return folder


def build_wheel(
    wheel_directory: str,
    config_settings: dict[str, str] | None = None,
    metadata_directory: str | None = None,
) -> str:
    """Build a wheel and return its name, see PEP 517."""
    project = _read_project()
    base = f"{project['name']}-{project['version']}"
    information = _get_folder(project)
    name, text = _make_wheel_text(project)
    wheel = _Wheel(pathlib.Path(wheel_directory, name))
    with tempfile.TemporaryDirectory() as folder:
        _install(config_settings or {}, folder)
        prefix = pathlib.Path(folder)
        packages = _find_packages(prefix)
        for path in _find_files(prefix):
            if path.is_relative_to(packages):
                inside = path.relative_to(packages).as_posix()
                if inside.startswith(information):
                    continue
            else:
                inside = f"{base}.data/data/{path.relative_to(prefix).as_posix()}"
            wheel.add(inside, path.read_bytes(), path.stat().st_mode & 0o777)
    for file, contents in _make_metadata(project).items():
        wheel.add(f"{information}/{file}", contents.encode())
    wheel.add(f"{information}/LICENSE", (_SOURCE / "LICENSE").read_bytes())
    wheel.add(f"{information}/WHEEL", text.encode())
    wheel.close(f"{information}/RECORD")
    return name


if __name__ == "__main__":
    write_metadata(*sys.argv[1:])
