"""The source of the site: the pages of the table of contents and the files that they link to, at the places that they have in the
project, so that their links hold."""

from __future__ import annotations

import shutil
from pathlib import Path

from .links import Link, links_of

CONTENTS = Path("docs/site/SUMMARY.md")
SETTINGS = ("book.toml", "site.css")


class SiteError(Exception):
    """The site cannot be made; the text says why."""


def pages_of(root: Path) -> list[Path]:
    """The pages of the table of contents, in its order."""
    contents = root / CONTENTS
    links = links_of(contents.read_text(encoding="utf-8"))
    return [(contents.parent / link.path).resolve() for link in links]


def write_source(root: Path, folder: Path, repository: str | None) -> None:
    """Writes the source of the site into a folder. Raises SiteError for a link that no site can hold.

    Files that pages link to are copied, and folders lose their link; with the address of a repository both lead there.
    """
    source = folder / "source"
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for name in SETTINGS:
        shutil.copy(root / CONTENTS.parent / name, folder / name)
    pages = pages_of(root)
    for page in pages:
        text = page.read_text(encoding="utf-8")
        write(source / page.relative_to(root), rewritten(root, page, text, pages, source, repository))
    contents = (root / CONTENTS).read_text(encoding="utf-8")
    write(source / "SUMMARY.md", contents.replace("](../../", "](").replace("](../", "](docs/"))


def rewritten(root: Path, page: Path, text: str, pages: list[Path], source: Path, repository: str | None) -> str:
    """A page whose links hold on the site; copies the files that it links to."""
    for link in sorted(links_of(text), key=lambda each: -each.start):
        if link.is_external or not link.path:
            continue
        target = (page.parent / link.path).resolve()
        if target in pages:
            # mdBook makes the index of a folder of its README, and leaves links to it alone.
            if target.name == "README.md":
                text = text[:link.start] + link.target.replace("README.md", "index.html", 1) + text[link.end:]
            continue
        place = target.relative_to(root).as_posix()
        if target.suffix == ".md":
            raise SiteError(f"{page.relative_to(root)}:{link.line}: {place} is a page without a line in {CONTENTS}")
        if repository is not None and not link.is_image:
            kind = "tree" if target.is_dir() else "blob"
            text = text[:link.start] + f"{repository}/{kind}/HEAD/{place}" + text[link.end:]
        elif target.is_dir():
            text = without_link(text, link)
        else:
            (source / place).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(target, source / place)
    return text


def without_link(text: str, link: Link) -> str:
    """A page in which a link is its text alone."""
    opening = text.rindex("[", 0, text.rindex("](", 0, link.start + 1) + 1)
    label = text[opening + 1:text.rindex("](", 0, link.start + 1)]
    closing = text.index(")", link.end)
    return text[:opening] + label + text[closing + 1:]


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
