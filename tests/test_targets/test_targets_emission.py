"""Emitting is deterministic, whole or not at all, and says what is stale."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import tomllib
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

import chasles.targets
from chasles.targets import EmissionError, Page, Target, TargetKernel, discover, render, stale, write

ROOM = Path(chasles.targets.__file__).parent


def content(root):
    return {path.relative_to(root).as_posix(): path.read_bytes() for path in root.rglob("*") if path.is_file()}


@pytest.mark.slow
def test_two_hash_seeds_give_the_same_bytes(texts, tmp_path):
    script = (
        "import importlib.util, pathlib, sys\n"
        f"spec = importlib.util.spec_from_file_location('made', {str(Path(__file__).parent / 'conftest.py')!r})\n"
        "made = importlib.util.module_from_spec(spec)\n"
        "spec.loader.exec_module(made)\n"
        "from chasles.targets import discover, render, write\n"
        "kernels = [made.kernel_of(name) for name in made.PROGRAMS]\n"
        "write(pathlib.Path(sys.argv[1]), render(kernels, discover()))\n"
    )
    for seed in ("0", "1"):
        environment = os.environ | {"PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
        subprocess.run([sys.executable, "-c", script, tmp_path / seed], check=True, env=environment)
    expected = {path: text.encode() for path, text in texts.items()}
    assert content(tmp_path / "0") == content(tmp_path / "1") == expected


def test_generated_text_is_tidy_and_tells_its_command(texts):
    for path, text in texts.items():
        assert not re.search(r"[ \t]+$", text, re.M), path
        assert text.endswith("\n"), path
        assert not text.endswith("\n\n"), path
        assert "chasles emit" in text[:500], path
        assert max(map(len, text.splitlines())) <= 130 or path in ("README.md", "MANIFEST.toml"), path


def test_python_text_is_python_without_in_place_writes(texts):
    compile(texts["__init__.py"], "__init__.py", "exec")
    for path, text in texts.items():
        if path.endswith(".py"):
            compile(text, path, "exec")
    assert not re.search(r"\] (=|\+=) ", texts["numpy/kernels.py"])


def test_templates_hold_layout_only():
    """No tag but for; an output names a thing and does nothing to it."""
    templates = sorted(ROOM.rglob("*.jinja"))
    assert len(templates) >= 10
    for template in templates:
        text = template.read_text()
        for tag in re.findall(r"\{%-?\s*(.*?)\s*-?%\}", text, re.S):
            assert re.fullmatch(r"endfor|for \w+ in [a-z_]+(\.[a-z_]+)*", tag), f"{template.name}: {tag}"
        for output in re.findall(r"\{\{-?\s*(.*?)\s*-?\}\}", text, re.S):
            assert re.fullmatch(r"[a-z_]+(\.[a-z_]+)*", output), f"{template.name}: {output}"


def test_the_manifest_lists_kernels_and_files(texts, kernels):
    manifest = tomllib.loads(texts["MANIFEST.toml"])
    assert sorted(manifest["files"]) == sorted(set(texts) - {"MANIFEST.toml"})
    assert list(manifest["kernels"]) == [kernel.name for kernel in kernels]
    entry = manifest["kernels"]["rotation_from_axis_angle"]
    assert entry["operations"] == {"add": 6, "subtract": 4, "multiply": 12, "sine": 1, "cosine": 1}
    assert (entry["number"], entry["verdict"], entry["hypotheses"]) == ("3.18", "holds under", ["|e| = 1", "phi != 0"])
    assert entry["signature"] == "(3),()->(3,3)"
    assert entry["derivation"] == kernels[0].heading.derivation


def test_no_kernels_is_no_error(tmp_path):
    texts = render([], discover())
    write(tmp_path, texts)
    assert stale(tmp_path, texts) == ()


def test_kernels_of_one_name_are_refused(kernels):
    with pytest.raises(EmissionError, match="rotation_from_axis_angle"):
        render([kernels[0], kernels[1], kernels[0]], discover())


def test_c_functions_of_one_name_are_refused(kernels, builder):
    line = builder("rotation_from_axis_anglef", x=())
    (x,) = line.inputs()
    clash = TargetKernel(line.program(y=x), kernels[0].heading)
    with pytest.raises(EmissionError, match=r"target c: .*chasles_rotation_from_axis_anglef"):
        render([kernels[0], clash], discover())


@pytest.mark.parametrize("path", ["../x", "/x", ""])
def test_a_page_stays_in_its_folder(path, tmp_path):
    (tmp_path / "x.jinja").write_text("x\n")
    with pytest.raises(EmissionError, match="below the target's folder"):
        render([], [Target("wild", tmp_path, lambda kernels: [Page(path, "x.jinja", {})])])


@pytest.mark.parametrize("template", ["{{ missing }}", "{{ kernels.nothing }}", "{% for %}"])
def test_a_template_that_asks_for_what_is_not_there_is_an_error(template, tmp_path):
    (tmp_path / "x.jinja").write_text(template)
    with pytest.raises(EmissionError, match=r"target odd: template x\.jinja"):
        render([], [Target("odd", tmp_path, lambda kernels: [Page("x", "x.jinja", {"kernels": kernels})])])


def test_writing_again_changes_nothing(texts, tmp_path):
    first = write(tmp_path / "new" / "generated", texts)
    assert (first.changed, first.removed, first.unchanged) == (tuple(sorted(texts)), (), 0)
    again = write(tmp_path / "new" / "generated", texts)
    assert (again.changed, again.removed, again.unchanged) == ((), (), len(texts))
    assert stale(tmp_path / "new" / "generated", texts) == ()


def test_what_an_earlier_emission_left_is_removed_and_nothing_else(texts, kernels, tmp_path):
    write(tmp_path, texts)
    (tmp_path / "c/src/mine.c").write_text("int mine;\n")
    fewer = render([kernels[0]], [target for target in discover() if target.name == "c"])
    done = write(tmp_path, fewer)
    assert set(done.removed) == set(texts) - set(fewer)
    assert set(content(tmp_path)) == {*fewer, "c/src/mine.c"}
    assert not (tmp_path / "numpy").exists()
    assert [(found.path, found.kind) for found in stale(tmp_path, fewer)] == [("c/src/mine.c", "superfluous")]


def test_a_manifest_from_elsewhere_removes_nothing_outside(texts, tmp_path):
    (tmp_path / "kept").write_text("kept")
    root = tmp_path / "generated"
    for manifest in (f'files = ["../kept", "{tmp_path}/kept", 3]\n', "<<<<<<< ours", "files = 3\n"):
        write(root, texts)
        (root / "MANIFEST.toml").write_text(manifest)
        assert write(root, texts).changed == ("MANIFEST.toml",)
    assert (tmp_path / "kept").exists()


def test_stale_says_what_differs(texts, tmp_path):
    write(tmp_path, texts)
    source = tmp_path / "c/src/s01_rotation.c"
    source.write_text(source.read_text().replace("sin_phi", "sine"))
    (tmp_path / "numpy/kernels.py").unlink()
    (tmp_path / "numpy/__pycache__").mkdir()
    (tmp_path / "numpy/__pycache__/kernels.pyc").write_bytes(b"")
    (tmp_path / "README.md").write_bytes(texts["README.md"].replace("\n", "\r\n").encode())
    found = {difference.path: difference for difference in stale(tmp_path, texts)}
    assert {path: found[path].kind for path in found} == {
        "README.md": "differs",
        "c/src/s01_rotation.c": "differs",
        "numpy/kernels.py": "missing",
    }
    summary = found["c/src/s01_rotation.c"].summary
    assert "-    const double sine = sin(phi);" in summary
    assert "+    const double sin_phi = sin(phi);" in summary
    assert "line endings" in found["README.md"].summary
    assert {difference.kind for difference in stale(tmp_path / "nowhere", texts)} == {"missing"}


def test_a_long_difference_is_cut(texts, tmp_path):
    write(tmp_path, texts)
    (tmp_path / "numpy/kernels.py").write_text("")
    (difference,) = stale(tmp_path, texts)
    assert len(difference.summary.splitlines()) <= 41
    assert "more lines" in difference.summary


@contextmanager
def as_nobody():
    """Without the rights of root, which no read-only folder stops."""
    if os.geteuid() != 0:
        yield
        return
    os.seteuid(65534)
    try:
        yield
    finally:
        os.seteuid(0)


@pytest.fixture
def open_folder():
    """A folder that anyone may enter, as pytest's own are not."""
    with tempfile.TemporaryDirectory() as name:
        Path(name).chmod(0o755)
        yield Path(name)


