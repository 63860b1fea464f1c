# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments of the scripts beside this file."""

import sys


def read_arguments():
    """The script's arguments, without the `--` that may stand before names with a hyphen."""
    return sys.argv[2:] if sys.argv[1:2] == ["--"] else sys.argv[1:]


def check_file(name):
    """The name of a file that can be read. Otherwise the script ends with one line."""
    try:
        with open(name, "rb"):
            return name
    except OSError as error:
        sys.exit(f"cannot read {name!r}: {error.strerror}")
