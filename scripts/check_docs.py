#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what can be known about the documentation without running it:

    scripts/check_docs.py VERSION [ROOT]

- relative links and pictures of every Markdown page lead to something that exists, and `#name` to a
  heading;
- every page below docs/ can be reached from docs/README.md;
- fenced blocks have a language that docs/contributing.md lists;
- the newest version in CHANGELOG.md is VERSION, the project's.

Prints one line a fault, `page:line: what is wrong`; exit code 1 when there is any.
"""

import pathlib
import re
import sys
import urllib.parse
from typing import Iterator

sys.dont_write_bytecode = True
import markdown  # noqa: E402

RUN_LANGUAGES = {"sh", "python", "c", "cpp"}
READ_LANGUAGES = {"console", "json", "text"}


def check_link(page: pathlib.Path, link: markdown.Link) -> str:
    """What is wrong with the link, or nothing."""
    if re.match(r"[a-z]+:", link.target):
        return ""
    path, _, anchor = urllib.parse.unquote(link.target).partition("#")
    target = page.parent / path if path else page
    if not target.exists():
        return f"{link.target} does not exist"
    if anchor and target.suffix == ".md" and anchor not in markdown.anchors(target):
        return f"{link.target}: no heading of that name"
    return ""


def check_links(root: pathlib.Path) -> Iterator[str]:
    for page in markdown.pages(root):
        for link in markdown.links(page):
            fault = check_link(page, link)
            if fault:
                yield f"{page.relative_to(root)}:{link.line}: {fault}"


def check_reachable(root: pathlib.Path) -> Iterator[str]:
    """Follows the links from docs/README.md: a page nobody can find is no documentation."""
    start = (root / "docs/README.md").resolve()
    seen, waiting = {start}, [start]
    while waiting:
        page = waiting.pop()
        for link in markdown.links(page):
            target = (page.parent / link.target.partition("#")[0]).resolve()
            if target.suffix == ".md" and target.exists() and target not in seen:
                seen.add(target)
                waiting.append(target)
    for page in sorted((root / "docs").rglob("*.md")):
        if page.resolve() not in seen:
            yield f"{page.relative_to(root)}:1: no page reachable from docs/README.md links here"


def check_languages(root: pathlib.Path) -> Iterator[str]:
    for page in markdown.pages(root):
        for block in markdown.fenced_blocks(page):
            if block.language not in RUN_LANGUAGES | READ_LANGUAGES:
                yield (f"{page.relative_to(root)}:{block.line}: fence '{block.language}' is not one"
                       f" of {' '.join(sorted(RUN_LANGUAGES | READ_LANGUAGES))}"
                       " (docs/contributing.md)")


def check_changelog(root: pathlib.Path, version: str) -> Iterator[str]:
    text = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    newest = re.search(r"^## (\d+\.\d+\.\d+)", text, flags=re.M)
    if newest is None:
        yield "CHANGELOG.md:1: no heading '## MAJOR.MINOR.PATCH'"
    elif newest[1] != version:
        line = text[:newest.start()].count("\n") + 1
        yield (f"CHANGELOG.md:{line}: newest version is {newest[1]},"
               f" the project's (CMakeLists.txt) is {version}")


def find_faults(root: pathlib.Path, version: str):
    return [*check_links(root), *check_reachable(root), *check_languages(root),
            *check_changelog(root, version)]


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    root = pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else __file__).resolve()
    root = root if root.is_dir() else root.parents[1]
    faults = find_faults(root, sys.argv[1])
    print("\n".join(faults + [f"{len(markdown.pages(root))} pages read, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
