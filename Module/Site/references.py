# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Text in Sphinx's reStructuredText."""

from __future__ import annotations

import re
import textwrap


def escape(text: str) -> str:
    """Return a text without markup."""
    return re.sub(r"([\\`*_|<>])", r"\\\1", text)


def literal(text: str) -> str:
    """Return a text as code."""
    return f"``{text}``" if text.strip() else ""


def indent(text: str, columns: int = 3) -> str:
    return textwrap.indent(text, columns * " ")


def title(text: str, mark: str = "=") -> str:
    return f"{text}\n{mark * len(text)}\n"


def directive(name: str, arguments: list[str], contents: str) -> str:
    """Return a directive with one argument per line."""
    head = f".. {name}:: "
    first, *others = arguments
    lines = [head + first, *(len(head) * " " + other for other in others)]
    if not contents.startswith(":"):  # options follow without an empty line
        lines.append("")
    return "\n".join(lines) + "\n" + indent(contents) + "\n"
