"""`chasles new NAME`."""

from __future__ import annotations

from importlib.util import find_spec
from keyword import iskeyword
from pathlib import Path

import click

from chasles.cli.book import as_data, print_data
from chasles.cli.failures import BAD_INPUT, Failure


@click.command("new", short_help="Write a small chapter to start from.", epilog="Example: chasles new mybook")
@click.argument("folder", metavar="NAME", type=click.Path(path_type=Path))
@as_data
def command(folder: Path, json: bool) -> int:
    """Write a small chapter of your own to start from: a Python package in the folder NAME.

    It declares symbols, a section with equations, kernels and an exercise, and has a test. All commands take it by
    `--chapter`, before the command's name: `chasles --chapter ./NAME decide`.
    """
    from chasles.cli.building import NEW_CHAPTER
    from chasles.cli.files import write_files
    from chasles.targets import Origin, Page
    from chasles.targets.emit import filled

    name = folder.name
    if not name.isidentifier() or iskeyword(name):
        raise Failure(f"{name!r} is no name of a Python package: letters, digits and underscores make one", BAD_INPUT)
    if folder.exists():
        raise Failure(f"there is {folder} already: nothing was written", BAD_INPUT)
    if find_spec(name) is not None:
        raise Failure(f"there is a Python package {name} already: choose another name", BAD_INPUT)
    templates = sorted(path.relative_to(NEW_CHAPTER) for path in NEW_CHAPTER.rglob("*.jinja"))
    pages = [Page(path.with_suffix("").as_posix(), path.as_posix(), {}) for path in templates]
    texts = {page.path: filled(NEW_CHAPTER, page, Origin(name)) for page in pages}
    for part in sorted({str(Path(path).parent) for path in texts}):
        inside = {Path(path).name: text for path, text in texts.items() if str(Path(path).parent) == part}
        write_files(folder / part, inside)
    if json:
        print_data({"folder": str(folder), "files": sorted(texts)})
    else:
        click.echo(f"{folder}: {', '.join(sorted(texts))}")
        click.echo(f"Decide it with: chasles --chapter {folder if folder.parent.name else f'./{name}'} decide")
    return 0
