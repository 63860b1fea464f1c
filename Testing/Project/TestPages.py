# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Markdown pages: links and pictures exist, README.md is short, quoted code and messages are true.

TestPages.py SOURCE          of the project
TestPages.py FOLDER --links  of an installed copy: links, pictures and quoted code alone
"""

import pathlib
import re
import subprocess
import sys

MOST_WORDS = 900  # of README.md
LARGEST_PICTURE = 600000  # bytes

problems = []


def report(page, text):
    problems.append(f"{page}: {text}")


def find_pages(source):
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
        cwd=source,
        capture_output=True,
        text=True,
    )
    names = [name for name in listed.stdout.splitlines() if (source / name).is_file()]
    if "README.md" in names:
        return [source / name for name in names]
    folders = ("", "Data", "Module/Documentation")
    return sorted(page for folder in folders for page in (source / folder).glob("*.md"))


def without_code(text):
    """The text without fenced and indented blocks and without code spans, line by line."""
    lines = []
    fenced = False
    for line in text.splitlines():
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            lines.append(re.sub(r"`[^`]*`", "", line))
    return "\n".join(lines)


def get_anchors(page):
    """As GitHub makes them: lower case, spaces become hyphens, punctuation goes."""
    anchors = set()
    fenced = False
    for line in page.read_text().splitlines():
        fenced = fenced != line.startswith("```")
        heading = re.match(r"#+ +(.*)", line)
        if heading and not fenced:
            words = re.sub(r"[^\w\- ]", "", heading[1].strip().lower())
            anchors.add(words.replace(" ", "-"))
    return anchors


def get_links(text):
    """Targets of [text](target) and ![text](target), also of pictures within links."""
    return [match[1].replace("\n", "") for match in re.finditer(r"\]\(([^)\s]+)\)", text)]


def check_links(source, page):
    name = page.relative_to(source)
    for link in get_links(without_code(page.read_text())):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists():
            report(name, f"{link} does not exist")
        elif source not in (target, *target.parents):
            report(name, f"{link} is outside the project")
        elif anchor and anchor not in get_anchors(target):
            report(name, f"{link}: no heading has this anchor")
        elif target.suffix in (".png", ".jpg", ".gif") and target.stat().st_size > LARGEST_PICTURE:
            report(name, f"{link} is larger than {LARGEST_PICTURE} bytes")


def check_quotes(source, page):
    """Each block of C++ or CMake is in the file that the line before it links to."""
    text = page.read_text()
    for match in re.finditer(r"\]\(([^)\s]+)\):\n\n```(?:cpp|cmake)\n(.*?)```", text, re.S):
        quoted = (page.parent / match[1]).read_text()
        if match[2] not in quoted:
            report(page.relative_to(source), f"the code quoted from {match[1]} is not there")
    for language in re.findall(r"^```(\w+)$", text, re.M):
        if language not in ("cmake", "cpp", "mermaid", "python"):
            report(page.relative_to(source), f"no test reads blocks of {language}")
    blocks = len(re.findall(r"^```(?:cpp|cmake)$", text, re.M))
    quotes = len(re.findall(r"\]\([^)\s]+\):\n\n```(?:cpp|cmake)\n", text))
    if blocks != quotes:
        report(page.relative_to(source), "C++ or CMake without a link to the file it is from")


def check_files(source, page):
    """Each source that a page names is there, in whatever folder."""
    folders = ("Examples", "Filters", "Module", "Rendering", "Testing")
    names = {path.name for folder in folders for path in (source / folder).rglob("*")}
    for name in set(re.findall(r"\b\w+\.(?:cxx|glsl|h)\b", page.read_text())):
        if name not in names:
            report(page.relative_to(source), f"there is no file {name}")


def check_options(source, page):
    """The page has the options that relevo-view --help has."""
    options = r"(?<![\w-])--[a-z][a-z-]+"
    usage = (source / "Examples/Viewer/Options/ViewerUsage.cxx").read_text()
    told = set(re.findall(rf"^  ({options})", usage, re.M))
    shown = set(re.findall(rf"^\| `({options})", page.read_text(), re.M))
    for option in told ^ shown:
        where = "not in relevo-view --help" if option in shown else "not in the tables"
        report(page.relative_to(source), f"{option} is {where}")


def get_strings(source):
    """What the sources' string literals say; literals that follow one another are one."""
    literal = r'"(?:[^"\\\n]|\\.)*"'
    texts = []
    for folder in ("Filters", "Rendering", "Module/ParaView", "Examples/Viewer"):
        for path in sorted((source / folder).rglob("*")):
            if path.suffix in (".h", ".cxx"):
                for match in re.finditer(rf"{literal}(?:\s*{literal})*", path.read_text()):
                    parts = re.findall(literal, match[0])
                    texts.append("".join(part[1:-1] for part in parts).replace('\\"', '"'))
    return "\n".join(texts)


def check_messages(source, page):
    """Of each message in a table of errors.md, its longest part is in a string of the sources."""
    strings = get_strings(source)
    count = 0
    for row in re.findall(r"^\| (`.*?`) \|", page.read_text(), re.M):
        for message in re.findall(r"`([^`]*)`", row):
            parts = re.split(r"\.\.\.|(?<![A-Za-z])(?:[A-Z]|[A-Z]{4,})(?![A-Za-z])|\s\d\s|\"", message)
            longest = max((part.strip(" .:'") for part in parts), key=len)
            count += 1
            if len(longest) < 8 or longest not in strings:
                report(page.relative_to(source), f"no source says {longest!r}")
    if count < 60:
        report(page.relative_to(source), f"only {count} messages")


def finish(summary):
    print("\n".join(problems) or summary)
    sys.exit(bool(problems))


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    pages = find_pages(source)
    documentation = source / "Module/Documentation"
    for page in pages:
        check_links(source, page)
        check_quotes(source, page)
    if sys.argv[2:] == ["--links"]:
        finish(f"{len(pages)} pages")

    check_options(source, documentation / "viewer.md")
    check_files(source, documentation / "architecture.md")
    check_messages(source, documentation / "errors.md")

    readme = (source / "README.md").read_text()
    words = len(readme.split())
    if words > MOST_WORDS:
        report("README.md", f"{words} words, more than {MOST_WORDS}")
    for page in documentation.glob("*.md"):
        if f"Module/Documentation/{page.name}" not in get_links(readme):
            report("README.md", f"no link to {page.name}")
    for picture in (*documentation.glob("*.png"), *documentation.glob("*.jpg")):
        if not any(picture.name in page.read_text() for page in pages):
            report(picture.relative_to(source), "no page shows it")

    finish(f"{len(pages)} pages, README.md of {words} words")


main()
