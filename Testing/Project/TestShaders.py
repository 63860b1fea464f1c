# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Validate the shaders that the mappers' tests build with glslangValidator, the reference compiler.

TestShaders.py FOLDER

Mesa writes all programs that the tests link, including VTK's, into FOLDER. This test moves them to
FOLDER-validated. The validator checks each stage separately. It checks shaders of GLSL below 4.0
twice, with and without ARB_gpu_shader5, because it supports `precise` only from 4.0 on.
"""

import collections
import concurrent.futures
import itertools
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile

STAGES = {
    "vertex": "vert",
    "tessellation control": "tesc",
    "tessellation evaluation": "tese",
    "geometry": "geom",
    "fragment": "frag",
    "compute": "comp",
}
SHADERS = 50  # per process
SECONDS = 60
BYTES = 2 * 1024**3


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))


def variants(source):
    version = int(re.search(r"#version (\d+)", source).group(1))
    if version >= 400 or "GL_ARB_gpu_shader5" not in source:
        return {"": source}
    return {
        # VTK's preamble defines this name for older versions only.
        "with ARB_gpu_shader5": re.sub(
            r"#version \d+", "#version 400\n#define texelFetchBuffer texelFetch", source
        ),
        "without ARB_gpu_shader5": source.replace("#ifndef GL_ARB_gpu_shader5", "#if 1"),
    }


def problems(shaders, folder):
    """Return the errors and warnings of the validator for a list of (title, stage, source)."""
    titles = {}
    for title, stage, source in shaders:
        handle, name = tempfile.mkstemp("." + STAGES[stage], dir=folder)
        with open(handle, "w", encoding="utf-8") as file:
            file.write(source)
        titles[name] = title
    result = subprocess.run(
        ["glslangValidator", *titles],
        stdout=subprocess.PIPE,
        text=True,
        timeout=SECONDS,
        preexec_fn=limit,
        check=False,
    )
    # The validator supports the parts of the extension that the shaders use.
    known = "extension is only partially supported: GL_ARB_gpu_shader5"
    found = []
    title = "no shader"
    for line in result.stdout.splitlines():
        if line in titles:
            title = titles[line]
        elif line.startswith(("ERROR:", "WARNING:")) and known not in line:
            found.append(f"{title}: {line}")
    return found if found or result.returncode == 0 else [f"{title}: exit code {result.returncode}"]


def main(arguments):
    if not shutil.which("glslangValidator"):
        print("skipped: glslangValidator is not installed")
        return 125
    programs = os.path.abspath(arguments[0])
    folder = programs + "-validated"
    shutil.rmtree(folder, ignore_errors=True)
    os.rename(programs, folder)
    os.makedirs(programs)
    shaders = collections.OrderedDict()
    files = [entry.name for entry in os.scandir(folder) if entry.is_file()]
    for name in sorted(files):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            parts = re.split(r"^\[(.*) shader\]\n", file.read(), flags=re.M)
        for stage, source in zip(parts[1::2], parts[2::2]):
            shaders.setdefault((stage, source.split("\n[test]")[0]), name)
    counts = collections.Counter()
    jobs = []
    for (stage, source), name in shaders.items():
        owner = "Relevo" if "relevo" in source.lower() else "VTK"
        counts[owner, stage] += 1
        for variant, text in variants(source).items():
            jobs.append((f"{owner}: {name}, {stage} shader {variant}", stage, text))
    # The validator takes most of its time to start, so a process gets many shaders.
    batches = [jobs[i : i + SHADERS] for i in range(0, len(jobs), SHADERS)]
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(problems, batches, itertools.repeat(folder)):
            for problem in found:
                print(problem)
                failed += 1
    for (owner, stage), count in sorted(counts.items()):
        print(f"{owner}: {count} {stage} shaders")
    if not any(owner == "Relevo" for owner, _ in counts):
        print("skipped: only Mesa writes shaders for MESA_SHADER_CAPTURE_PATH")
        return 125
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
