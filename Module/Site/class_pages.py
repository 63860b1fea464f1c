# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a page for each public class, with its signatures in Python and in C++."""

from __future__ import annotations

import ast
import pathlib
import re
import textwrap
from xml.etree import ElementTree

from references import directive, escape, indent, literal, title

_END = "\0"  # the end of markup, which no letter may follow

# What all classes of VTK have.
_OF_ALL_CLASSES = {"New", "PrintSelf", "IsA", "IsTypeOf", "NewInstance", "SafeDownCast"}


class Stubs:
    """Signatures of methods in Python, from the stubs of a build."""

    def __init__(self, folder: pathlib.Path | None) -> None:
        self._signatures: dict[tuple[str, str], list[str]] = {}
        for stub in sorted(folder.glob("Relevo*.pyi")) if folder else ():
            for node in ast.parse(stub.read_text(encoding="utf-8")).body:
                if isinstance(node, ast.ClassDef):
                    self._add(node)

    def _add(self, node: ast.ClassDef) -> None:
        for method in node.body:
            if isinstance(method, ast.FunctionDef):
                arguments = ast.unparse(method.args)
                arguments = re.sub(r"^self(, /)?(, )?", "", arguments)
                result = f" -> {ast.unparse(method.returns)}" if method.returns else ""
                key = (node.name, method.name)
                self._signatures.setdefault(key, []).append(f"{method.name}({arguments}){result}")

    def find(self, kind: str, method: str) -> list[str]:
        return self._signatures.get((kind, method), [])

    def is_in_cpp_only(self, kind: str, method: str) -> bool:
        """Return whether Python lacks a method, if that is known."""
        return bool(self._signatures) and (kind, method) not in self._signatures


class _Text:
    """Converts descriptions of Doxygen's XML."""

    def __init__(self, classes: dict[str, str]) -> None:
        self._classes = classes  # pages of Doxygen's identifiers

    def convert(self, *elements: ElementTree.Element | None) -> str:
        """Return the paragraphs of descriptions."""
        blocks = [
            block for element in elements if element is not None for block in self._blocks(element)
        ]
        return "\n\n".join(block for block in blocks if block.strip())

    def _blocks(self, element: ElementTree.Element) -> list[str]:
        blocks = []
        line = escape(element.text or "")
        for child in element:
            if child.tag in ("para", "itemizedlist", "orderedlist", "simplesect", "verbatim"):
                blocks.append(self._tidy(line))
                line = ""
                blocks += self._block(child)
            else:
                line += self._inline(child)
            line += escape(child.tail or "")
        return [*blocks, self._tidy(line)]

    def _block(self, element: ElementTree.Element) -> list[str]:
        if element.tag == "verbatim":
            return ["::\n\n" + indent(textwrap.dedent((element.text or "").strip("\n")))]
        if element.tag in ("itemizedlist", "orderedlist"):
            mark = "- " if element.tag == "itemizedlist" else "#. "
            items = []
            for item in element:
                text = indent(self.convert(item), len(mark)).lstrip()
                items.append(mark + text)
            return ["\n".join(items)]
        if element.tag == "simplesect":
            kind = {"see": "See also", "return": "Returns"}.get(element.get("kind", ""), "Note")
            return [f"{kind}: {self.convert(element)}"]
        return self._blocks(element)

    def _inline(self, element: ElementTree.Element) -> str:
        text = "".join(element.itertext())
        if element.tag == "ref":
            page = self._classes.get(element.get("refid", ""))
            return f":doc:`{text} <{page}>`{_END}" if page else escape(text)
        if element.tag == "computeroutput":
            return f"{literal(text)}{_END}"
        if element.tag == "linebreak":
            return "\n"
        return escape(text)

    @staticmethod
    def _tidy(text: str) -> str:
        text = re.sub(r"\s+", " ", text).strip()
        return re.sub(f"{_END}(?=\\w)", "\\\\ ", text).replace(_END, "")


def _get_text(element: ElementTree.Element, path: str) -> str:
    found = element.find(path)
    return "".join(found.itertext()).strip() if found is not None else ""


def _get_signature(member: ElementTree.Element) -> str:
    """Return the declaration in C++."""
    kind = _get_text(member, "type")
    text = f"{kind} {_get_text(member, 'name')}{_get_text(member, 'argsstring')}"
    if member.get("static") == "yes":
        text = f"static {text}"
    text = re.sub(r"\bVTK_\w+ ", "", text)
    text = re.sub(r" ?=0$", " = 0", text)
    return re.sub(r"\s*([*&])\s*", r"\1 ", text).replace("virtual ", "").strip()


