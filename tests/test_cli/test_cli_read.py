"""`chasles read`: a page with planted slips, its notation, and what is said of each equation."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import chasles
from chasles.cli import main

NOTATION = r"""
[operators]
skew = ['\tilde{#}']
transpose = ['#^T']
identity = ['\mathbf{1}']
trace = ['\operatorname{tr}(#)']
[symbols]
'\mathbf{Q}' = { is = "rotation" }
'\mathbf{e}' = { is = "unit vector" }
'\mathbf{a}' = { is = "vector" }
'\mathbf{b}' = { is = "vector" }
'\mathbf{c}' = { is = "vector" }
'\phi' = { is = "angle" }
"""
PAGE = r"""# Rotations

$$\mathbf{Q} = \mathbf{e}\mathbf{e}^T + \cos\phi (\mathbf{1} - \mathbf{e}\mathbf{e}^T) + \sin\phi \tilde{\mathbf e} \quad (1)$$

$$\mathbf{Q}\mathbf{e} = \mathbf{e} \quad (2)$$

$$\mathbf{Q}^T\mathbf{Q} = \mathbf{1} \quad (3)$$

$$\operatorname{tr}(\mathbf{Q}) = 1 - 2\cos\phi \quad (4)$$

$$\tilde{\mathbf a}\mathbf b = \mathbf b \times \mathbf a \quad (5)$$

$$\mathbf{a}\times\mathbf b = \mathbf Q \boxplus 2 \quad (6)$$

$$\mathbf c = \mathbf Q + \mathbf a \quad (7)$$

$$\mathbf a\cdot \mathbf b = 0 \quad (8)$$
"""  # noqa: E501
SAID = [
    "3: (1) defines Q",
    "5: (2) holds under |e| = 1",
    "7: (3) holds under Q is a rotation",
    "9: (4) fails: at ",
    "11: (5) fails: at ",
    "13: (6) unread: no word for \\boxplus",
    "15: (7) ill-formed: cannot add Q (3 x 3) and a (3 x 1)",
    "17: (8) open: does not follow from what the page says before",
]


def run(folder: Path, *words: str, page: str = PAGE, notation: str = NOTATION) -> Result:
    (folder / "page.md").write_text(page, "utf-8")
    (folder / "page.toml").write_text(notation, "utf-8")
    call = ["read", str(folder / "page.md"), "--notation", str(folder / "page.toml"), *words]
    return CliRunner().invoke(main, call, prog_name="chasles")


def test_each_finding_is_a_line_that_editors_understand(tmp_path: Path) -> None:
    done = run(tmp_path)
    *lines, summary = done.stdout.splitlines()
    assert [
        line.removeprefix(f"{tmp_path}/page.md:")[: len(said)] for line, said in zip(lines, SAID, strict=True)
    ] == SAID
    assert lines[3].endswith(r"instead: \operatorname{tr}(\mathbf{Q}) = 1 + 2 \cos \phi")
    assert lines[4].endswith(r"instead: \tilde{\mathbf{a}} \mathbf{b} = -\mathbf{b} \times \mathbf{a}")
    assert summary.startswith("8 displayed equations, 8 equalities: 7 read, 6 decided")
    assert done.exit_code == 1
    quiet = run(tmp_path, "--quiet").stdout.splitlines()
    assert quiet == lines[3:]


def test_the_records_say_the_same(tmp_path: Path) -> None:
    done = run(tmp_path, "--json")
    found = json.loads(done.stdout)
    verdicts = [each["verdict"] for each in found["equations"]]
    assert verdicts == ["defined", "holds-under", "holds-under", "fails", "fails", "unread", "ill-formed", "open"]
    assert found["counts"]["decided"] == 6
    assert found["equations"][1]["given"] == ["1"]
    assert found["equations"][4]["counterexample"]["lhs"] != found["equations"][4]["counterexample"]["rhs"]
    assert run(tmp_path, "--json").stdout == done.stdout


def test_a_page_on_which_all_is_decided_ends_well(tmp_path: Path) -> None:
    page = PAGE.replace(r"\mathbf Q \boxplus 2", r"-\mathbf b \times \mathbf a")
    done = run(tmp_path, page=page.split("$$\\mathbf a\\cdot")[0])
    assert done.exit_code == 0, done.stdout


@pytest.mark.parametrize(
    ("roles", "verdict"),
    [
        ("", "open"),
        ("[equations]\n'8' = { role = 'law' }", "assumed"),
        ("[equations]\n'8' = { role = 'claim' }", "fails"),
    ],
)
def test_a_person_says_what_an_open_equation_is(tmp_path: Path, roles: str, verdict: str) -> None:
    found = json.loads(run(tmp_path, "--json", notation=NOTATION + roles).stdout)
    assert found["equations"][-1]["verdict"] == verdict


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["read", "no.md", "--notation", "chasles.derivations.notation"], "cannot read no.md"),
        (["read", "page.pdf", "--notation", "chasles.derivations.notation"], "page.pdf"),
        (["read", "page.md"], "--notation"),
        (["read", "page.md", "--notation", "no.toml"], "no.toml"),
        (["read", "page.md", "--notation", "no_such_module"], "no_such_module"),
    ],
)
def test_what_is_wrong_with_the_input_is_said_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, words: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("page.md").write_text(PAGE, "utf-8")
    done = CliRunner().invoke(main, words, prog_name="chasles")
    assert done.exit_code == 2
    assert said in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_one_equation_alone_is_read_in_python() -> None:
    page = chasles.read(r"\mathbf a \times \mathbf b = -\mathbf b \times \mathbf a", NOTATION)
    assert [each.verdict for each in page.equations] == ["holds"]
    assert len(page.chapter.entries) == 1
    assert chasles.read(PAGE, NOTATION).counts["decided"] == 6


def test_questions_are_asked_once_and_answers_are_kept(tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert run(tmp_path, "--out", str(out)).exit_code == 1
    asked = (out / "questions.toml").read_text("utf-8")
    assert '["8"]\nrole = ""' in asked
    assert r"\boxplus" in (out / "unread.md").read_text("utf-8")
    (out / "questions.toml").write_text(asked.replace('role = ""', 'role = "law"'), "utf-8")
    found = json.loads(run(tmp_path, "--json", "--out", str(out)).stdout)
    assert found["equations"][-1]["verdict"] == "assumed"
    written = {file.name: file.read_bytes() for file in out.iterdir()}
    run(tmp_path, "--out", str(out))
    assert {file.name: file.read_bytes() for file in out.iterdir()} == written
    assert b'role = "law"' in written["questions.toml"]
    (out / "questions.toml").write_text("role = [", "utf-8")
    done = run(tmp_path, "--out", str(out))
    assert done.exit_code == 2
    assert "questions.toml" in done.stderr


def test_a_first_notation_is_proposed(tmp_path: Path) -> None:
    done = run(tmp_path, "--propose")
    assert done.exit_code == 0
    assert r"\mathbf{Q}" in done.stdout or r"\mathbf Q" in done.stdout


def test_a_notebook_shows_a_page() -> None:
    page = chasles.read(r"\mathbf a \times \mathbf b = -\mathbf b \times \mathbf a", NOTATION)
    for shown in (page, page.equations[0]):
        assert "holds" in shown._repr_html_()
        assert "holds" in shown._repr_text_()
