"""`chasles report`."""

from __future__ import annotations

from pathlib import Path

import click

from chasles.cli.book import as_data, chapter
from chasles.cli.failures import complain

__all__ = ["command"]


@click.command("report", short_help="Write the chapter as a page.", epilog="Example: chasles report --out report")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("report"),
    show_default=True,
    help="The folder to write to.",
)
@as_data
def command(out: Path, json: bool) -> int:
    """Write the whole chapter, decided and checked again: as one HTML page, and as LaTeX to print.

    index.html needs no network and no script; chapter.tex compiles with pdflatex. Both are written whole or not at
    all. The exit status is 1 if it is for `decide`, or if a derivation does not arrive.
    """
    from chasles.cli.reporting import reported
    from chasles.cli.writing import write_whole
    from chasles.report.records import as_json

    made = reported(chapter())
    write_whole(out, made.texts)
    sizes = {name: len(text.encode()) for name, text in made.texts.items()}
    if json:
        files = [{"path": str(out / name), "bytes": size} for name, size in sizes.items()]
        click.echo(as_json({"folder": str(out), "files": files, "seconds": round(made.seconds, 3)}))
    else:
        for line in made.in_words:
            click.echo(line)
        for name, size in sizes.items():
            click.echo(f"{out / name}  {size / 1e6:.2f} MB")
    return complain(made.failures)
