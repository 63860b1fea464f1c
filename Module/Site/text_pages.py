# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Copies the Markdown pages of the sources, with links that fit the site."""

from __future__ import annotations

import os
import pathlib
import re
import shutil

_PICTURES = (".gif", ".jpg", ".png")
_TARGET = re.compile(r"(?<=\]\()([^)\s]+)(?=\))")
_CODE = re.compile(r"^```(?s:.*?)^```$|`[^`\n]*`|^    .*$", re.M)
_FLOWCHART = re.compile(r"^```mermaid\n(?s:.*?)^```$", re.M)

# The pages outside of Module/Documentation.
_OTHERS = {
    "README.md": "index",
    "CHANGELOG.md": "changes",
    "CONTRIBUTING.md": "contributing",
    "Data/README.md": "data",
}

# The parts of the list of contents. Pages without a part make Sphinx report a warning.
_CONTENTS = {
    "Start": ("guide", "python", "viewer", "studio", "paraview", "coming-from", "data"),
    "Tutorials": ("tutorials",),
    "Gallery": ("gallery",),
    "Topics": (
        "surfaces",
        "terrain",
        "flow",
        "volumes",
        "patches",
        "remote",
        "reliefs",
        "intersections",
        "dense-meshes",
        "methods",
        "figures",
        "errors",
        "limits",
    ),
    "Reference": ("functions", "classes/index"),
    "Development": ("changes", "contributing", "testing", "packaging", "architecture"),
}


class LinkError(Exception):
    """A link to a missing file."""


class TextPages:
    """The pages of a source folder, for a folder of Sphinx."""

    def __init__(self, source: pathlib.Path, folder: pathlib.Path) -> None:
        self._source = source
        self._folder = folder
        self._names = {source / path: name for path, name in _OTHERS.items()}
        for page in sorted((source / "Module/Documentation").glob("*.md")):
            self._names[page] = page.stem

    def write(self) -> None:
        """Write all pages. Raises LinkError."""
        for page, name in self._names.items():
            text = self._convert(page, page.read_text(encoding="utf-8"))
            if name == "index":
                text += self._make_contents()
            elif name == "tutorials":
                text += self._make_list("", sorted(self._find_tutorials()))
            (self._folder / f"{name}.md").write_text(text, "utf-8")

    def _find_tutorials(self) -> list[str]:
        return [name for name in self._names.values() if name.startswith("tutorial-")]

    def _make_contents(self) -> str:
        return "".join(self._make_list(part, pages) for part, pages in _CONTENTS.items())

    @staticmethod
    def _make_list(caption: str, pages: object) -> str:
        head = f":caption: {caption}\n" if caption else ""
        assert isinstance(pages, (list, tuple))
        return "\n```{toctree}\n:hidden:\n" + head + "\n" + "\n".join(pages) + "\n```\n"

    def _convert(self, page: pathlib.Path, text: str) -> str:
        # The site has no program that draws flow charts, so it shows their text.
        text = _FLOWCHART.sub(lambda match: match[0].replace("```mermaid", "```text", 1), text)
        parts = []
        end = 0
        for code in _CODE.finditer(text):
            parts += [self._convert_links(page, text[end : code.start()]), code[0]]
            end = code.end()
        parts.append(self._convert_links(page, text[end:]))
        return "".join(parts)

    def _convert_links(self, page: pathlib.Path, text: str) -> str:
        return _TARGET.sub(lambda match: self._convert_link(page, match[0]), text)

    def _convert_link(self, page: pathlib.Path, link: str) -> str:
        if re.match(r"[a-z]+:|#", link):
            return link
        path, _, anchor = link.partition("#")
        target = pathlib.Path(os.path.normpath(page.parent / path))
        anchor = f"#{anchor}" if anchor else ""
        if target in self._names:
            return f"{self._names[target]}.md{anchor}"
        if target == self._source / "Module/Documentation":
            return "index.md"
        if not target.is_file():
            raise LinkError(f"{page.relative_to(self._source)}: {link} is not a file")
        own = target.relative_to(self._source)
        copy = self._folder / ("pictures" if target.suffix in _PICTURES else "files") / own
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(target, copy)
        return str(copy.relative_to(self._folder))
