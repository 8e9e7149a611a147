"""How does text reach the disk? Every file whole or not at all, and what an earlier emission left is removed."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from difflib import unified_diff
from errno import EISDIR
from pathlib import Path, PurePosixPath
from typing import Literal
from uuid import uuid4

from chasles.targets.emit import MANIFEST
from chasles.targets.kernel import EmissionError

_IGNORED = {"__pycache__", "compiled"}
_SHOWN = 40


@dataclass(frozen=True, slots=True)
class Written:
    """What an emission did: the paths below the root that changed, those removed, and how many stayed as they were."""

    changed: tuple[str, ...]
    removed: tuple[str, ...]
    unchanged: int


@dataclass(frozen=True, slots=True)
class Difference:
    """A file on disk that is not as it would be emitted; `summary` is a unified diff or one sentence."""

    path: str
    kind: Literal["missing", "differs", "superfluous"]
    summary: str


def write(root: Path, texts: Mapping[str, str]) -> Written:
    """Make the files below `root` read as `texts` and remove those that only the manifest there lists.

    Nothing changes where a file cannot be written: every text first goes to a draft beside its place, and only then
    are all moved there, the manifest last. A file that reads as it should is left alone. Raises EmissionError.
    """
    root = Path(root)
    with _reported(f"cannot write the generated files to {root}, nothing was changed"):
        former = [path for path in _listed(root) if path not in texts and (root / path).is_file()]
        wanted: dict[str, bytes | None] = {path: text.encode() for path, text in texts.items()}
        wanted |= dict.fromkeys(former)
        changed = _changed(root, wanted)
    for path in former:
        _remove_empty((root / path).parent, root)
    return Written(
        tuple(sorted(path for path in changed if path in texts)),
        tuple(sorted(former)),
        len(wanted) - len(changed),
    )


def place(root: Path, texts: Mapping[str, str]) -> Written:
    """Make the files below `root` read as `texts`; no other file there changes.

    Nothing changes where a file cannot be written, which raises OSError.
    """
    changed = _changed(Path(root), {path: text.encode() for path, text in texts.items()})
    return Written(tuple(sorted(changed)), (), len(texts) - len(changed))


def stale(root: Path, texts: Mapping[str, str]) -> tuple[Difference, ...]:
    """Every difference between what lies below `root` and `texts`, by path. Raises EmissionError."""
    root = Path(root)
    differences = []
    with _reported(f"cannot read the generated files in {root}"):
        for path, text in texts.items():
            found = _content(root / path)
            if found is None:
                differences.append(Difference(path, "missing", f"{path} is missing"))
            elif found != text.encode():
                differences.append(Difference(path, "differs", _diff(path, found.decode(errors="replace"), text)))
        for path in _present(root):
            if path not in texts:
                differences.append(Difference(path, "superfluous", f"{path} is not among what is emitted; delete it"))
    return tuple(sorted(differences, key=lambda difference: difference.path))


def _changed(root: Path, wanted: Mapping[str, bytes | None]) -> list[str]:
    """The paths whose content was another and is now as wanted, all of them or none."""
    before = {path: _content(root / path) for path in wanted}
    changed = [path for path, content in wanted.items() if before[path] != content]
    changed.sort(key=lambda path: path == MANIFEST)
    _replace(root, {path: wanted[path] for path in changed}, before)
    return changed


def _replace(root: Path, contents: Mapping[str, bytes | None], before: Mapping[str, bytes | None]) -> None:
    """Put every content in its place, None for no file; or leave all places as they were and raise OSError."""
    made: list[Path] = []
    drafts: dict[str, Path] = {}
    moved: list[str] = []
    try:
        for path, content in contents.items():
            if content is not None:
                _make_folder((root / path).parent, made)
                drafts[path] = _drafted(root / path, content)
        for path in contents:
            moved.append(path)
            _settle(root / path, drafts.get(path))
    except BaseException:
        for path in moved:
            with suppress(OSError):
                content = before[path]
                _settle(root / path, None if content is None else _drafted(root / path, content))
        with suppress(OSError):
            for draft in drafts.values():
                draft.unlink(missing_ok=True)
            for folder in reversed(made):
                folder.rmdir()
        raise


def _settle(path: Path, draft: Path | None) -> None:
    """Put the draft in its place, or no file where there is none."""
    if draft is None:
        path.unlink(missing_ok=True)
    else:
        draft.replace(path)


def _drafted(path: Path, content: bytes) -> Path:
    """A new file beside `path` with this content; none is left where that fails."""
    if path.is_dir():
        raise IsADirectoryError(EISDIR, "a folder stands where a file belongs", str(path))
    draft = path.with_name(f".{path.name}.{uuid4().hex}.draft")
    try:
        draft.write_bytes(content)
    except BaseException:
        with suppress(OSError):
            draft.unlink(missing_ok=True)
        raise
    return draft


def _make_folder(folder: Path, made: list[Path]) -> None:
    """Make the folder and those above it; `made` gains each new one."""
    if not folder.is_dir():
        _make_folder(folder.parent, made)
        folder.mkdir()
        made.append(folder)


def _remove_empty(folder: Path, root: Path) -> None:
    """Remove the folder and those above it below `root`, as far as they are empty and can be removed."""
    with suppress(OSError):
        while folder != root and not any(folder.iterdir()):
            folder.rmdir()
            folder = folder.parent


def _content(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _listed(root: Path) -> list[str]:
    """What the manifest on disk lists below the root. A damaged manifest lists nothing, so that emitting repairs it."""
    content = _content(root / MANIFEST)
    try:
        listed = tomllib.loads((content or b"").decode()).get("files", [])
    except (UnicodeDecodeError, tomllib.TOMLDecodeError):
        return []
    paths = [path for path in listed if isinstance(path, str)] if isinstance(listed, list) else []
    return [path for path in paths if not PurePosixPath(path).is_absolute() and ".." not in PurePosixPath(path).parts]


def _present(root: Path) -> Iterator[str]:
    """Every file below the root, but for what Python and `chasles build` put there."""
    for path in sorted(root.rglob("*")):
        if path.is_file() and not _IGNORED & set(path.relative_to(root).parts):
            yield path.relative_to(root).as_posix()


def _diff(path: str, found: str, text: str) -> str:
    """A unified diff from the file to the text, cut where it grows long."""
    names = f"{path} (on disk)", f"{path} (emitted)"
    lines = [*unified_diff(found.splitlines(), text.splitlines(), *names, lineterm="")]
    if len(lines) > _SHOWN:
        lines[_SHOWN:] = [f"... and {len(lines) - _SHOWN} more lines"]
    return "\n".join(lines) or f"{path} differs in its line endings"


@contextmanager
def _reported(what: str) -> Iterator[None]:
    """An OSError inside speaks to the person."""
    try:
        yield
    except OSError as error:
        place = f" ({error.filename})" if error.filename else ""
        raise EmissionError(f"{what}: {error.strerror or error}{place}") from error
