"""A picture is drawn once; what is kept is taken only for the same picture, whole, by the same code."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from markupsafe import Markup

from chasles import cache
from chasles.exercises.picture import Curve, Picture, Point
from chasles.report.html.pictures import drawn

PICTURE = Picture("two points", (Point((0, 0, 0), "A"), Point((1, 2, 3), "B")))


@pytest.fixture
def kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path))
    monkeypatch.setattr(cache, "engine", lambda *_: "this one")
    return tmp_path / "pictures"


def making(text: str) -> tuple[Callable[[], Markup], list[str]]:
    """What draws that text, and how often it did."""
    made: list[str] = []

    def draw() -> Markup:
        made.append(text)
        return Markup(text)

    return draw, made


def test_the_second_time_nothing_is_drawn(kept: Path) -> None:
    draw, made = making("<svg>ü</svg>")
    assert drawn(PICTURE, "here", draw) == drawn(PICTURE, "here", draw) == Markup("<svg>ü</svg>")
    assert len(made) == 1


@pytest.mark.parametrize(
    "other",
    [
        replace(PICTURE, title="others"),
        replace(PICTURE, view=(22, 36)),
        replace(PICTURE, axes=("X", "Z", "Y")),
        replace(PICTURE, items=PICTURE.items[:1]),
        replace(PICTURE, items=(Point((0, 0, 1), "A"), PICTURE.items[1])),
    ],
)
def test_another_picture_is_drawn(kept: Path, other: Picture) -> None:
    drawn(PICTURE, "here", making("one")[0])
    assert drawn(other, "here", making("two")[0]) == "two"


def test_another_place_and_other_code_draw(kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn(PICTURE, "here", making("one")[0])
    assert drawn(PICTURE, "there", making("two")[0]) == "two"
    monkeypatch.setattr(cache, "engine", lambda *_: "another")
    assert drawn(PICTURE, "here", making("three")[0]) == "three"


@pytest.mark.parametrize("damage", [lambda text: text[:-1], lambda text: "", lambda text: text.replace("one", "two")])
def test_what_is_damaged_is_drawn_anew(kept: Path, damage: Callable[[str], str]) -> None:
    drawn(PICTURE, "here", making("one")[0])
    (path,) = kept.iterdir()
    path.write_text(damage(path.read_text("utf-8")), "utf-8")
    assert drawn(PICTURE, "here", making("one again")[0]) == "one again"
    assert drawn(PICTURE, "here", making("never")[0]) == "one again"


def test_nothing_is_kept_where_nothing_is_to_be(kept: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    untold = Picture("a thing without words", (Curve((object(),)),))
    assert [drawn(untold, "here", making(text)[0]) for text in ("a", "b")] == ["a", "b"]
    monkeypatch.setenv("CHASLES_CACHE", "")
    assert [drawn(PICTURE, "here", making(text)[0]) for text in ("a", "b")] == ["a", "b"]
    monkeypatch.setenv("CHASLES_CACHE", str(tmp_path / "file" / "below"))
    (tmp_path / "file").write_text("", "utf-8")
    assert drawn(PICTURE, "here", making("a")[0]) == "a"
    assert not kept.exists()


def test_code_is_told_by_its_hash() -> None:
    parts = ("report", "cache")
    assert len({cache.engine(parts, ()), cache.engine(parts[:1], ()), cache.engine(parts, ("sympy",))}) == 3
    assert cache.engine(parts, ("no such library",)) == cache.engine(parts, ())
