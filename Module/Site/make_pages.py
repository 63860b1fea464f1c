# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write the input of Sphinx: make_pages.py SOURCE FOLDER XML [STUBS]

SOURCE is the folder with README.md, and XML has Doxygen's output. STUBS is the Python package of a
build, whose stubs have the types of arguments. Without it, the signatures in Python have names only.
"""

from __future__ import annotations

import pathlib
import shutil
import sys

from class_pages import ClassPages, Stubs
from function_pages import FunctionPages
from text_pages import LinkError, TextPages


def main() -> str | None:
    source, folder, xml, *stubs = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    try:
        TextPages(source, folder).write()
    except LinkError as error:
        return str(error)
    FunctionPages(source / "Module/Python/relevo").write(folder / "functions.rst")
    ClassPages(xml, Stubs(stubs[0] if stubs else None)).write(folder / "classes")
    static = folder / "_static"
    static.mkdir()
    for name, target in (("conf.py", folder), ("site.css", static)):
        shutil.copy(pathlib.Path(__file__).parent / name, target)
    return None


if __name__ == "__main__":
    sys.exit(main())
