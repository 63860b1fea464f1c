# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compile headers and sources as the build does not, without output files.

headers: compile each installed header alone, so that it includes what it uses from installed files.
         Also check that only public headers and those for authors are installed.
sources: compile the C++ sources with another compiler and -Werror, but only every fourth test,
         because tests are similar. Folders that another test compiles with this compiler are left
         out. With --alone, every fourth source of the modules is nevertheless compiled, without
         precompiled headers, so that it includes what it uses.
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
    """Return the file, or the sources that a file of a unity build includes."""
    if build in path.parents and path.name.startswith("unity_"):
        return [pathlib.Path(name) for name in re.findall(r'#include "(.*)"', path.read_text())]
    return [path]


def compile_commands(build, source):
    """Map each source of the project to its list of compiler flags."""
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


# Installed besides the public classes, for authors of metrics, surfaces and methods.
AUTHORS_HEADERS = {
    "Points/MergedPoints.h",
    "View/RefinementView.h",
    "Mesh/SurfaceEdges.h",
    "Mesh/SurfaceTriangles.h",
    "Parallel/PieceReduction.h",
    "Metrics/DisplacedFaces.h",
    "Metrics/FaceErrorEvaluator.h",
    "Metrics/MeasuredPatterns.h",
    "Surfaces/SurfaceFieldShading.h",
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
    """Yield each installed header with flags that find only VTK and the installed headers."""
    arguments = max(flags.values(), key=len)  # the source that needs most of VTK has the most flags
    found = [argument for argument in arguments if not argument.startswith(("-I", "-D"))]
    for header in sorted(folder.rglob("*.h")):
        yield header, ["-I", str(folder), *found]


def is_public(folder, name):
    """Return whether an installed header belongs to a public class, to a module or to authors."""
    text = (folder / name).read_text(encoding="utf-8")
    return (
        f"TypeMacro({pathlib.PurePath(name).stem}," in text
        or name.startswith("Relevo")
        and name.endswith("Module.h")
        or name in AUTHORS_HEADERS
    )


def get_sources_without_precompiled_headers(source, flags):
    """Return every fourth source of the modules."""
    modules = sorted(p for p in flags if p.relative_to(source).parts[0] in ("Filters", "Rendering"))
    return set(modules[::4])


def get_sources_to_compile(source, flags, compiled_elsewhere, alone):
    """Return the set `alone` and all sources that no other test compiles, but only every fourth test.
    """
    tests = sorted(path for path in flags if re.match(r"Test.*\.cxx", path.name))
    left_out = set(tests) - set(tests[::4])
    folders = {source / folder for folder in compiled_elsewhere}
    left_out |= {path for path in flags if folders & set(path.parents)}
    left_out -= alone
    return [path for path in flags if path not in left_out]


def precompile(compiler, source, flags, alone, folder):
    """Precompile VTK's headers, which take most of the time, once for each set of language flags.

    Return the arguments to add for each source that can use them and is not in the set `alone`, if
    the compiler is clang.
    """
    if "clang" not in pathlib.Path(compiler).name:
        return {}
    users = {}
    for path in flags:
        if path not in alone:
            language = tuple(flag for flag in flags[path] if flag.startswith(("-f", "-std")))
            users.setdefault(language, []).append(path)
    header = str(source / "Module/CMake/RelevoPrecompiled.h")
    result = {}
    for number, paths in enumerate(users.values()):
        compiled = str(pathlib.Path(folder) / f"headers{number}.pch")
        first = max((flags[path] for path in paths), key=len)  # finds most of VTK
        arguments = [flag for flag in first if not flag.startswith(("-I", "-D"))]
        subprocess.run(
            [compiler, *arguments, "-x", "c++-header", header, "-o", compiled], check=True
        )
        result.update({path: ["-include-pch", compiled] for path in paths})
    return result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["headers", "sources"])
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--headers", type=pathlib.Path, help="the folder of installed headers")
    parser.add_argument("--alone", action="store_true")
    parser.add_argument("--compiled-elsewhere", nargs="+", default=[], metavar="FOLDER")
    options = parser.parse_args()
    if not shutil.which(options.compiler):
        print("skipped:", options.compiler, "is not installed")
        return SKIPPED

    flags = compile_commands(options.build, options.source)
    if options.what == "headers":
        jobs = list(installed_headers(options.headers, flags))
    else:
        folder = tempfile.TemporaryDirectory()
        alone = set()
        if options.alone:
            alone = get_sources_without_precompiled_headers(options.source, flags)
        precompiled = precompile(options.compiler, options.source, flags, alone, folder.name)
        sources = get_sources_to_compile(options.source, flags, options.compiled_elsewhere, alone)
        jobs = [(path, flags[path] + precompiled.get(path, [])) for path in sources]
    if not jobs:
        print("nothing to compile: check compile_commands.json and the installed headers")
        return 1

    def run(job):
        path, arguments = job
        command = [options.compiler, *arguments, *WARNINGS, "-x", "c++"]
        if options.what == "headers":
            # Compiling a header as the main file would cause warnings, so include it.
            return path, subprocess.run(
                [*command, "-"], input=f'#include "{path}"\n', capture_output=True, text=True
            )
        return path, subprocess.run([*command, str(path)], capture_output=True, text=True)

    failures = 0
    if options.what == "headers":
        names = {path.relative_to(options.headers).as_posix() for path, _ in jobs}
        for name in sorted(name for name in names if not is_public(options.headers, name)):
            failures += 1
            print(f"{name}: is installed, but is neither public nor in AUTHORS_HEADERS")
        for name in sorted(AUTHORS_HEADERS - names):
            failures += 1
            print(f"{name}: is in AUTHORS_HEADERS, but not installed")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, result in pool.map(run, jobs):
            if result.returncode != 0:
                failures += 1
                print(f"{path}:\n{result.stderr}")
    print(f"{len(jobs)} {options.what}, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
