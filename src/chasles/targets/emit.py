"""Which files come out? All the text of generated/, as a pure function of the kernels and the languages."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from jinja2 import TemplateError

from chasles import __version__
from chasles.lowering.program import Op
from chasles.targets.contract import cited, operations
from chasles.targets.filling import layout
from chasles.targets.kernel import EmissionError, TargetKernel, signature
from chasles.targets.offering import offering
from chasles.targets.target import Origin, Page, Target, discover, every_target

if TYPE_CHECKING:
    from chasles.bounds.bound import Bound

MANIFEST = "MANIFEST.toml"
HEAD = ("SPDX-License-Identifier: BSD-3-Clause", f"Emitted by chasles {__version__}.")
"""How every file of code begins: people copy single ones."""
_COMMENTS = {
    **dict.fromkeys((".c", ".h"), "/* {} */\n"),
    **dict.fromkeys((".cu", ".cuh", ".hpp", ".rs"), "// {}\n"),
    ".py": "# {}\n",
}
_INDEX = Path(__file__).parent / "templates"
BOOK = Origin()


def render(
    kernels: Iterable[TargetKernel],
    targets: Iterable[Target],
    beside: Mapping[str, str] | None = None,
    origin: Origin = BOOK,
) -> dict[str, str]:
    """The text of every file, by its path below generated/ with forward slashes; the manifest is the last.

    Pages that are to stand `beside` the kernels are listed in the
    manifest with them.

    The same kernels in the same order give the same bytes. Raises EmissionError where two kernels share a name, two
    files a path, or a target cannot spell a kernel.
    """
    kernels = tuple(kernels)
    pages = {**spelled_out(kernels, targets, HEAD, origin), **(beside or {})}
    offered = offering(kernels, pages) if origin.package else ()
    top = [*offered, *_index(kernels, [*pages, *(page.path for page in offered)])]
    return pages | {page.path: filled(_INDEX, page, origin, HEAD) for page in top}


def taken_away(
    kernels: Iterable[TargetKernel], names: Iterable[str], head: Iterable[str], origin: Origin
) -> dict[str, str]:
    """The text of every file that stands alone in the languages of these names, by its path; there is no manifest.

    Raises EmissionError as `render` does, and for a language in which nothing stands alone.
    """
    chosen = []
    for target in discover(named=names):
        if target.alone is None:
            others = ", ".join(each.name for each in every_target() if each.alone is not None)
            raise EmissionError(f"nothing of the target {target.name!r} stands alone; what can be taken away: {others}")
        chosen.append(replace(target, pages=target.alone))
    return spelled_out(kernels, chosen, head, origin)


def spelled_out(
    kernels: Iterable[TargetKernel], targets: Iterable[Target], head: Iterable[str] = HEAD, origin: Origin = BOOK
) -> dict[str, str]:
    """The text of every file of the languages, by its path, without what stands beside them.

    Raises EmissionError as `render` does.
    """
    kernels, head = tuple(kernels), tuple(head)
    _require_distinct((kernel.name for kernel in kernels), "kernels are called")
    texts: dict[str, str] = {}
    for target in targets:
        try:
            pages = [*target.pages(kernels)]
            made = [(f"{target.name}/{page.path}", filled(target.templates, page, origin, head)) for page in pages]
        except EmissionError as error:
            raise EmissionError(f"target {target.name}: {error}") from error
        _require_distinct([*texts, *(path for path, _ in made)], "files are to be written to")
        texts |= made
    return texts


def _index(kernels: tuple[TargetKernel, ...], paths: list[str]) -> list[Page]:
    """The files at the top of generated/."""
    files = [*paths, "README.md", "__init__.py"]
    folders = sorted({path.split("/")[0] for path in paths if "/" in path})
    values = {
        "files": [_quoted(path) for path in sorted(files)],
        "folders": ", ".join(f"`{folder}`" for folder in folders),
        "kernels": [_entry(kernel) for kernel in kernels],
    }
    return [Page(name, f"{name}.jinja", values) for name in ("README.md", "__init__.py", MANIFEST)]


def _entry(kernel: TargetKernel) -> dict[str, object]:
    """A kernel as the manifest and the table of the README show it."""
    heading, counts = kernel.heading, kernel.program.operations
    assumes = ", ".join(heading.hypotheses) or "nothing"
    return {
        "name": kernel.name,
        "number": _quoted(heading.number),
        "says": _quoted(heading.says),
        "verdict": _quoted(heading.verdict),
        "hypotheses": ", ".join(_quoted(hypothesis) for hypothesis in heading.hypotheses),
        "expected": ", ".join(_quoted(hypothesis) for hypothesis in heading.expected),
        "signature": _quoted(signature(kernel.program)),
        "operations": _inline_table({op.value: counts[op] for op in Op if counts[op]}),
        "derivation": _quoted(heading.derivation),
        "section": _quoted(heading.section),
        "form": _quoted(heading.form),
        "checks": len(kernel.checks),
        "bound": _bound(kernel.bound),
        "row": [
            _cell(text)
            for text in (cited(heading.number), heading.verdict, assumes, operations(kernel.program).split(":")[0])
        ],
        "code": f"`{signature(kernel.program)}`",
    }


def _bound(bound: Bound | None) -> str:
    """An inline table of what is proved of the errors; empty where that was not asked for."""
    if bound is None:
        return "{}"
    data = bound.as_data()
    guarantees = ", ".join(
        f"{{ {', '.join(f'{key} = {_quoted(value)}' for key, value in item.items())} }}" for item in data["guarantees"]
    )
    program, reason = _quoted(data["program"]), _quoted(data["reason"])
    return f"{{ program = {program}, reason = {reason}, guarantees = [{guarantees}] }}"


def filled(templates: Path, page: Page, origin: Origin, head: tuple[str, ...] = ()) -> str:
    """The page's text. Raises EmissionError where the template is missing, wrong, or asks for what is not there."""
    path = PurePosixPath(page.path)
    if path.is_absolute() or ".." in path.parts or not path.parts:
        raise EmissionError(f"a page's path must lie below the target's folder, not at {page.path!r}")
    try:
        text = layout(templates).get_template(page.template).render({**origin.values, **page.values})
    except TemplateError as error:
        raise EmissionError(f"template {page.template}: {type(error).__name__}: {error}") from error
    comment = _COMMENTS.get(path.suffix, "")
    return "".join(map(comment.format, head if comment else ())) + text


def _require_distinct(names: Iterable[str], what: str) -> None:
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        raise EmissionError(f"several {what} {', '.join(twice)}")


def _quoted(text: str) -> str:
    """A TOML basic string; JSON spells it alike."""
    return json.dumps(text, ensure_ascii=False)


def _inline_table(values: dict[str, int]) -> str:
    """A TOML inline table."""
    return f"{{ {', '.join(f'{key} = {value}' for key, value in values.items())} }}" if values else "{}"


def _cell(text: str) -> str:
    """A text in a Markdown table."""
    return text.replace("|", "\\|")