def test_a_read_only_folder_is_one_clear_error_and_nothing_changes(texts, kernels, open_folder):
    write(open_folder, render(kernels[:1], discover()))
    before = content(open_folder)
    for path in sorted(open_folder.rglob("*")):
        path.chmod(0o555 if path.is_dir() else 0o444)
    open_folder.chmod(0o555)
    with as_nobody():
        with pytest.raises(EmissionError) as caught:
            write(open_folder, texts)
        assert write(open_folder, render(kernels[:1], discover())).changed == ()
    open_folder.chmod(0o755)
    assert str(open_folder) in str(caught.value)
    assert "Permission denied" in str(caught.value)
    assert "nothing was changed" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert content(open_folder) == before


def test_one_read_only_subfolder_keeps_all_else_as_it_was(texts, kernels, open_folder):
    write(open_folder, render(kernels[:1], discover()))
    for path in open_folder.rglob("*"):
        path.chmod(0o777 if path.is_dir() else 0o666)
    open_folder.chmod(0o777)
    (open_folder / "numpy").chmod(0o555)
    before = content(open_folder)
    with as_nobody(), pytest.raises(EmissionError, match="numpy"):
        write(open_folder, texts)
    assert content(open_folder) == before


def test_a_place_that_is_taken_keeps_all_as_it_was(texts, tmp_path):
    (tmp_path / "generated/numpy/kernels.py").mkdir(parents=True)
    with pytest.raises(EmissionError, match=r"numpy/kernels\.py"):
        write(tmp_path / "generated", texts)
    assert content(tmp_path) == {}
    assert not (tmp_path / "generated/c").exists()
    (tmp_path / "file").write_text("")
    with pytest.raises(EmissionError, match="file"):
        write(tmp_path / "file" / "generated", texts)