def _get_python(member: ElementTree.Element, kind: str, stubs: Stubs) -> list[str]:
    name = _get_text(member, "name")
    names = [
        _get_text(item, "declname") or f"value{i}"
        for i, item in enumerate(member.findall("param"), 1)
    ]
    return stubs.find(kind, name) or [f"{name}({', '.join(names)})"]


def _write_group(
    members: list[ElementTree.Element], kind: str, stubs: Stubs, text: _Text, indexed: set[str]
) -> str:
    """Return the methods that share a description. Each name is indexed once."""
    signatures = list(
        dict.fromkeys(own for member in members for own in _get_python(member, kind, stubs))
    )
    names = {_get_text(member, "name") for member in members}
    options = ":noindex:\n\n" if names & indexed else ""
    indexed |= names
    in_cpp = "\n".join(dict.fromkeys(_get_signature(member) + ";" for member in members))
    first = members[0]
    description = text.convert(first.find("briefdescription"), first.find("detaileddescription"))
    if all(stubs.is_in_cpp_only(kind, name) for name in names):
        description += "\n\nThis method is not available in Python."
    code = f".. code-block:: cpp\n\n{indent(in_cpp)}\n"
    return directive("py:method", signatures, f"{options}{description}\n\n{code}")


def _find_groups(node: ElementTree.Element) -> list[list[ElementTree.Element]]:
    """Return the documented public methods, those with the same description together."""
    groups: list[list[ElementTree.Element]] = []
    previous = ""
    for member in node.findall("sectiondef/memberdef"):
        name = _get_text(member, "name")
        description = "".join(
            _get_text(member, path) for path in ("briefdescription", "detaileddescription")
        )
        is_method = member.get("kind") == "function" and member.get("prot") == "public"
        if not is_method or not description or name in _OF_ALL_CLASSES or "~" in name:
            previous = ""
            continue
        if description == previous:
            groups[-1].append(member)
        else:
            groups.append([member])
        previous = description
    return groups


class ClassPages:
    """The pages of the classes in a folder of Doxygen's XML."""

    def __init__(self, xml: pathlib.Path, stubs: Stubs) -> None:
        self._stubs = stubs
        self._nodes = {}
        for file in sorted(xml.glob("classvtk*.xml")):
            node = ElementTree.parse(file).getroot().find("compounddef")
            if node is not None and node.get("prot", "public") == "public":
                self._nodes[_get_text(node, "compoundname")] = node
        pages = {node.get("id", ""): f"/classes/{name}" for name, node in self._nodes.items()}
        self._text = _Text(pages)

    def write(self, folder: pathlib.Path) -> None:
        """Write the pages, and their index."""
        folder.mkdir()
        modules: dict[str, list[str]] = {}
        for name, node in self._nodes.items():
            location = node.find("location")
            header = location.get("file", "") if location is not None else ""
            (folder / f"{name}.rst").write_text(self._make_page(name, node, header), "utf-8")
            module = "/".join(header.split("/")[:2])
            brief = self._text.convert(node.find("briefdescription")).replace("\n", " ")
            modules.setdefault(module, []).append(f":doc:`{name}`\n   {brief}\n")
        lists = "\n".join(
            title(module, "-") + "\n" + "\n".join(rows) for module, rows in sorted(modules.items())
        )
        (folder / "index.rst").write_text(
            f"{title('Classes')}\nThe public classes of C++, by their modules. Python has the same"
            f" classes in the package ``relevo``, with the same methods.\n\n{lists}",
            "utf-8",
        )

    def _make_page(self, name: str, node: ElementTree.Element, header: str) -> str:
        bases = [_get_text(base, ".") for base in node.findall("basecompoundref")]
        derived = [item.text for item in node.findall("derivedcompoundref")]
        description = self._text.convert(
            node.find("briefdescription"), node.find("detaileddescription")
        )
        links = [f":doc:`{own} <{own}>`" if own in self._nodes else literal(own) for own in bases]
        facts = [f"Header: {literal(header)}."]
        if links:
            facts.append(f"Base class: {', '.join(links)}.")
        known = [f":doc:`{own} <{own}>`" for own in derived if own in self._nodes]
        if known:
            facts.append(f"Derived classes: {', '.join(known)}.")
        facts.append(f"`All members in C++ <../cxx/class{name}.html>`__.")
        indexed: set[str] = set()
        methods = "\n".join(
            _write_group(group, name, self._stubs, self._text, indexed)
            for group in _find_groups(node)
        )
        body = f"{description}\n\n{' '.join(facts)}\n\n{methods}"
        # The list of contents has no classes, only their index.
        head = f":orphan:\n\n{title(name)}\n.. py:currentmodule:: relevo\n\n"
        return head + directive("py:class", [name], body)
