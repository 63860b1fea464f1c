# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Check the links of a site: check_site.py FOLDER

Links, pictures, styles and scripts must exist, with their anchors, and pages must need nothing from
the network. The pages of Doxygen in cxx/ are only checked as targets.
"""

from __future__ import annotations

import html.parser
import os
import pathlib
import sys
import urllib.parse

_LOADED = {"img": "src", "script": "src", "link": "href", "iframe": "src", "source": "src"}


class Page(html.parser.HTMLParser):
    """The anchors and links of a page."""

    def __init__(self, path: pathlib.Path) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        attributes = {name: value for name, value in attrs if value}
        self.anchors |= {attributes[name] for name in ("id", "name") if name in attributes}
        if tag == "a" and "href" in attributes:
            self.links.append(attributes["href"])
        elif tag in _LOADED and _LOADED[tag] in attributes:
            self.loaded.append(attributes[_LOADED[tag]])


def check(folder: pathlib.Path) -> list[str]:
    """Return the faults of the pages in a folder."""
    files = {path for path in folder.rglob("*") if path.is_file()}
    pages = {
        path: Page(path)
        for path in sorted(files)
        if path.suffix == ".html" and folder / "cxx" not in path.parents
    }
    faults = []
    for path, page in pages.items():
        for link in (*page.links, *page.loaded):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loaded and parts.scheme != "data":
                    faults.append(f"{path.relative_to(folder)}: loads {link}")
                continue
            name = urllib.parse.unquote(parts.path)
            target = pathlib.Path(os.path.normpath(path.parent / name)) if name else path
            anchor = urllib.parse.unquote(parts.fragment)
            if target not in files:
                faults.append(f"{path.relative_to(folder)}: {link} does not exist")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                faults.append(f"{path.relative_to(folder)}: {link}: no such anchor")
    if not pages:
        faults.append(f"{folder} has no pages")
    return faults


def main() -> int:
    faults = check(pathlib.Path(sys.argv[1]).resolve())
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
