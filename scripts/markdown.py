# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a Markdown page that the documentation tests look at."""

import pathlib
import re
from typing import Iterator, List, NamedTuple, Set

FENCE = re.compile(r"(?P<indent> *)(?P<marks>`{3,}|~{3,})\s*(?P<language>[\w+-]*)\s*$")
LINK = re.compile(r"\]\(\s*<?(?P<inline>[^)\s>]+)>?[^)]*\)|^\s*\[[^\]]+\]:\s+(?P<reference>\S+)")
HEADING = re.compile(r"#{1,6}\s+(?P<text>.*?)\s*#*$")


class Block(NamedTuple):
    """A fenced block: the line of its opening fence (1-based), its language and its text."""

    path: pathlib.Path
    line: int
    language: str
    text: str


class Link(NamedTuple):
    line: int
    target: str


def pages(root: pathlib.Path) -> List[pathlib.Path]:
    """Every Markdown page of the project, build folders left out."""
    return sorted(page for page in root.rglob("*.md")
                  if not {"build", "out", ".git"} & set(page.relative_to(root).parts))


def split_page(path: pathlib.Path):
    """(fenced blocks, [(line number, text)] of everything else). A fence that is never closed runs
    to the end of the page, as it does for a reader."""
    blocks, prose = [], []
    opening, opening_line, body = None, 0, []
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, line in enumerate(lines, 1):
        fence = FENCE.match(line)
        if opening is None and fence:
            opening, opening_line, body = fence, number, []
        elif opening is None:
            prose.append((number, line))
        elif fence and not fence["language"] and fence["marks"].startswith(opening["marks"]):
            blocks.append(Block(path, opening_line, opening["language"], "\n".join(body) + "\n"))
            opening = None
        else:
            body.append(line[len(opening["indent"]):])
    if opening is not None:
        blocks.append(Block(path, opening_line, opening["language"], "\n".join(body) + "\n"))
    return blocks, prose


def fenced_blocks(path: pathlib.Path) -> List[Block]:
    return split_page(path)[0]


def links(path: pathlib.Path) -> Iterator[Link]:
    """Targets of links and pictures outside code."""
    for number, line in split_page(path)[1]:
        for match in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            yield Link(number, match["inline"] or match["reference"])


def anchors(path: pathlib.Path) -> Set[str]:
    """The names a `#name` link may use: headings as GitHub spells them."""
    names = set()
    for _, line in split_page(path)[1]:
        heading = HEADING.match(line)
        if heading:
            text = re.sub(r"[^\w\- ]", "", heading["text"].lower()).replace(" ", "-")
            names.add(text if text not in names else f"{text}-1")
    return names
