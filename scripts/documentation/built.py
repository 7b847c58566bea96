"""Checks a built site: every link, image, script and anchor of its pages leads to a file and to an element that are there."""

from __future__ import annotations

from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ATTRIBUTES = {"a": "href", "img": "src", "script": "src", "link": "href", "source": "src"}
# Made for printing: its links lead to all pages at once.
LEFT_OUT = ("print.html", "404.html", "toc.html")


@dataclass
class Page(HTMLParser):
    """The ids and the targets of one page."""

    ids: set[str] = field(default_factory=set)
    targets: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__init__()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = dict(attrs)
        self.ids |= {value for name, value in attrs if name in ("id", "name") and value}
        target = values.get(ATTRIBUTES.get(tag, ""))
        if target:
            self.targets.append(target)


def built_faults(site: Path) -> list[str]:
    """What is missing, as lines; empty if nothing is."""
    pages = {path.resolve(): read(path) for path in sorted(site.rglob("*.html"))}
    if not pages:
        return [f"{site}: there is no page"]
    return [f"{path.relative_to(site.resolve())}: {target}: {fault}" for path, page in pages.items() if path.name not in LEFT_OUT
            for target in page.targets if (fault := target_fault(site.resolve(), path, target, pages)) is not None]


def read(path: Path) -> Page:
    page = Page()
    page.feed(path.read_text(encoding="utf-8"))
    return page


def target_fault(site: Path, path: Path, target: str, pages: dict[Path, Page]) -> str | None:
    parts = urlsplit(target)
    if parts.scheme or parts.netloc:
        return None
    file = (path.parent / unquote(parts.path)).resolve() if parts.path else path
    if not file.is_relative_to(site):
        return "leads out of the site"
    if file.is_dir():
        file = file / "index.html"
    if not file.is_file():
        return "there is no such file"
    anchor = unquote(parts.fragment)
    if anchor and file in pages and anchor not in pages[file].ids:
        return "there is no such anchor"
    return None
