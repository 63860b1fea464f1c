#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write the manual page and the completions of a program: make_manual.py PROGRAM VERSION FOLDER

All text comes from `PROGRAM --help`, and the names that an option accepts come from the error
message of the program for another name. The build runs this program. It writes

  FOLDER/PROGRAM.1   the manual page, also compressed as FOLDER/PROGRAM.1.gz
  FOLDER/PROGRAM     the completion for bash
  FOLDER/_PROGRAM    the completion for zsh
"""

from __future__ import annotations

import dataclasses
import gzip
import pathlib
import re
import subprocess
import sys


@dataclasses.dataclass
class Entry:
    """An option or a key with its description, or a paragraph, which has no term."""

    term: str
    text: str

    @property
    def option(self) -> str:
        return self.term.split(" ")[0] if self.term.startswith("--") else ""

    @property
    def value(self) -> str:
        return self.term.partition(" ")[2]


@dataclasses.dataclass
class Help:
    """The parts of the text of --help."""

    usage: list[str]
    description: str
    sections: dict[str, list[Entry]]
    exit_codes: str

    def find_options(self) -> list[Entry]:
        return [own for entries in self.sections.values() for own in entries if own.option]


def _split_entry(line: str, column: int) -> Entry:
    """Split a line of a section, in which descriptions begin at a column."""
    if line[column - 1 : column] == " " and line[column : column + 1].strip():
        return Entry(line[:column].strip(), line[column:])
    term, _, text = line.strip().partition("  ")
    if text or term.startswith("--"):
        return Entry(term, text.strip())
    return Entry("", term)


def _read_section(lines: list[str]) -> list[Entry]:
    """Return the entries of the lines of a section."""
    indents = [len(line) - len(line.lstrip()) for line in lines]
    column = min((own for own in indents if own > 2), default=0)
    entries: list[Entry] = []
    for line, indent in zip(lines, indents):
        continues = entries and (indent > 2 or not entries[-1].term)
        is_option = re.match(r"  --[a-z-]+( |$)", line)
        if continues and not is_option:
            entries[-1].text = f"{entries[-1].text} {line.strip()}".strip()
        elif is_option:
            entries.append(_split_entry(line, column))
        elif re.search(r"\S  +\S", line):
            term, text = re.split(r"  +", line.strip(), maxsplit=1)
            entries.append(Entry(term, text))
        else:
            entries.append(Entry("", line.strip()))
    return entries


def read_help(text: str) -> Help:
    """Return the parts of the text of --help."""
    blocks = [block.splitlines() for block in text.strip("\n").split("\n\n")]
    usage = [line.removeprefix("Usage: ") for line in blocks[0]]
    result = Help(usage, "", {}, "")
    paragraphs = []
    for block in blocks[1:]:
        if len(block) > 1 and block[0].endswith(":") and block[1].startswith("  "):
            result.sections[block[0][:-1]] = _read_section(block[1:])
        elif block[0].startswith("Exit code"):
            result.exit_codes = " ".join(block).partition(": ")[2]
        else:
            paragraphs.append(" ".join(block))
    result.description = "\n.PP\n".join(_escape(own) for own in paragraphs)
    return result


def find_choices(program: str, entry: Entry) -> list[str]:
    """Return the names that an option accepts, or an empty list."""
    if "|" in entry.value:
        return entry.value.split("|")
    if entry.value != "NAME":
        return []
    run = subprocess.run([program, "file", f"{entry.option}=?"], capture_output=True, text=True)
    found = re.search(rf"{entry.option} needs (.+), not '\?'", run.stderr)
    return re.split(r", | or ", found[1]) if found else []


def _escape(text: str) -> str:
    """Return a text for a line of a manual page."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    text = re.sub(r"`([^`]*)`", r"\\fB\1\\fR", text)
    return "\\&" + text if text[:1] in (".", "'") else text


def _make_summary(text: str) -> str:
    """Return the first sentence without parentheses, for the list of all manual pages."""
    sentence = re.split(r"\.(?: |$)", re.sub(r" \([^)]*\)", "", text))[0]
    return sentence[:1].lower() + sentence[1:]


def _format_term(entry: Entry) -> str:
    if not entry.option:
        return f"\\fB{_escape(entry.term)}\\fR"
    font = "B" if "|" in entry.value else "I"
    value = f" \\f{font}{_escape(entry.value)}\\fR" if entry.value else ""
    return f"\\fB{_escape(entry.option)}\\fR{value}"


def make_manual(name: str, version: str, text: Help) -> str:
    """Return a manual page."""
    lines = [
        f'.TH {name.upper()} 1 "" "Relevo {version}" "User Commands"',
        ".SH NAME",
        f"{_escape(name)} \\- {_make_summary(text.description)}",
        ".SH SYNOPSIS",
    ]
    for usage in text.usage:
        command, _, remark = usage.partition("  ")
        arguments = command.removeprefix(name).strip()
        lines += [f".B {_escape(name)}", _escape(arguments)]
        lines += [f"({_escape(remark.strip())})"] if remark else []
        lines += [".br"]
    lines[-1] = ".SH DESCRIPTION"
    lines += [text.description]
    for title, entries in text.sections.items():
        lines += [f'.SH "{_escape(title.upper())}"']
        for entry in entries:
            lines += [".TP", _format_term(entry)] if entry.term else [".PP"]
            lines += [_escape(entry.text)]
    lines += [".SH EXIT STATUS", _escape(text.exit_codes), ""]
    return "\n".join(lines)


def make_bash_completion(name: str, options: list[Entry], choices: dict[str, list[str]]) -> str:
    """Return a completion for bash. It completes values after a space and after =."""
    all_options = " ".join(dict.fromkeys(own.option for own in options))
    function = "_" + name.replace("-", "_")
    cases = [
        f"    {option}) mapfile -t COMPREPLY < <(compgen -W '{' '.join(names)}' -- \"$current\") ;;"
        for option, names in choices.items()
        if names
    ]
    files = [own.option for own in options if re.match("FILE|FOLDER", own.value)]
    if files:
        cases.append(f"    {' | '.join(files)}) mapfile -t COMPREPLY < <(compgen -f -- \"$current\") ;;")
    others = [own.option for own in options if own.value and not own.value.startswith("[")]
    others = [own for own in others if own not in files and not choices.get(own)]
    if others:
        cases.append(f"    {' | '.join(others)}) ;;")
    return "\n".join(
        [
            f"# Completion of {name} for bash, generated by make_manual.py",
            f"{function}() {{",
            '  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}',
            '  if [ "$current" = = ]; then',
            "    current=",
            '  elif [ "$previous" = = ]; then',
            "    previous=${COMP_WORDS[COMP_CWORD - 2]}",
            "  fi",
            "  COMPREPLY=()",
            "  case $previous in",
            *cases,
            "    *)",
            "      case $current in",
            f"        -*) mapfile -t COMPREPLY < <(compgen -W '{all_options}' -- \"$current\") ;;",
            '        *) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;',
            "      esac",
            "      ;;",
            "  esac",
            "}",
            f"complete -o filenames -F {function} {name}",
            "",
        ]
    )


def make_zsh_completion(name: str, options: list[Entry], choices: dict[str, list[str]]) -> str:
    """Return a completion for zsh."""
    lines = [f"#compdef {name}", "# Generated by make_manual.py", "_arguments \\"]
    for own in {own.option: own for own in reversed(options)}.values():
        help_text = re.split(r"[.;(]", own.text)[0].strip()
        help_text = re.sub(r"([\\:\[\]])", r"\\\1", help_text).replace("'", "'\\''")
        value = ""
        if own.value and not own.value.startswith("["):
            action = f"({' '.join(choices[own.option])})" if choices[own.option] else " "
            if re.match("FILE|FOLDER", own.value):
                action = "_files"
            label = re.sub(r"[:|]", " ", own.value)
            value = f":{label}:{action}"
        lines.append(f"  '{own.option}{'=' if value else ''}[{help_text}]{value}' \\")
    return "\n".join([*lines, "  '*:file:_files'", ""])


def main(program: str, version: str, folder: str) -> None:
    run = subprocess.run([program, "--help"], capture_output=True, text=True, check=True)
    text = read_help(run.stdout)
    options = text.find_options()
    choices: dict[str, list[str]] = {}
    for own in options:  # some options have several entries
        choices[own.option] = choices.get(own.option, []) + find_choices(program, own)
    name = pathlib.Path(program).name
    target = pathlib.Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    manual = make_manual(name, version, text)
    (target / f"{name}.1").write_text(manual)
    (target / f"{name}.1.gz").write_bytes(gzip.compress(manual.encode(), mtime=0))
    (target / name).write_text(make_bash_completion(name, options, choices))
    (target / f"_{name}").write_text(make_zsh_completion(name, options, choices))


if __name__ == "__main__":
    main(*sys.argv[1:])
