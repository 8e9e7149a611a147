"""A page read with a notation and decided, and the folder for a chapter of it."""

from __future__ import annotations

import sys
from dataclasses import dataclass, replace
from pathlib import Path

from chasles.cli.failures import BAD_INPUT, Failure, failing
from chasles.cli.files import replace_whole, text_of_file
from chasles.pages.chapter_notation import notation_of_chapter
from chasles.pages.folder import QUESTIONS, RECORD, BadRecord, answers, files_of
from chasles.pages.known_answers import KnownAnswers
from chasles.pages.page import ReadPage, read_page
from chasles.reading.letter_table import BadNotation
from chasles.reading.lexemes import BadPage
from chasles.reading.notation_file import load_notation, noted
from chasles.reading.page_notation import PageNotation
from chasles.reading.pages import kind_of, printed_page
from chasles.reading.printed import PrintedEquation, PrintedPage
from chasles.statements import DeclarationError, load
from chasles.statements.packages import imported


@dataclass(frozen=True, slots=True)
class PageMatch:
    """A page, and the entries and the numbers of its notation that nothing on it matches."""

    page: ReadPage
    entries: tuple[str, ...]
    numbers: tuple[str, ...]


def printed_on(page: Path, macros: Path | None, inline: bool, follow: bool) -> PrintedPage:
    """The equations of a page and the formulas in its prose; what is wrong with it in one line."""

    def included(name: str) -> tuple[str, str]:
        path = page.parent / name
        path = path if path.suffix else path.with_suffix(".tex")
        return str(path), text_of_file(path)

    try:
        kind = kind_of(page.name)
        text, defined = text_of_file(page), text_of_file(macros) if macros else ""
        follows = included if follow else None
        return printed_page(text, kind, file=str(page), macros=defined, is_inline=inline, included=follows)
    except BadPage as error:
        raise Failure(f"{page}:{error.line}: {error}", BAD_INPUT) from error


def read(
    page: Path, printed: tuple[PrintedEquation, ...], name: str, out: Path | None, known: KnownAnswers
) -> PageMatch:
    """The page decided, with what a person has answered, and the letters and numbers of the notation that it lacks.

    What came of it is written to the folder.
    """
    try:
        notation = _notation(name)
        if out is None:
            return _with_what_it_lacks(read_page(printed, notation, str(page), known), notation)
        asked, given = _answered(out)
        told = noted(given, f"{asked}: ")
        notes = {each: {**notation.notes.get(each, {}), **told.get(each, {})} for each in {**notation.notes, **told}}
        found = read_page(printed, replace(notation, notes=notes), str(page), known)
    except BadNotation as error:
        raise Failure(str(error) if str(error).startswith(name) else f"{name}: {error}", BAD_INPUT) from error
    _write(found, given, out)
    return _with_what_it_lacks(found, notation)


def _answered(out: Path) -> tuple[Path, dict[str, dict[str, str]]]:
    """The file in the folder that asks a person, and what is filled in there."""
    asked = out / QUESTIONS
    with failing(ValueError, before=f"{asked}: ", status=BAD_INPUT):
        return asked, answers(text_of_file(asked)) if asked.exists() else {}


def _write(page: ReadPage, given: dict[str, dict[str, str]], out: Path) -> None:
    """Write the chapter and what is asked to the folder, but for declarations in it that a person has changed."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        before = {file.name: text_of_file(file) for file in out.iterdir() if file.suffix in (".py", ".json")}
        replace_whole({out / file: text for file, text in files_of(page, given, before).items()})
    except OSError as error:
        raise Failure(f"cannot write {out}: {error.strerror}", BAD_INPUT) from error
    except SyntaxError as error:
        where = f"{out / (error.filename or '')}:{error.lineno}"
        raise Failure(f"{where}: {error.msg}: correct the module, or remove it", BAD_INPUT) from error
    except BadRecord as error:
        raise Failure(f"{out / RECORD}: {error}: correct the file, or remove it", BAD_INPUT) from error


def _with_what_it_lacks(page: ReadPage, notation: PageNotation) -> PageMatch:
    names = {name for each in page.equations for name in (each.number, f"{each.number}/{each.place}")}
    return PageMatch(page, notation.unmatched, tuple(name for name in notation.notes if name not in names))


def _notation(name: str) -> PageNotation:
    """The notation in a TOML file, in a Python module by its name, or of a chapter by its package's name or folder."""
    if str(Path.cwd()) not in sys.path:
        sys.path.append(str(Path.cwd()))
    if name.endswith(".toml"):
        return load_notation(Path(name))
    try:
        module = imported(name)
        return notation_of_chapter(load(name)) if hasattr(module, "SECTIONS") else load_notation(module)
    except DeclarationError as error:
        raise Failure(str(error), BAD_INPUT) from error
    except ModuleNotFoundError as error:
        wanted = "give a TOML file, the name of a module, or a chapter by its name or folder"
        raise Failure(f"there is no notation {name!r}: {wanted}", BAD_INPUT) from error
