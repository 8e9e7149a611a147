"""`chasles build`."""

from __future__ import annotations

from pathlib import Path
from time import perf_counter

import click

from chasles.cli.book import as_data, print_data
from chasles.cli.checkout import generated_folder, remember
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import BAD_INPUT, Failure, failing
from chasles.statements.packages import BOOK


@click.command(
    "build",
    short_help="Emit and compile a chapter's kernels.",
    epilog="Example: chasles build --out DIR, after --chapter",
)
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    help="The folder to write to, rather than generated/ of the chapter's package.",
)
@as_data
def command(out: Path | None, json: bool) -> int:
    """Emit the kernels of another chapter, and compile them with the system's C compiler.

    After that `from PACKAGE import kernels` gives them to programs: as ufuncs, and `kernels.one`, `kernels.checked`.
    Status 1: a kernel was refused; the others are compiled.
    """
    from chasles.cli.building import compiled, offered
    from chasles.cli.emission import everything
    from chasles.report.words import number_of, seconds
    from chasles.targets import EmissionError, write

    started = perf_counter()
    book = chapter()
    if book.package == BOOK:
        raise Failure(f"`make compile` compiles the kernels of {BOOK}: name another chapter with --chapter", BAD_INPUT)
    folder = out or generated_folder(book, Path.cwd())
    made, texts = everything(book, folder, anew=False)
    with failing(EmissionError):
        write(folder, texts)
    remember(book, folder)
    library = compiled(made.kernels, texts, folder)
    module = offered(book, folder)
    if json:
        names, refused = [kernel.name for kernel in made.kernels], list(made.refused)
        report = {"folder": str(folder), "kernels": names, "refused": refused}
        print_data({**report, "compiled": str(library), "import": module})
    else:
        click.echo(
            f"{number_of(len(made.kernels), 'kernel')}, proved and compiled in {seconds(perf_counter() - started)}"
        )
        click.echo(f"from {module} import kernels")
    return made.complained()
