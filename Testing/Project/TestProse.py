# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Check the prose of pages with proselint and against the glossary of CONTRIBUTING.md.

    TestProse.py SOURCE_OR_PAGE...

Code is left out. Exit code 125 means that proselint is not installed.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 125

# Checks of proselint that do not apply. Pages are plain ASCII, names of the API are American while
# the text is British, and "decimate" is a term for meshes.
ALLOWED = re.compile(r"typography\.|consistency\.spelling|skunked_terms")

# Wording that readers have misunderstood, and what to write instead.
PHRASES = {
    r"\bfor want of\b": "because there is no ...",
    r"\bbut for\b": "except",
    r"\bis to be\b": "must be",
    r"\bare to be\b": "must be",
    r"\bstands? for no data\b": "means no data",
    r"\bof one's own\b": "of your own",
    r"\b(is|are) up to the user\b": "you can choose ...",
    r"(?<!there )\bis no (number|mesh|raster|image|file|surface|name|value)\b": "is not a ...",
    r"\bis (told|said) to be\b": "is reported as ...",
    r"\bnothing pops\b": "levels change smoothly",
    r"\bwhat is (seen|there|no|drawn|refined)\b": "name the thing",
    r"\bas far as .{1,40} (does|goes|do|go)\b": "say the condition",
}


def get_prose(text):
    """Return the text without code and link targets, with the same line breaks."""

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))

    text = re.sub(r"^```.*?^```", blank, text, flags=re.MULTILINE | re.DOTALL)
    text = re.sub(r"(?:^    .*\n)+", blank, text, flags=re.MULTILINE)
    text = re.sub(r"<!--.*?-->", blank, text, flags=re.DOTALL)
    text = re.sub(r"\]\([^)]*\)", blank, text)
    return re.sub(r"`[^`\n]*`", lambda match: "x" * len(match.group(0)), text)


def find_pages(path):
    if path.is_file():
        return [path]
    return sorted(path.glob("*.md")) + sorted(path.glob("*/*.md")) + sorted(
        path.glob("Module/Documentation/*.md")
    )


def lint(path, prose):
    """Yield what proselint and the list of phrases find, with line and column."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "page.md"
        copy.write_text(prose, encoding="utf-8")
        output = subprocess.run(
            ["proselint", str(copy)], capture_output=True, text=True, check=False
        ).stdout
    for line, column, check, message in re.findall(
        r"^.*?page\.md:(\d+):(\d+): (\S+) (.*)$", output, re.MULTILINE
    ):
        if not ALLOWED.match(check):
            yield f"{path}:{line}:{column}: {message} ({check})"
    for phrase, instead in PHRASES.items():
        for match in re.finditer(phrase, prose, re.IGNORECASE):
            line = prose.count("\n", 0, match.start()) + 1
            yield f"{path}:{line}: '{match.group(0)}': write '{instead}'"


def main():
    if not shutil.which("proselint"):
        print("skipped: proselint is not installed")
        return SKIPPED
    # The linter must find what is wrong; otherwise this test could not fail.
    sample = "This is very very good but for this.\n"
    if len(list(lint("sample", sample))) < 2:
        print("proselint or its output is not as expected")
        return 1
    faults = []
    pages = [page for name in sys.argv[1:] for page in find_pages(pathlib.Path(name))]
    for page in pages:
        prose = get_prose(page.read_text(encoding="utf-8"))
        if page.name == "CONTRIBUTING.md":
            prose = re.sub(r"^\|.*$", "", prose, flags=re.MULTILINE)  # the glossary quotes them
        faults += lint(page, prose)
    print("\n".join(faults))
    print(f"{len(pages)} pages, {len(faults)} faults")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
