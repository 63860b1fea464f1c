# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs scripts of relevo-studio for tests."""

import json
import os
import pathlib
import subprocess
import sys

from ViewerProgram import ViewerProgram

PROGRAM = pathlib.Path(os.environ["RELEVO_BINARY_DIR"]) / "bin" / "relevo-studio"
if not PROGRAM.exists():
    print("skipped: relevo-studio was not built")
    sys.exit(125)
SIZE = "--size=560x420"


class StudioProgram(ViewerProgram):
    """A folder for files, and runs of both programs in it."""

    def studio(self, file, *lines, code=0):
        """Runs a script. Returns the layouts after all frames, and stderr."""
        (self.folder / "script.txt").write_text("\n".join(lines) + "\n")
        environment = {k: v for k, v in os.environ.items() if k != "DISPLAY"}
        arguments = [PROGRAM, file, SIZE, "--script", "script.txt", "--layout", "/dev/stdout"]
        run = subprocess.run(
            arguments, cwd=self.folder, env=environment, capture_output=True, text=True
        )
        self.assertEqual(run.returncode, code, run.stderr)
        decoder = json.JSONDecoder()
        layouts = []
        text = run.stdout
        while text.strip():
            entries, end = decoder.raw_decode(text)
            layouts.append({entry["name"]: entry for entry in entries})
            text = text[end:].lstrip()
        return layouts, run.stderr

    def assert_picture(self, name, *arguments):
        """The picture is that of relevo-view, to the bit."""
        self.view(*arguments, SIZE, "--output=expected.png")
        self.assertEqual(
            (self.folder / name).read_bytes(), (self.folder / "expected.png").read_bytes(), name
        )
