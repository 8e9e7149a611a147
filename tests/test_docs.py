"""The manual's sources: all code is executed by the build, all that is public has a place, its checks can fail."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

import chasles

ROOT = Path(__file__).resolve().parents[1]
DOCS = ROOT / "docs"
pytestmark = pytest.mark.skipif(not DOCS.exists(), reason="needs the checkout")

PAGES = sorted(DOCS.glob("*.md"))
FENCE = re.compile(r"^(`{3,}|:{3,}|~{3,})(.*)$", re.MULTILINE)
CELL = "{code-cell}"
HEAD = ("jupytext:", "extension: .md", "format_name: myst", "kernelspec:", "name: python3")
"""By these Sphinx knows a page whose cells it is to execute, and jupytext one that it can open as a notebook."""
OTHERS = ("{toctree}", "{eval-rst}", "{literalinclude}")
"""Directives that show no code of their own: a file that is included is part of the project, and tested there."""


def openings(text: str) -> Iterator[str]:
    """What stands behind the opening of each fenced block."""
    is_open = ""
    for marks, rest in FENCE.findall(text):
        if not is_open:
            is_open = marks
            yield rest.strip()
        elif marks == is_open and not rest.strip():
            is_open = ""
    assert not is_open, "a block is not closed"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_every_code_block_is_a_cell(page: Path) -> None:
    text = page.read_text("utf-8")
    found = list(openings(text))
    assert not [what for what in found if not what.startswith((CELL, *OTHERS))]
    if any(what.startswith(CELL) for what in found):
        head = {line.strip() for line in text.partition("\n---\n")[0].splitlines()}
        assert head.issuperset(HEAD), "a page with cells needs the head of a notebook"
    assert "raises-exception" not in text
    assert "skip-execution" not in text


def test_a_block_that_is_not_executed_is_seen() -> None:
    assert list(openings("```{code-cell} python\n1\n```\n\n```python\n2\n```\n")) == [f"{CELL} python", "python"]
    with pytest.raises(AssertionError, match="not closed"):
        list(openings("```python\n"))


def test_what_is_included_is_there() -> None:
    for page in PAGES:
        for name in re.findall(r"\{literalinclude\} (\S+)", page.read_text("utf-8")):
            assert (DOCS / name).is_file(), f"{page.name} includes {name}"


def test_every_public_name_is_in_the_reference() -> None:
    reference = (DOCS / "reference.md").read_text("utf-8")
    for name in chasles.__all__:
        assert name == "__version__" or f"chasles.{name}" in reference


def test_the_readme_leads_to_the_manual() -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    assert "](docs/" in readme
    for target in re.findall(r"\]\(((?:docs|examples)/[^)#]*)", readme):
        assert (ROOT / target).exists(), target


@pytest.fixture(scope="module")
def links() -> Iterator[ModuleType]:
    """The extension that looks at the built pages."""
    spec = spec_from_file_location("links_of_the_manual", DOCS / "_extensions" / "links.py")
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules[spec.name] = module_from_spec(spec)
    spec.loader.exec_module(module)
    yield module
    del sys.modules[spec.name]


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ('<a href="other.html#there">', []),
        ('<a href="#here"><img src="data:image/png;base64,AA"><p id="here">', []),
        ('<a href="https://example.org/">', []),
        ('<a href="none.html">', ["page.html: there is no none.html"]),
        ('<a href="other.html#nowhere">', ["page.html: other.html has no place 'nowhere'"]),
        ('<a href="#nowhere">', ["page.html: page.html has no place 'nowhere'"]),
        ('<img src="none.png">', ["page.html: there is no none.png"]),
        ('<script src="https://example.org/x.js"></script>', ["page.html loads https://example.org/x.js"]),
        ('<link rel="stylesheet" href="//example.org/x.css">', ["page.html loads //example.org/x.css"]),
    ],
)
def test_links_that_lead_nowhere_are_found(links: ModuleType, tmp_path: Path, body: str, said: list[str]) -> None:
    (tmp_path / "page.html").write_text(body, "utf-8")
    (tmp_path / "other.html").write_text('<h1 id="there">', "utf-8")
    assert list(links.faults(tmp_path)) == said


def test_the_build_fails_for_a_link_that_leads_nowhere(links: ModuleType, tmp_path: Path) -> None:
    heard: dict[str, Callable[..., None]] = {}
    links.setup(SimpleNamespace(connect=heard.__setitem__))
    app = SimpleNamespace(outdir=tmp_path, builder=SimpleNamespace(format="html"))
    (tmp_path / "page.html").write_text('<a href="page.html">', "utf-8")
    heard["build-finished"](app, None)
    (tmp_path / "page.html").write_text('<a href="none.html">', "utf-8")
    with pytest.raises(links.DeadLinks, match=r"there is no none\.html"):
        heard["build-finished"](app, None)
    heard["build-finished"](app, RuntimeError("it has failed already"))
