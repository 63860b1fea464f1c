# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles, without output, what the build does not.

headers: every installed header alone, so that none leans on what others include or on what is not
         installed; and installed are public headers and what authors need, nothing else.
sources: the C++ sources with another compiler, warnings being errors: all but three of four tests,
         which look alike. Those of the modules are compiled without precompiled headers, so that
         they include what they use.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 125
WARNINGS = ["-Wall", "-Wextra", "-Werror", "-fsyntax-only"]


def get_sources(path, build):
    """The file itself, or the sources that a file of a unity build includes."""
    if build in path.parents and path.name.startswith("unity_"):
        return [pathlib.Path(name) for name in re.findall(r'#include "(.*)"', path.read_text())]
    return [path]


def compile_commands(build, source):
    """Flags of each of the project's own sources: path to list of arguments."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        arguments = iter(shlex.split(entry["command"]))
        kept = []
        for argument in arguments:
            if argument == "-isystem":
                kept += [argument, next(arguments)]
            elif argument.startswith(("-D", "-I", "-std", "-f")):
                kept.append(argument)
        for path in get_sources(pathlib.Path(entry["file"]), build):
            if source in path.parents and build not in path.parents:
                flags[path] = kept
    return flags


# Beside the public classes: what metrics, surfaces and methods of one's own need.
AUTHORS_HEADERS = {
    "Points/MergedPoints.h",
    "View/RefinementView.h",
    "Mesh/SurfaceEdges.h",
    "Mesh/SurfaceTriangles.h",
    "Parallel/PieceReduction.h",
    "Metrics/MetricEvaluator.h",
    "Metrics/MetricMesh.h",
    "Metrics/MetricShader.h",
    "Metrics/ViewTime.h",
    "Surfaces/SurfaceBounds.h",
    "Surfaces/SurfaceData.h",
    "Surfaces/SurfaceEvaluation.h",
    "Surfaces/SurfaceFace.h",
    "Surfaces/SurfaceShading.h",
    "Evaluation/PointTags.h",
    "Intersection/ToleranceSurface.h",
    "Geodesy/Georeference.h",
    "Geodesy/TerrainFrame.h",
    "Raster/RasterDescription.h",
}


def installed_headers(folder, flags):
    """Each installed header with flags that find VTK's and the installed ones, and no others."""
    arguments = max(flags.values(), key=len)  # of the source that needs most of VTK
    found = [argument for argument in arguments if not argument.startswith(("-I", "-D"))]
    for header in sorted(folder.rglob("*.h")):
        yield header, ["-I", str(folder), *found]


def is_public(folder, name):
    """Whether an installed header is of a public class, or one that others need."""
    text = (folder / name).read_text(encoding="utf-8")
    return (
        f"TypeMacro({pathlib.PurePath(name).stem}," in text
        or name.startswith("Relevo")
        and name.endswith("Module.h")
        or name in AUTHORS_HEADERS
    )


def get_sources_to_compile(flags):
    """All sources but three of four tests; what tests share is among them."""
    tests = sorted(path for path in flags if re.match(r"Test.*\.cxx", path.name))
    left_out = set(tests) - set(tests[::4])
    return [path for path in flags if path not in left_out]


def precompile(compiler, source, flags, folder):
    """VTK's headers, in which most of the time goes, compiled for tests, examples and benchmark.

    Those sources and the arguments to add to theirs; none where the compiler is not clang. Sources
    with other flags, such as those of a shared library, cannot use the headers.
    """
    if "clang" not in pathlib.Path(compiler).name:
        return {}
    users = {}
    for path in flags:
        if path.relative_to(source).parts[0] in ("Examples", "Testing"):
            language = tuple(flag for flag in flags[path] if flag.startswith(("-f", "-std")))
            users.setdefault(language, []).append(path)
    if not users:
        return {}
    most = max(users.values(), key=len)
    arguments = [flag for flag in flags[most[0]] if not flag.startswith(("-I", "-D"))]
    compiled = str(pathlib.Path(folder) / "headers.pch")
    header = str(source / "Module/CMake/RelevoPrecompiled.h")
    subprocess.run([compiler, *arguments, "-x", "c++-header", header, "-o", compiled], check=True)
    return {path: ["-include-pch", compiled] for path in most}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["headers", "sources"])
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--headers", type=pathlib.Path, help="where they are installed")
    options = parser.parse_args()
    if not shutil.which(options.compiler):
        print("skipped: no", options.compiler)
        return SKIPPED

    flags = compile_commands(options.build, options.source)
    if options.what == "headers":
        jobs = list(installed_headers(options.headers, flags))
    else:
        folder = tempfile.TemporaryDirectory()
        precompiled = precompile(options.compiler, options.source, flags, folder.name)
        jobs = [
            (path, flags[path] + precompiled.get(path, [])) for path in get_sources_to_compile(flags)
        ]
    if not jobs:
        print("nothing to compile: is there a compile_commands.json?")
        return 1

    def run(job):
        path, arguments = job
        command = [options.compiler, *arguments, *WARNINGS, "-x", "c++"]
        if options.what == "headers":
            # Included rather than compiled itself, which would warn of headers as main files.
            return path, subprocess.run(
                [*command, "-"], input=f'#include "{path}"\n', capture_output=True, text=True
            )
        return path, subprocess.run([*command, str(path)], capture_output=True, text=True)

    failures = 0
    if options.what == "headers":
        names = {path.relative_to(options.headers).as_posix() for path, _ in jobs}
        for name in sorted(name for name in names if not is_public(options.headers, name)):
            failures += 1
            print(f"{name}: is installed, and neither public nor for authors")
        for name in sorted(AUTHORS_HEADERS - names):
            failures += 1
            print(f"{name}: is not installed, though authors need it")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, result in pool.map(run, jobs):
            if result.returncode != 0:
                failures += 1
                print(f"{path}:\n{result.stderr}")
    print(f"{len(jobs)} {options.what}, {failures} faults")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
