"""Pages of the documentation: every link leads somewhere, the site holds all of them, and faults are found."""

from __future__ import annotations

import subprocess
import sys

import pytest
from conftest import ROOT
from documentation.built import built_faults
from documentation.links import anchors_of, links_of, page_faults
from documentation.source import CONTENTS, SiteError, pages_of, write_source

import build_site as site

FOLDERS = ("assets", "configs", "docs", "scripts", "tests", "viewer")
PAGES = sorted([*ROOT.glob("*.md"), *(page for folder in FOLDERS for page in (ROOT / folder).rglob("*.md")
                                      if "node_modules" not in page.parts)])


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_link_of_a_page_leads_somewhere(page):
    assert page_faults(ROOT, page) == []


def test_the_site_holds_every_page_of_the_documentation_once():
    pages = pages_of(ROOT)
    assert len(set(pages)) == len(pages)
    assert {page for page in PAGES if page.is_relative_to(ROOT / "docs")} - {ROOT / CONTENTS} <= set(pages)
    assert {ROOT / name for name in ("README.md", "ARCHITECTURE.md", "CHANGELOG.md")} <= set(pages)


class TestLinks:
    def test_are_found_across_lines_and_around_images_and_not_in_code(self):
        text = ("[one\n  two](a.md#b) ![picture](c.png) [![d](e.png)](f.md)\n\n    [no](g.md)\n\n```\n[no](h.md)\n```\n`[no](i.md)` "
                "[j](k_(l).md \"title\")\n")
        assert [(link.target, link.line) for link in links_of(text)] == [
            ("a.md#b", 1), ("c.png", 2), ("f.md", 2), ("e.png", 2), ("k_(l).md", 9)]

    def test_anchors_are_those_of_github(self):
        text = "# What is `a_b`?\n## Twice\n## Twice\n```\n# no heading\n```\n### [Linked](x.md) & more\n"
        assert anchors_of(text) == {"what-is-a_b", "twice", "twice-1", "linked--more"}

    @pytest.mark.parametrize("link, fault", [
        ("[a](absent.md)", "there is no such file"), ("[a](#absent)", "there is no such heading"),
        ("[a](other.md#absent)", "there is no such heading"), ("[a](../outside.md)", "leads out of the project"),
        ("[a](/other.md)", "begins with /"), ("[a](http://example.org)", "is no https address"),
        ("[a](https://nowhere)", "is no https address"), ("![a](folder)", "is no image"), ("[a]()", "leads nowhere"),
        ("[a](data.yaml#b)", "has an anchor, and is no page"),
    ])
    def test_that_lead_nowhere_are_faults_with_their_line(self, tmp_path, link, fault):
        (tmp_path / "other.md").write_text("# Here\n")
        (tmp_path / "data.yaml").write_text("a: 1\n")
        (tmp_path / "folder").mkdir()
        page = tmp_path / "page.md"
        page.write_text(f"# Page\n\n[here](other.md#here) [above](#page) [site](https://example.org/a)\n\n{link}\n")
        (found,) = page_faults(tmp_path, page)
        assert found.startswith("page.md:5: ") and fault in found


@pytest.fixture
def project(tmp_path):
    """A project of two pages, a file and a folder that they link to."""
    root = tmp_path / "project"
    for name, text in {
        "docs/site/SUMMARY.md": "# Summary\n\n[Start](../../README.md)\n\n- [One](../one.md)\n",
        "docs/site/book.toml": "", "docs/site/site.css": "",
        "README.md": "# Start\n[one](docs/one.md#a) [code](src/lib.rs) [all of it](src)\n", "src/lib.rs": "fn main() {}\n",
        "docs/one.md": "# A\n[start](../README.md#start)\n",
    }.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    return root


class TestSource:
    def test_has_the_files_that_pages_link_to_and_no_links_to_folders(self, project, tmp_path):
        write_source(project, tmp_path / "made", None)
        source = tmp_path / "made" / "source"
        assert (source / "README.md").read_text() == "# Start\n[one](docs/one.md#a) [code](src/lib.rs) all of it\n"
        assert (source / "docs" / "one.md").read_text() == "# A\n[start](../index.html#start)\n"
        assert (source / "src" / "lib.rs").read_text() == "fn main() {}\n"
        assert "[Start](README.md)" in (source / "SUMMARY.md").read_text() and "[One](docs/one.md)" in (source / "SUMMARY.md").read_text()

    def test_leads_to_the_repository_where_its_address_is_known(self, project, tmp_path):
        write_source(project, tmp_path / "made", "https://example.org/a")
        text = (tmp_path / "made" / "source" / "README.md").read_text()
        assert "[code](https://example.org/a/blob/HEAD/src/lib.rs) [all of it](https://example.org/a/tree/HEAD/src)" in text

    def test_refuses_a_page_that_the_contents_lack(self, project, tmp_path):
        (project / "docs" / "two.md").write_text("# Two\n")
        (project / "docs" / "one.md").write_text("# A\n\n[two](two.md)\n")
        with pytest.raises(SiteError, match="docs/one.md:3: docs/two.md is a page without a line in docs/site/SUMMARY.md"):
            write_source(project, tmp_path / "made", None)


def test_what_a_built_site_lacks_is_found(tmp_path):
    (tmp_path / "a.html").write_text('<h1 id="top">A</h1><a href="b.html#here"><a href="b.html#absent"><img src="no.png"><a href="../up.html">'
                                     '<a href="https://example.org/"><a href="#top">')
    (tmp_path / "b.html").write_text('<p id="here"></p><a href="a.html">')
    assert built_faults(tmp_path) == ["a.html: b.html#absent: there is no such anchor", "a.html: no.png: there is no such file",
                                      "a.html: ../up.html: leads out of the site"]


@pytest.mark.skipif(site.find_mdbook() is None, reason="there is no mdbook (scripts/build_site.py --install)")
def test_the_site_is_built_without_a_fault(tmp_path):
    done = subprocess.run([sys.executable, ROOT / "scripts" / "build_site.py", "--out", tmp_path / "site"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert len(list((tmp_path / "site").rglob("*.html"))) >= len(pages_of(ROOT))
    (index,) = (tmp_path / "site").glob("searchindex*.js")
    assert "hinge" in index.read_text(encoding="utf-8")