def test_whatever_fails_whenever_it_fails_nothing_is_half_written(texts, kernels, tmp_path, monkeypatch):
    """Every single call that touches the disk fails once; each time all is as it was before."""
    write(tmp_path, render(kernels[:2], discover()))
    (tmp_path / "numpy/kernels.py").unlink()
    before, folders = content(tmp_path), sorted(path for path in tmp_path.rglob("*") if path.is_dir())
    more = {path: text for path, text in texts.items() if path != "c/src/s02_screw.c"} | {"new/deep/file": "x"}
    failures, calls = 0, 0
    for failing in range(1, 200):
        calls = 0

        def counted(original, failing=failing):
            def call(*arguments, **options):
                nonlocal calls
                calls += 1
                if calls == failing:
                    raise OSError(28, "No space left on device", str(arguments[0]))
                return original(*arguments, **options)

            return call

        with monkeypatch.context() as patch:
            for name in ("write_bytes", "replace", "unlink", "mkdir"):
                patch.setattr(Path, name, counted(getattr(Path, name)))
            with suppress(EmissionError):
                write(tmp_path, more)
                break
        failures += 1
        assert content(tmp_path) == before, failing
        assert sorted(path for path in tmp_path.rglob("*") if path.is_dir()) == folders, failing
    assert failures >= 2 * len([path for path in more if more[path].encode() != before.get(path)])
    assert stale(tmp_path, more) == ()
