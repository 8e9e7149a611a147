"""Pages by others, read and decided: `python -m benchmarks.reading`, or with --slips to plant slips in them.

Each page is a short excerpt with its source and licence at the top; beside it is the notation that says what its
letters are. A slip is a sign, a transpose or a letter changed in one place: it is told if an equation more than before
is wrong, and pointed at if one more than before is wrong or open.
"""

from __future__ import annotations

import re
import sys
import time
from collections.abc import Iterator
from pathlib import Path

from chasles.pages.page import ReadPage, read_page
from chasles.reading.equations import read_equations
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import displayed, kind_of
from chasles.reading.proposal import proposed

HERE = Path(__file__).parent
WRONG = ("fails", "ill-formed")
SUSPECT = (*WRONG, "open", "unread", "ambiguous")
SLIPS = ((r" \+ ", " - "), (r" - ", " + "), (r"\^\\transpose", ""), (r"\^T", ""), (r"q_1", "q_2"), (r"2 q_0", "q_0"))


def page_of(path: Path, text: str) -> ReadPage:
    """The page decided with the notation beside it."""
    return read_page(displayed(text, kind_of(path.name), file=path.name), load_notation(path.with_suffix(".toml")))


def read_as_proposed(path: Path, text: str) -> int:
    """How many equalities are read with the notation that --propose writes, uncorrected."""
    printed = displayed(text, kind_of(path.name))
    read = read_equations(printed, load_notation(proposed(printed)))
    return sum(len(each.readings[0].parts) for each in read if each.readings)


def slips(text: str) -> Iterator[str]:
    """The text with one slip, for each place in a formula."""
    start = max(text.find("\\section"), text.find(".. math"))
    for pattern, instead in SLIPS:
        for found in re.finditer(pattern, text[start:]):
            place = start + found.start()
            yield text[:place] + instead + text[start + found.end() :]


def main() -> None:
    """Prints what is found on each page, and with --slips how many planted ones are."""
    for path in sorted(each for each in HERE.iterdir() if each.suffix in (".tex", ".md", ".rst")):
        text = path.read_text("utf-8")
        start = time.process_time()
        page = page_of(path, text)
        taken = time.process_time() - start
        print(f"{path.name}: {page.summary}; {read_as_proposed(path, text)} read with what is proposed; {taken:.1f} s")
        for each in page.equations:
            if each.verdict in WRONG:
                print(f"  line {each.printed.line}, part {each.place}: {each.verdict}")
        if "--slips" in sys.argv:
            planted = [page_of(path, slip) for slip in slips(text)]
            told = sum(count(each, WRONG) > count(page, WRONG) for each in planted)
            seen = sum(count(each, SUSPECT) > count(page, SUSPECT) for each in planted)
            print(f"  {len(planted)} slips planted: {told} told, {seen} pointed at")


def count(page: ReadPage, verdicts: tuple[str, ...]) -> int:
    """How many equations have one of these verdicts."""
    return sum(each.verdict in verdicts for each in page.equations)


if __name__ == "__main__":
    main()
