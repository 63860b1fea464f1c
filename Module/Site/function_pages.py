# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the page of Python's functions and their results, from the sources of the package."""

from __future__ import annotations

import ast
import pathlib
import re

from references import directive, escape, indent, title

_PARAMETER = re.compile(r"(\w+(?:, \w+)*): ")


def _mark_up(text: str) -> str:
    """Return a text of a docstring, with code between backticks."""
    parts = re.split(r"`([^`]*)`", text)
    return "".join(f"``{part}``" if i % 2 else escape(part) for i, part in enumerate(parts))


def convert(docstring: str) -> str:
    """Return a docstring in which lines `name: description` are parameters."""
    blocks = []
    for paragraph in docstring.split("\n\n"):
        if not _PARAMETER.match(paragraph):
            blocks.append(_mark_up(paragraph))
            continue
        items: list[str] = []
        for line in paragraph.splitlines():
            if _PARAMETER.match(line):
                items.append(line)
            else:
                items[-1] += " " + line.strip()
        rows = []
        for item in items:
            name, _, text = item.partition(": ")
            rows.append(f"``{name}``\n{indent(_mark_up(text))}")
        blocks.append("\n\n".join(rows))
    return "\n\n".join(blocks)


def _get_signature(node: ast.FunctionDef, is_method: bool) -> str:
    arguments = ast.unparse(node.args)
    if is_method:
        arguments = re.sub(r"^self(, )?", "", arguments)
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    return f"{node.name}({arguments}){result}"


def _find_functions(nodes: list[ast.stmt]) -> list[ast.FunctionDef]:
    """Return functions with a name that does not start with _, and a docstring."""
    return [
        node
        for node in nodes
        if isinstance(node, ast.FunctionDef)
        and not node.name.startswith("_")
        and ast.get_docstring(node)
    ]


def _is_property(node: ast.FunctionDef) -> bool:
    return any(ast.unparse(item) == "property" for item in node.decorator_list)


class FunctionPages:
    """The page of the package in a folder of sources."""

    def __init__(self, package: pathlib.Path) -> None:
        self._package = package

    def _parse(self, name: str) -> ast.Module:
        return ast.parse((self._package / f"{name}.py").read_text(encoding="utf-8"))

    def _describe_module(self, name: str) -> str:
        return "\n".join(
            directive(
                "py:function",
                [_get_signature(node, False)],
                convert(ast.get_docstring(node) or ""),
            )
            for node in _find_functions(self._parse(name).body)
        )

    def _describe_class(self, module: str, name: str) -> str:
        for node in self._parse(module).body:
            if isinstance(node, ast.ClassDef) and node.name == name:
                parts = [convert(ast.get_docstring(node) or "")]
                for own in _find_functions(node.body):
                    kind = "py:property" if _is_property(own) else "py:method"
                    signature = own.name if _is_property(own) else _get_signature(own, True)
                    parts.append(
                        directive(kind, [signature], convert(ast.get_docstring(own) or ""))
                    )
                return directive("py:class", [name], "\n\n".join(parts))
        raise LookupError(f"{module}.py has no class {name}")

    def write(self, path: pathlib.Path) -> None:
        sections = [
            title("Functions in Python"),
            ".. py:module:: relevo\n",
            "The :doc:`wrapped classes <classes/index>` are in the package ``relevo``, too.\n",
            title("Drawing", "-"),
            self._describe_module("_functions"),
            title("Results", "-"),
            self._describe_class("_drawing", "Drawing"),
            self._describe_class("_terrain", "Terrain"),
            self._describe_class("_intersection", "Intersection"),
            self._describe_class("_error", "Error"),
            title("Arrays", "-"),
            ".. py:module:: relevo.arrays\n",
            self._describe_module("arrays"),
            title("Files", "-"),
            ".. py:module:: relevo.files\n",
            self._describe_module("files"),
        ]
        path.write_text("\n".join(sections), "utf-8")
