# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Check the Markdown pages: links, pictures, quoted code, messages, and the length of README.md.

TestPages.py SOURCE          check the pages of the project
TestPages.py FOLDER --links  check only links, pictures and quoted code of an installed copy
"""

import pathlib
import re
import subprocess
import sys

MOST_WORDS = 900  # in README.md
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
    """Return the text without code blocks and code spans."""
    lines = []
    fenced = False
    for line in text.splitlines():
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            lines.append(re.sub(r"`[^`]*`", "", line))
    return "\n".join(lines)


def get_anchors(page):
    """Return GitHub's anchors: lower case, hyphens for spaces, no punctuation."""
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
    """Return the targets of links and pictures, including pictures within links."""
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
    """Check that each block of C++ or CMake quotes the file that the line before it links to."""
    text = page.read_text()
    for match in re.finditer(r"\]\(([^)\s]+)\):\n\n```(?:cpp|cmake)\n(.*?)```", text, re.S):
        quoted = (page.parent / match[1]).read_text()
        if match[2] not in quoted:
            report(page.relative_to(source), f"{match[1]} does not contain the quoted code")
    for language in re.findall(r"^```(\w+)$", text, re.M):
        if language not in ("cmake", "cpp", "mermaid", "python"):
            report(page.relative_to(source), f"no test checks code blocks of {language}")
    blocks = len(re.findall(r"^```(?:cpp|cmake)$", text, re.M))
    quotes = len(re.findall(r"\]\([^)\s]+\):\n\n```(?:cpp|cmake)\n", text))
    if blocks != quotes:
        report(page.relative_to(source), "a block of C++ or CMake follows no link to its file")


def check_files(source, page):
    """Check that each source that the page names exists in some folder."""
    folders = ("Examples", "Filters", "Module", "Rendering", "Testing")
    names = {path.name for folder in folders for path in (source / folder).rglob("*")}
    for name in set(re.findall(r"\b\w+\.(?:cxx|glsl|h)\b", page.read_text())):
        if name not in names:
            report(page.relative_to(source), f"names {name}, which does not exist")


def check_options(source, page):
    """Check that the page and relevo-view --help list the same options."""
    options = r"(?<![\w-])--[a-z][a-z-]+"
    usage = (source / "Examples/Viewer/Options/ViewerUsage.cxx").read_text()
    told = set(re.findall(rf"^  ({options})", usage, re.M))
    shown = set(re.findall(rf"^\| `({options})", page.read_text(), re.M))
    for option in told ^ shown:
        where = "not in relevo-view --help" if option in shown else "not in the tables"
        report(page.relative_to(source), f"{option} is {where}")


def get_strings(source):
    """Return the string literals of the sources, with adjacent literals joined."""
    literal = r'"(?:[^"\\\n]|\\.)*"'
    texts = []
    for folder in ("Filters", "Rendering", "Module/FileChecks", "Module/ParaView", "Examples/Viewer"):
        for path in sorted((source / folder).rglob("*")):
            if path.suffix in (".h", ".cxx"):
                for match in re.finditer(rf"{literal}(?:\s*{literal})*", path.read_text()):
                    parts = re.findall(literal, match[0])
                    texts.append("".join(part[1:-1] for part in parts).replace('\\"', '"'))
    return "\n".join(texts)


def check_messages(source, page):
    """Check that the longest part of each message in the tables is in a string of the sources."""
    strings = get_strings(source)
    count = 0
    for row in re.findall(r"^\| (`.*?`) \|", page.read_text(), re.M):
        for message in re.findall(r"`([^`]*)`", row):
            parts = re.split(r"\.\.\.|(?<![A-Za-z])(?:[A-Z]|[A-Z]{4,})(?![A-Za-z])|\s\d\s|\"", message)
            longest = max((part.strip(" .:'") for part in parts), key=len)
            count += 1
            if len(longest) < 8 or longest not in strings:
                report(page.relative_to(source), f"no string in the sources contains {longest!r}")
    if count < 60:
        report(page.relative_to(source), f"has only {count} messages")


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
        report("README.md", f"has {words} words, more than {MOST_WORDS}")
    tutorials = documentation / "tutorials.md"
    for page in documentation.glob("*.md"):
        if page.name.startswith("tutorial-"):
            if page.name not in get_links(tutorials.read_text()):
                report("tutorials.md", f"has no link to {page.name}")
        elif f"Module/Documentation/{page.name}" not in get_links(readme):
            report("README.md", f"has no link to {page.name}")
    pictures = [path for path in documentation.iterdir() if path.suffix in (".gif", ".jpg", ".png")]
    for picture in pictures:
        if not any(picture.name in page.read_text() for page in pages):
            report(picture.relative_to(source), "no page shows it")

    finish(f"{len(pages)} pages, README.md of {words} words")


main()
