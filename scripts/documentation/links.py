"""Links and headings of Markdown pages, as GitHub and mdBook read them."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

FENCE = re.compile(r"^( *)(`{3,}|~{3,})")
# A link or an image: its text, which may hold images, its target and perhaps a title.
LINK = re.compile(r"(!?)\[((?:[^\[\]]|!?\[[^\[\]]*\](?:\([^()]*\))?)*)\]"
                  r"\(\s*<?([^()\s<>]*(?:\([^()\s]*\)[^()\s<>]*)*)>?(?:\s+\"[^\"]*\")?\s*\)")
CODE = re.compile(r"(`+)(?!`).*?(?<!`)\1(?!`)", re.DOTALL)
HEADING = re.compile(r"^(#{1,6})\s+(.+?)\s*#*$")
EXTERNAL = re.compile(r"^[A-Za-z][A-Za-z0-9+.-]*:")


@dataclass(frozen=True)
class Link:
    """A link of a page; `start` and `end` are where its target stands in the text."""

    target: str
    line: int
    is_image: bool
    start: int
    end: int

    @property
    def is_external(self) -> bool:
        return EXTERNAL.match(self.target) is not None

    @property
    def path(self) -> str:
        return self.target.partition("#")[0]

    @property
    def anchor(self) -> str:
        return self.target.partition("#")[2]


def blank(text: str) -> str:
    """Text of the same length and lines without a letter."""
    return re.sub(r"[^\n]", " ", text)


def without_code(text: str) -> str:
    """A page with blanks in place of its code, so that places in it stay the same."""
    lines = text.split("\n")
    fence = ""
    was_blank = True
    for index, line in enumerate(lines):
        found = FENCE.match(line)
        if fence:
            closes = found is not None and found[2].startswith(fence) and not line.strip().strip(fence[0])
            lines[index] = blank(line)
            fence = "" if closes else fence
        elif found is not None:
            fence = found[2]
            lines[index] = blank(line)
        elif line.startswith("    ") and was_blank:
            # An indented block goes on as long as its lines are indented.
            lines[index] = blank(line)
            continue
        was_blank = not line.strip()
    return CODE.sub(lambda found: blank(found[0]), "\n".join(lines))


def links_of(text: str) -> list[Link]:
    """All links and images, those in texts of links among them."""
    plain = without_code(text)
    found = []
    for match in LINK.finditer(plain):
        found.append(Link(match[3], plain.count("\n", 0, match.start()) + 1, match[1] == "!", match.start(3), match.end(3)))
        inner = match.start(2)
        for image in LINK.finditer(match[2]):
            start = inner + image.start(3)
            found.append(Link(image[3], plain.count("\n", 0, start) + 1, image[1] == "!", start, inner + image.end(3)))
    return found


def anchors_of(text: str) -> set[str]:
    """The anchors of a page's headings: lower case, without signs, numbered where they stand several times."""
    counts: Counter[str] = Counter()
    anchors = set()
    in_code = without_code(text).split("\n")
    for plain, line in zip(in_code, text.split("\n")):
        heading = HEADING.match(line) if plain.startswith("#") else None
        if heading is None:
            continue
        words = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading[2]).replace("`", "").lower()
        anchor = "".join(letter if letter.isalnum() or letter in "_-" else "-" if letter == " " else "" for letter in words)
        anchors.add(anchor if not counts[anchor] else f"{anchor}-{counts[anchor]}")
        counts[anchor] += 1
    return anchors


def page_faults(root: Path, page: Path) -> list[str]:
    """What is wrong with the links of a page: files and anchors that are not there, places outside of the project, broken forms."""
    text = page.read_text(encoding="utf-8")
    return [f"{page.relative_to(root).as_posix()}:{link.line}: {link.target}: {fault}"
            for link in links_of(text) if (fault := link_fault(root, page, link)) is not None]


def link_fault(root: Path, page: Path, link: Link) -> str | None:
    if link.is_external:
        return None if re.fullmatch(r"https://[a-z0-9.-]+\.[a-z]{2,}(/\S*)?|mailto:\S+@\S+", link.target) else "is no https address"
    if not link.target:
        return "leads nowhere"
    if link.path.startswith("/"):
        return "begins with /; hint: links are relative to their page"
    target = (page.parent / link.path).resolve() if link.path else page
    if not target.is_relative_to(root):
        return "leads out of the project"
    if not target.exists():
        return "there is no such file"
    if link.is_image and not target.is_file():
        return "is no image"
    if not link.anchor:
        return None
    if target.suffix != ".md":
        return "has an anchor, and is no page"
    return None if link.anchor in anchors_of(target.read_text(encoding="utf-8")) else "there is no such heading"
