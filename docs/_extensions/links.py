"""Every link within the built pages leads somewhere, and no page loads anything from the network."""

from __future__ import annotations

from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import unquote, urlsplit

if TYPE_CHECKING:
    from sphinx.application import Sphinx

LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}
"""Elements that a browser loads something for, and the attribute that says what."""


class DeadLinks(ValueError):
    """What does not lead anywhere, a line each."""


class _Page(HTMLParser):
    """The places of a page, what it links to and what it loads."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.places: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.places |= {name for name in (given.get("id"), given.get("name")) if name}
        if tag == "a" and given.get("href"):
            self.links.append(str(given["href"]))
        if given.get(LOADED.get(tag, "")):
            self.loads.append(str(given[LOADED[tag]]))


def faults(folder: Path) -> Iterator[str]:
    """A line for each link that leads nowhere, and for each thing from the network."""
    pages = {path: _Page(path.read_text("utf-8")) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for link in dict.fromkeys((*page.links, *page.loads)):
            address = urlsplit(link)
            if address.scheme or address.netloc:
                if link in page.loads and address.scheme != "data":
                    yield f"{path.name} loads {link}"
                continue
            to = (path.parent / unquote(address.path)).resolve() if address.path else path
            if not to.is_file():
                yield f"{path.name}: there is no {link}"
            elif address.fragment and to in pages and unquote(address.fragment) not in pages[to].places:
                yield f"{path.name}: {to.name} has no place {address.fragment!r}"


def _check(app: Sphinx, exception: Exception | None) -> None:
    if exception is None and app.builder.format == "html":
        found = list(faults(Path(app.outdir).resolve()))
        if found:
            raise DeadLinks("\n".join(found))


def setup(app: Sphinx) -> dict[str, bool]:
    """Look at the pages when they are built."""
    app.connect("build-finished", _check)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
