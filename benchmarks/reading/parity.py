"""Verdicts of a page beside those of its declarations: `python -m benchmarks.reading.parity CHAPTER [PAGE [NOTATION]]`.

CHAPTER is a package of declarations or its folder, PAGE the text that it declares; without one, the chapter's own
statements are printed as a page. NOTATION says what the letters are, and what stands in prose only; without it the
chapter does. A relation of the page is compared with the declaration of the same sides, or of the same number and
part. What differs is listed with both verdicts.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import chasles.cli  # noqa: F401  (it says that matrices are small, before NumPy is loaded)
from chasles.decisions.session import Session
from chasles.pages.chapter_notation import notation_of_chapter
from chasles.pages.page import ReadPage, read_page
from chasles.pages.page_equation import PageEquation
from chasles.reading.notation_file import load_notation
from chasles.reading.pages import displayed, kind_of
from chasles.statements import Chapter, Statement, load
from chasles.vocabulary import latex

SAME = {"holds-under": "holds", "posed": "condition", "assumed": "condition", "stands": "holds"}
"""Verdicts that are told apart by what is needed only, or by what a person calls an equation."""


def as_page(chapter: Chapter) -> str:
    """The statements of a chapter as a page of LaTeX, section by section."""
    lines: list[str] = []
    for section in chapter.sections:
        lines.append(f"\\section{{{section.number} {section.title}}}")
        for entry in chapter.select(sections=[section.number]):
            if entry.section == section and isinstance(entry.statement, Statement):
                said = entry.statement
                lines.append(f"\\[ {latex(said.left)} {said.sign} {latex(said.right)} \\tag{{{entry.number}}} \\]")
    return "\n\n".join(lines)


def compared(page: ReadPage, chapter: Chapter) -> Iterator[tuple[PageEquation, str, str]]:
    """Each relation of the page that is declared, its verdict, and that of the declaration."""
    session = Session()
    statements = [entry.statement for entry in chapter if isinstance(entry.statement, Statement)]
    by_sides = {(each.number, *each.printed): each for each in reversed(statements)}
    by_part = {(each.number, each.part): each for each in statements}
    for each in page.equations:
        sides = (each.part.left, each.part.right) if each.part else ()
        declared = by_sides.get((each.number, *sides)) or by_part.get((each.number, each.place))
        if declared is not None:
            verdict = session.decide(declared).verdict.name
            yield each, SAME.get(each.verdict, each.verdict), SAME.get(verdict, verdict)


def main(package: str, page: str = "", notation: str = "") -> None:
    """Prints what differs, and the share of verdicts that are the same."""
    chapter = load(package)
    text = Path(page).read_text("utf-8") if page else as_page(chapter)
    known = load_notation(Path(notation)) if notation else notation_of_chapter(chapter)
    printed = displayed(text, kind_of(page or "page.tex"), file=page or "page.tex")
    found = list(compared(read_page(printed, known, page or "page.tex"), chapter))
    for each, read, declared in found:
        if read != declared:
            print(f"({each.number}) part {each.place}, line {each.line}: {read}; as declared {declared}")
    counts = Counter((read, declared) for _, read, declared in found if read != declared)
    same = len(found) - counts.total()
    print(f"{same} of {len(found)} relations have the same verdict, {same / max(len(found), 1):.0%};", end=" ")
    print(", ".join(f"{n} {read}, declared {declared}" for (read, declared), n in counts.most_common()))


if __name__ == "__main__":
    main(*sys.argv[1:])
