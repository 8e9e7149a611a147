"""`chasles report`."""

from __future__ import annotations

from pathlib import Path

import click

from chasles.cli.book import as_data, print_data
from chasles.cli.chosen_chapter import chapter
from chasles.cli.failures import complain


@click.command("report", short_help="Write the chapter as a page.", epilog="Example: chasles report --out report")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("report"),
    show_default=True,
    help="The folder to write to.",
)
@click.option(
    "--site",
    type=click.Path(path_type=Path, file_okay=False),
    help="A folder to write a site to instead: a page for each equation, for any host of static files.",
)
@click.option("--address", default="", metavar="URL", help="Where the site will lie; shared pages then have pictures.")
@as_data
def command(out: Path, site: Path | None, address: str, json: bool) -> int:
    """Write the whole chapter, decided and checked again: as one HTML page, and as LaTeX to print.

    index.html needs no network; chapter.tex compiles with pdflatex. Either everything is written or nothing. The
    exit status is 1 where that of `decide` is, or if a derivation is not complete.
    """
    from chasles.cli.files import write_files
    from chasles.cli.reporting import reported

    if address and site is None:
        raise click.UsageError("--address says where a site will lie: give --site too")
    folder = site or out
    made = reported(chapter(), site is not None, address)
    write_files(folder, made.files)
    sizes = {name: len(text if isinstance(text, bytes) else text.encode()) for name, text in made.files.items()}
    if json:
        files = [{"path": str(folder / name), "bytes": size} for name, size in sizes.items()]
        print_data({"folder": str(folder), "files": files, "seconds": round(made.seconds, 3)})
    else:
        for line in made.in_words:
            click.echo(line)
        if site is not None:
            sizes = {"index.html": sum(sizes.values())}
            click.echo(f"{len(made.files)} files:")
        for name, size in sizes.items():
            click.echo(f"{folder / name}  {size / 1e6:.2f} MB")
    return complain(made.failures)
