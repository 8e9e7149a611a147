"""The report where it is used: in a browser, in LaTeX, in another process."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from .browser import CHROMIUM, DRIVER, browser
from .parsed_page import Parsed
from .sampling import WHOLE, sample

ROOT = Path(__file__).resolve().parents[1]

pytestmark = pytest.mark.slow
needs_browser = pytest.mark.skipif(
    not (CHROMIUM and DRIVER), reason="no browser: apt-get install chromium chromium-driver fonts-dejavu fonts-lmodern"
)


@pytest.fixture(scope="module")
def html(report: dict[str, str]) -> str:
    return report["index.html"]


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no pdflatex: apt-get install texlive-latex-recommended")
def test_the_latex_compiles(report: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "chapter.tex").write_text(report["chapter.tex"], "utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "chapter.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, errors="replace", check=False)
    assert done.returncode == 0, done.stdout[-2000:]
    assert "Overfull \\hbox" not in done.stdout
    assert (tmp_path / "chapter.pdf").stat().st_size > 1e5


def test_two_hash_seeds_give_the_same_bytes(tmp_path: Path) -> None:
    """Of a short chapter; all of the book where the whole is tried."""
    chapter = () if WHOLE else ("--chapter", str(ROOT / "examples" / "planar"))
    written = []
    for seed, processes in (("3", "2"), ("7", "1")):
        folder = tmp_path / seed
        command = [sys.executable, "-m", "chasles", *chapter, "report", "--out", str(folder)]
        environment = {**os.environ, "PYTHONHASHSEED": seed, "CHASLES_PROCESSES": processes}
        done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        written.append({path.name: path.read_text("utf-8") for path in folder.iterdir()})
    assert sorted(written[0]) == ["chapter.tex", "index.html"]
    assert written[0] == written[1]


@needs_browser
def test_a_browser_shows_it_all(html: str, tmp_path: Path) -> None:
    place = tmp_path / "index.html"
    place.write_text(html, "utf-8")
    count, elements = html.count("<math"), len(Parsed(html).tags)
    with browser() as window:
        for width, dark in WIDTHS:
            window.open(place.as_uri(), width, dark)
            window.run("for (const each of document.querySelectorAll('details')) each.open = true")
            assert window.run("return [innerWidth, document.documentElement.scrollWidth]") == [width, width]
            drawn = window.run(DRAWN)
            assert drawn["formulas"] == count
            assert drawn["elements"] == elements
            assert drawn["flat"] == []
            assert drawn["clipped"] == []
            assert drawn["outside"] == []
            assert not re.search(r"\\[A-Za-z]+|[_^]\{", drawn["text"])
        window.run("document.getElementById('verdict-fails').click()")
        assert window.run(SHOWN) == ["(3.96e)", "(3.148)"]
        window.run("document.getElementById('only-within-3-5').click()")
        assert window.run(SHOWN) == ["(3.96e)"]
        window.run("location.hash = 'n-3-18'")
        assert "(3.18)" in window.run(SHOWN)
        window.picture(tmp_path / "page.png")
        window.run("for (const all of ['verdict-all', 'only-all']) document.getElementById(all).click()")
        window.as_on_paper(PAPER)
        for font in sample(FONTS, 3):
            assert window.run(IN_FONT, font) == [PAPER, PAPER], font
        assert window.run(IN_FONT, "") == [PAPER, PAPER]
        assert window.run(SMALLEST) >= READABLE
        window.printed(tmp_path / "page.pdf")
        assert window.console() == []
    assert (tmp_path / "page.png").stat().st_size > 1e4
    assert (tmp_path / "page.pdf").stat().st_size > 1e5


WIDTHS = sample(((390, True), (768, False), (1280, False)), 2)
"""A telephone in the dark, a wide window in the light, and one between them."""
PAPER = 688
"""How wide A4 is between its margins, in pixels; a browser prints all smaller if anything is wider."""
FONTS = ("monospace", "DejaVu Sans Mono", "DejaVu Serif", "DejaVu Math TeX Gyre")
"""Wide ones; where they are missing, the browser takes what there is."""
IN_FONT = """
const style = document.getElementById('tried') || document.head.appendChild(document.createElement('style'));
style.id = 'tried';
style.textContent = arguments[0] && `body, body *, math { font-family: '${arguments[0]}' !important; }`;
return [innerWidth, document.documentElement.scrollWidth];
"""
READABLE = 6
"""Pixels of an em: with less, a formula on paper cannot be read."""
SMALLEST = """
const shown = [...document.querySelectorAll('math')].filter(each => each.checkVisibility());
return Math.min(...shown.map(each => parseFloat(getComputedStyle(each).fontSize)));
"""
DRAWN = """
const formulas = [...document.querySelectorAll('math')];
const size = each => each.getBoundingClientRect();
const tall = each => each.closest('.formula');
return {
  formulas: formulas.length,
  elements: document.querySelectorAll('*').length,
  flat: formulas.filter(each => size(each).width < 4 || size(each).height < 4).map(each => each.textContent),
  clipped: formulas.filter(each => tall(each) && tall(each).scrollHeight > tall(each).clientHeight + 1)
                   .map(each => each.textContent),
  outside: [...document.querySelectorAll('svg.picture text')].filter(each => {
    const letters = size(each), frame = size(each.closest('svg'));
    return letters.left < frame.left - 1 || letters.right > frame.right + 1
        || letters.top < frame.top - 1 || letters.bottom > frame.bottom + 1;
  }).map(each => `${each.closest('svg').querySelector('title').textContent}: ${each.textContent}`),
  text: document.body.innerText,
};
"""
SHOWN = """
return [...document.querySelectorAll('.chapter .number')].filter(each => each.checkVisibility())
    .map(each => each.querySelector('h4').innerText);
"""


@needs_browser
def test_no_letter_is_missing(html: str, tmp_path: Path) -> None:
    place = tmp_path / "index.html"
    place.write_text(html, "utf-8")
    with browser() as window:
        window.open(place.as_uri(), 1280)
        missing = window.run(MISSING)
    assert missing == [], "install a font with the letters of mathematics: fonts-lmodern, fonts-dejavu or fonts-stix"


MISSING = """
const family = getComputedStyle(document.querySelector('.formula math')).fontFamily;
const canvas = document.createElement('canvas');
canvas.width = canvas.height = 48;
const pen = canvas.getContext('2d', {willReadFrequently: true});
const drawn = letter => {
  pen.clearRect(0, 0, 48, 48);
  pen.font = `30px ${family}`;
  pen.fillText(letter, 8, 36);
  return canvas.toDataURL();
};
const none = drawn(String.fromCodePoint(0x10FFFD));
const text = [...document.querySelectorAll('math')].map(each => each.textContent).join('');
return [...new Set(text)].filter(letter => letter.trim() && drawn(letter) === none);
"""
