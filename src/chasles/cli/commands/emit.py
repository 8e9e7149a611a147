"""`chasles emit`."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any

import click

from chasles.cli.book import as_data, print_data
from chasles.cli.checkout import generated_folder, remember
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import FAILED, complain, failing

if TYPE_CHECKING:
    from collections.abc import Mapping


@click.command("emit", short_help="Write the kernels in every language.", epilog="Example: chasles emit --check")
@click.option("--check", is_flag=True, help="Change nothing; name the files that are not as they would be emitted.")
@click.option("--anew", is_flag=True, help="Search for all proofs again; do not check what is known.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    help="The folder to write to, rather than generated/ of the checkout, or of the chapter's package.",
)
@click.option(
    "--target",
    "targets",
    multiple=True,
    help="A language, as rust: its files alone, below the current folder. Can be given several times.",
)
@click.option("--answers", "answers_alone", is_flag=True, help="What `decide` checks instead of searching, alone.")
@as_data
def command(
    check: bool, anew: bool, out: Path | None, targets: tuple[str, ...], answers_alone: bool, json: bool
) -> int:
    """Write the kernels of all proved statements, in every language, and the verdicts on all statements.

    A kernel is refused unless its program is proved equal to its statement; the others are emitted. Either all files
    are written or none; an unchanged file keeps its time. Status 1: a kernel was refused or, with --check, a file is
    out of date.
    """
    from chasles.cli.answers import answers
    from chasles.cli.emission import Commissioned, everything, in_languages
    from chasles.decisions.recalled import session_of
    from chasles.report.words import number_of, seconds
    from chasles.targets import EmissionError

    started = perf_counter()
    book = chapter()
    folder = out or (Path.cwd() if targets else generated_folder(book, Path.cwd()))
    made = Commissioned()
    if answers_alone:
        texts, head = answers(book, session_of(book, anew)), "the answers"
    else:
        made, texts = in_languages(book, targets, anew) if targets else everything(book, folder, anew)
        head = f"{number_of(len(made.kernels), 'kernel')}, each proved equal to its statement"
    in_part = bool(targets) or answers_alone
    with failing(EmissionError):
        if check:
            return max(_check(folder, texts, head, in_part, json), made.complained())
        report = _write(folder, texts, in_part)
        if not in_part:
            remember(book, folder)
    if json:
        names = [kernel.name for kernel in made.kernels]
        print_data({"folder": str(folder), "kernels": names, "refused": list(made.refused), **report})
    else:
        click.echo(f"{head}, emitted in {seconds(perf_counter() - started)}")
        click.echo(f"files in {folder}: {_counted(report)}")
    return made.complained()


def _write(folder: Path, texts: Mapping[str, str], others_stay: bool) -> dict[str, Any]:
    from chasles.targets import EmissionError, place, write

    try:
        written = (place if others_stay else write)(folder, texts)
    except OSError as error:
        raise EmissionError(f"cannot write to {folder}, nothing was changed: {error.strerror or error}") from error
    return {"changed": list(written.changed), "removed": list(written.removed), "unchanged": written.unchanged}


def _counted(report: Mapping[str, Any]) -> str:
    counts = {"changed": len(report["changed"]), "removed": len(report["removed"]), "unchanged": report["unchanged"]}
    return ", ".join(f"{count} {what}" for what, count in counts.items() if count)


def _check(folder: Path, texts: Mapping[str, str], head: str, others_stay: bool, json: bool) -> int:
    from chasles.targets import stale

    found = stale(folder, texts)
    differences = tuple(each for each in found if not (others_stay and each.kind == "superfluous"))
    if json:
        rows = [{"path": d.path, "kind": d.kind, "summary": d.summary} for d in differences]
        print_data({"folder": str(folder), "stale": rows})
    elif not differences:
        click.echo(f"{head}; {folder} is as emitted")
    for difference in () if json else differences:
        click.echo(difference.summary)
    if not differences:
        return 0
    names = ", ".join(difference.path for difference in differences)
    complain([f"{folder} is stale, `chasles emit` brings it up to date: {names}"])
    return FAILED
