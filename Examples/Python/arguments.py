# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Read the command line of the scripts in this folder."""

from __future__ import annotations

import sys


def read_arguments() -> list[str]:
    """Return the arguments, without a leading `--`, which allows names that begin with a hyphen."""
    return sys.argv[2:] if sys.argv[1:2] == ["--"] else sys.argv[1:]


def check_file(name: str) -> str:
    """Return the name if the file can be read. Otherwise exit with a message."""
    try:
        with open(name, "rb"):
            return name
    except OSError as error:
        sys.exit(f"cannot read {name!r}: {error.strerror}")
