# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compiles, without output, what the build does not.

headers: every public header alone, so that none leans on what others include.
sources: every C++ source with another compiler, warnings being errors.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys

SKIPPED = 125
WARNINGS = ["-Wall", "-Wextra", "-Werror", "-fsyntax-only"]


def compile_commands(build, source):
    """Flags of each of the project's own sources: path to list of arguments."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        if source not in path.parents or build in path.parents:
            continue
        arguments = iter(shlex.split(entry["command"]))
        kept = []
        for argument in arguments:
            if argument == "-isystem":
                kept += [argument, next(arguments)]
            elif argument.startswith(("-D", "-I", "-std", "-f")):
                kept.append(argument)
        flags[path] = kept
    return flags


def public_headers(flags):
    """Headers that `install` would copy, with the flags of a source in the same folder."""
    for folder, arguments in {path.parent: value for path, value in flags.items()}.items():
        lists = folder / "CMakeLists.txt"
        text = lists.read_text() if lists.exists() else ""
        if "vtk_module_add_module" not in text:
            continue
        private = text.partition("private_classes")[2].partition(")")[0].split()
        for header in sorted(folder.glob("*.h")):
            if header.stem not in private and header.stem in text:
                yield header, arguments


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("what", choices=["headers", "sources"])
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", required=True)
    options = parser.parse_args()
    if not shutil.which(options.compiler):
        print("skipped: no", options.compiler)
        return SKIPPED

    flags = compile_commands(options.build, options.source)
    if options.what == "headers":
        jobs = list(public_headers(flags))
    else:
        jobs = list(flags.items())
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
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, result in pool.map(run, jobs):
            if result.returncode != 0:
                failures += 1
                print(f"{path.relative_to(options.source)}:\n{result.stderr}")
    print(f"{len(jobs) - failures} of {len(jobs)} {options.what} compile")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
