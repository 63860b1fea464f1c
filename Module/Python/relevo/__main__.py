# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""`python3 -m relevo` is the program relevo-view. --report prints the environment, for bug reports."""

from __future__ import annotations

import os
import pathlib
import shutil
import sys


def find_program() -> str | None:
    """Return the path of relevo-view: that of the same installation, or the first in PATH."""
    for folder in pathlib.Path(__file__).resolve().parents:
        program = folder / "bin" / "relevo-view"
        if os.access(program, os.X_OK):
            return str(program)
    return shutil.which("relevo-view")


if __name__ == "__main__":
    if sys.argv[1:] == ["--report"]:
        from relevo._report import make_report

        print(make_report())
        sys.exit()
    found = find_program()
    if not found:
        sys.exit("python3 -m relevo: relevo-view is not installed")
    os.execv(found, [found, *sys.argv[1:]])
