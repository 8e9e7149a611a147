"""`chasles read` in an editor, in a hook and on GitHub: what they are told, and with which status."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest
import yaml
from click.testing import CliRunner, Result

from chasles.cli import main

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples" / "reading"
pytestmark = pytest.mark.skipif(not EXAMPLE.exists(), reason="needs the checkout")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(EXAMPLE, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def read(*words: str) -> Result:
    return CliRunner().invoke(main, ["read", *words], prog_name="chasles")


def test_the_problem_matcher_finds_file_and_line(folder: Path) -> None:
    (task,) = json.loads((folder / "tasks.json").read_text("utf-8"))["tasks"]
    words = task["command"].replace('"${file}"', "page.md").split()
    assert words[:2] == ["chasles", "read"]
    (line,) = read(*words[2:]).stdout.splitlines()
    pattern = task["problemMatcher"]["pattern"]
    found = re.match(pattern["regexp"], line)
    assert found
    assert [found[pattern[each]] for each in ("file", "line")] == ["page.md", "10"]
    assert found[pattern["message"]].startswith("(4) fails: ")


def test_annotations_of_github(folder: Path) -> None:
    (line,) = read("page.md", "--notation", "notation.toml", "--github").stdout.splitlines()
    assert line.startswith("::error file=page.md,line=10,col=1::(4) fails: ")
    page = (folder / "page.md").read_text("utf-8") + "\n$$\\mathbf{Q} \\boxplus 2 = 100\\% $$\n"
    (folder / "a,b.md").write_text(page, "utf-8")
    last = read("a,b.md", "--notation", "notation.toml", "--github").stdout.splitlines()[-1]
    assert last.startswith("::warning file=a%2Cb.md,line=13,col=")


@pytest.mark.parametrize(("words", "status"), [((), 0), (("--strict",), 1)])
def test_a_wrong_equation_fails_where_it_is_to(folder: Path, words: tuple[str, ...], status: int) -> None:
    done = read("page.md", "--notation", "notation.toml", *words)
    assert done.exit_code == status
    page = (folder / "page.md").read_text("utf-8")
    (folder / "page.md").write_text(page.replace("1 - 2", "1 + 2"), "utf-8")
    assert read("page.md", "--notation", "notation.toml", *words).exit_code == 0


def test_several_pages(folder: Path) -> None:
    shutil.copy(folder / "page.md", folder / "other.md")
    done = read("page.md", "other.md", "--notation", "notation.toml", "--quiet")
    assert [line.partition(":")[0] for line in done.stdout.splitlines()] == ["page.md", "other.md"]
    done = read("page.md", "other.md", "--notation", "notation.toml", "--json")
    assert [page["file"] for page in json.loads(done.stdout)] == ["page.md", "other.md"]


def test_files_that_a_page_includes(folder: Path) -> None:
    (folder / "inner.tex").write_text("\n$$\\mathbf{e}^T\\mathbf{e} = 2$$", "utf-8")
    (folder / "outer.tex").write_text("\\input{inner}", "utf-8")
    done = read("outer.tex", "--notation", "notation.toml")
    assert "0 displayed" in done.stdout
    assert "outer.tex: no displayed equation; --inline reads" in done.stderr
    assert read("outer.tex", "--notation", "notation.toml", "--input").stdout.startswith("inner.tex:2: fails")
    (folder / "inner.tex").write_text("\\input{outer}", "utf-8")
    done = read("outer.tex", "--notation", "notation.toml", "--input")
    assert (done.exit_code, "includes itself" in done.stderr) == (2, True)


def test_the_hook_is_a_command_that_there_is(folder: Path) -> None:
    (hook,) = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
    _, _, *words = hook["entry"].split()
    assert re.search(hook["files"], "page.md")
    assert read(*words, *hook["args"], "page.md").exit_code == 1
    (local,) = yaml.safe_load((folder / "pre-commit-config.yaml").read_text("utf-8"))["repos"]
    assert local["hooks"][0]["entry"].split() == [*hook["entry"].split(), *hook["args"]]


def test_a_report_with_the_findings_in_the_margin(folder: Path) -> None:
    page = (folder / "page.md").read_text("utf-8")
    hostile = "\n$$\\href{javascript:alert(1)}{\\mathbf{Q}} = \\text{<script>alert(2)</script>}$$\n"
    (folder / "page.md").write_text(page + hostile, "utf-8")
    read("page.md", "--notation", "notation.toml", "--html", "found.html")
    html = (folder / "found.html").read_text("utf-8")
    assert (html.count("<article>"), html.count('<aside class="fine">'), html.count('<aside class="wrong">')) == (
        5,
        3,
        1,
    )
    assert "(4) fails: at cos(phi) = -1" in html
    assert html.count("<math") == 4
    assert "<script" not in html
    assert 'href="' not in html
    done = read("page.md", "page.md", "--notation", "notation.toml", "--html", "found.html")
    assert (done.exit_code, "name one page" in done.stderr) == (2, True)
