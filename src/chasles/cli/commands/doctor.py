"""`chasles doctor`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import click

from chasles.cli.book import as_data, print_data
from chasles.cli.failures import complain

Lines = Iterator[tuple[str, str]]


@click.command("doctor", short_help="What is installed here, and is it fresh?", epilog="Example: chasles doctor")
@as_data
def command(json: bool) -> int:
    """Say what is installed, which kernels run, with what compiler, where the cache is, and what is wrong.

    Generated kernels are fresh if they were made from the declarations as they are; `chasles emit --check` compares
    every file. The exit status is 1 if something is wrong.
    """
    from chasles.cli.diagnosis import examined, problems

    found = examined()
    wrong = list(problems(found))
    if json:
        print_data({**found, "problems": wrong})
    else:
        _show(found)
    return complain(wrong)


def _show(found: Mapping[str, Any]) -> None:
    from rich.table import Table
    from rich.text import Text

    from chasles.report.screen import Screen

    table = Table(box=None, pad_edge=False, show_header=False, padding=(0, 2, 0, 0))
    table.add_column("topic", no_wrap=True, style="bold")
    table.add_column("found", overflow="fold")
    for topic, text in _lines(found):
        table.add_row(Text(topic), Text(text))
    Screen().show(table)


def _lines(found: Mapping[str, Any]) -> Lines:
    from chasles.report.words import number_of

    own, python = found["chasles"], found["python"]
    yield "chasles", f"{own['version']} in {own['folder']}{', editable' if own['editable'] else ''}"
    yield "python", f"{python['implementation']} {python['version']}, {python['system']}, {python['executable']}"
    yield "threads", _threads(python)
    yield "libraries", ", ".join(f"{name} {version or 'missing'}" for name, version in found["libraries"].items())
    yield "extras", ", ".join(f"{name} {version or 'not installed'}" for name, version in found["extras"].items())
    yield from _kernels(found["kernels"])
    compiler, none = found["compiler"], "none: chasles.compile makes NumPy functions; CC names a compiler"
    yield "compiler", f"{compiler['command']}: {compiler['version']}" if compiler else none
    generated = found["generated"]
    state = "as the declarations ask for" if generated["fresh"] else "not as the declarations ask for"
    yield "generated", f"{state}, in {generated['folder']}"
    counted = "{declared:,} lines for declared statements, {prove:,} for chasles.prove, {all:,} with what few ask for"
    yield "checker", counted.format(**found["checker"])
    cache = found["cache"]
    size = f"{number_of(cache['files'], 'file')}, {cache['bytes'] / 1e6:.2f} MB"
    yield "cache", f"{cache['folder']}: {size}" if cache["folder"] else "off: CHASLES_CACHE is empty"


def _threads(python: Mapping[str, Any]) -> str:
    if not python["free_threaded"]:
        return "with the global lock, which compiled kernels release"
    return f"free-threaded, the global lock {'on' if python['gil_enabled'] else 'off'}"


def _kernels(kernels: Mapping[str, Any]) -> Lines:
    if kernels["backend"] is None:
        yield "kernels", "none"
        return
    kind = "compiled" if kernels["backend"] == "c" else "NumPy functions: nothing is compiled"
    chosen = " (as CHASLES_BACKEND asks)" if kernels["asked"] else ""
    yield "kernels", f"{kernels['count']}, {kind}{chosen}"
    used, best = kernels["instructions"], kernels["best_instructions"]
    if used:
        yield "dispatch", f"{used}, the best here" if used == best else f"{used}, as asked; {best} is the best here"
    if kernels["note"]:
        yield "note", kernels["note"]
