# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs of relevo-studio for benchmarks: scripts, the layouts after frames, and processor time."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess
import tempfile
import typing

SIZE = "--size=1280x800"

Layout = typing.Dict[str, typing.Dict[str, typing.Any]]


def run_script(program: str, file: pathlib.Path, lines: list[str]) -> tuple[list[Layout], float]:
    """Return the entries of the layout after each frame, by name, and the processor time in s."""
    with tempfile.TemporaryFile("w+") as output, tempfile.NamedTemporaryFile("w") as script:
        script.write("\n".join(lines) + "\n")
        script.flush()
        environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
        process = subprocess.Popen(
            [program, file, "--surface=linear", SIZE, "--script", script.name, "--layout",
             "/dev/stdout"],
            stdout=output, env=environment,
        )
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            raise RuntimeError(f"{program} ended with {process.returncode}")
        output.seek(0)
        text = output.read()
    decoder = json.JSONDecoder()
    layouts: list[Layout] = []
    place = 0
    while place < len(text):
        entries, place = decoder.raw_decode(text, place)
        layouts.append({entry["name"]: entry for entry in entries})
        while place < len(text) and text[place].isspace():
            place += 1
    return layouts, usage.ru_utime + usage.ru_stime


def figure(layout: Layout, name: str) -> float:
    """Return a figure, or 0 if the scene does not have it."""
    return layout.get(f"figure-{name}", {"value": 0.0})["value"]
