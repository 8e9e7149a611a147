"""Kernels as theorems: what they say is what their programs do, Coq accepts that, and not what another program does."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

from chasles.coq.checking import MISSING, coq_version, verdicts_of_coq
from chasles.coq.folder import chunks
from chasles.coq.kernels import claim_of_kernel, kernels_of
from chasles.coq.names import identifier
from chasles.coq.recorded import RECORD
from chasles.coq.sentences import Claimed
from chasles.decisions.decision import key_of
from chasles.decisions.session import Session
from chasles.lowering.arithmetic import decimals, evaluated
from chasles.lowering.declaration import requested
from chasles.lowering.lower import program_of
from chasles.lowering.program import Op, Program, Step
from chasles.lowering.request import Request
from chasles.statements import load
from chasles.statements.fingerprint import Fingerprints

from .decided import chapter_session
from .sampling import WHOLE, sample

BRANCHES = "a program that chooses between cases"
WITHOUT = {
    "chasles.derivations": ("euler_rodrigues_parameters", "natural_invariants", "screw_of_motion"),
    "chasles.rotations": ("euler_rodrigues_parameters",),
}
"""The kernels of which there is no theorem: they choose between the branches of an inverse."""
SOME = 4 if WHOLE else 2
"""So many kernels are shown to Coq, those with the shortest proofs."""
DEFINED = re.compile(r"^  (s_\d+) = (.*) ->$", re.MULTILINE)
ENTRY = re.compile(r"entry (?:\(length_of_\w+ \*: direction_of_)?(\w+)\)? (\d) (\d)")


@cache
def asked() -> tuple[tuple[str, Request, Program], ...]:
    """Some kernels of the chapter and one of rotation vectors, with their programs."""
    session = chapter_session()
    pairs = [(session, entry, kernel) for entry in load() for kernel in entry.kernels]
    other, turned = Session(book=load("chasles.rotations")), ("quaternion_from_vector",)
    vectors = [(other, e, k) for e in load("chasles.rotations") for k in e.kernels if k.name in turned]
    found = [(key_of(e.statement), requested(e, s.decide, kernel)) for s, e, kernel in (*sample(pairs, 4), *vectors)]
    return tuple((key, request, program_of(request)) for key, request in found)


def claims() -> Iterator[tuple[Claimed, Request, Program]]:
    """What is said of them."""
    for key, request, program in asked():
        yield claim_of_kernel(key, request, program)[0], request, program


def test_what_is_said_of_each_step_is_what_the_program_does() -> None:
    compared = 0
    for claim, request, program in claims():
        if not claim.proof or "during T" in claim.said:
            continue
        known: dict[Any, float] = {}
        inputs: dict[tuple[int, int], Any] = {}
        for step in program.steps:
            if step.op is Op.INPUT:
                node, i, j = request.place(step.argument, step.entry)
                value = known.setdefault((identifier(node.name), i, j), 0.3 + 7 * len(known) % 11 / 7)  # type: ignore[attr-defined]
                inputs[step.argument, step.entry] = decimals(20).context.mpf(value)
        scope = {name: value for (name, *_), value in known.items()} | vars(__import__("math"))
        values = evaluated(program.steps, decimals(20), lambda argument, entry: inputs[argument, entry])  # noqa: B023
        scale = {f"s_{k}": float(v) for k, v in enumerate(values) if program.steps[k].op is Op.SELECT}
        for name, text in DEFINED.findall(claim.said):
            told = ENTRY.sub(lambda m: repr(known[m[1], int(m[2]), int(m[3])]), text).replace("^", "**")  # noqa: B023
            told = re.sub(r"\b(cos|sin|sqrt) ([\w.]+)", r"\1(\2)", told)
            scope[name] = eval(told, scope | scale)
            assert scope[name] == pytest.approx(float(values[int(name[2:])]), rel=1e-12), (claim.name, name, text)
            compared += 1
    assert compared > 100


def changed(program: Program) -> Program:
    """The program with a sum in place of its last difference, or the other way round."""
    last = max(k for k, step in enumerate(program.steps) if step.op in (Op.ADD, Op.SUBTRACT))
    step = program.steps[last]
    other = replace(step, op=Op.SUBTRACT if step.op is Op.ADD else Op.ADD)
    return replace(program, steps=(*program.steps[:last], other, *program.steps[last + 1 :]))


def test_of_another_program_there_is_no_proof() -> None:
    refused = 0
    for claim, request, program in claims():
        if claim.proof and any(step.op in (Op.ADD, Op.SUBTRACT) for step in program.steps):
            mutant, _ = claim_of_kernel(claim.number, request, changed(program))
            assert not mutant.proof, claim.name
            assert mutant.why_not
            refused += 1
    assert refused > 10


def test_of_a_program_that_always_divides_by_zero_nothing_is_claimed() -> None:
    """What it divides by is assumed not to be zero: of what contradicts itself everything would follow."""
    key, request, program = next(each for each in asked() if Op.DIVIDE in each[2].operations)
    last = max(k for k, step in enumerate(program.steps) if step.op is Op.DIVIDE)
    above, below = program.steps[last].operands
    steps = (*program.steps[:last], Step(Op.SUBTRACT, (below, below)), Step(Op.DIVIDE, (above, last)))
    [result, *others] = program.results
    result = replace(result, entries=tuple(last + 1 for _ in result.entries))
    others = [replace(each, entries=tuple(last + 1 for _ in each.entries)) for each in others]
    claim, _ = claim_of_kernel(key, request, replace(program, steps=steps, results=(result, *others)))
    assert not claim.proof


@pytest.mark.skipif(coq_version() is None, reason=MISSING)
def test_coq_accepts_what_a_program_does_and_not_what_another_does(
    coq_cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CHASLES_CACHE", str(coq_cache))
    some = sorted((each for each in claims() if each[0].proof), key=lambda each: len(each[0].proof))[:SOME]
    mutants = []
    for claim, request, program in some:
        if any(step.op in (Op.ADD, Op.SUBTRACT) for step in program.steps):
            said = claim_of_kernel(claim.number, request, changed(program))[0].said
            name = f"mutant_{claim.name}"
            proof = claim.proof.replace(claim.name, name)
            mutants.append(replace(claim, name=name, said=said.replace(claim.name, name), proof=proof))
    mutants = mutants if WHOLE else mutants[:1]
    parts = chunks([*mutants, *(claim for claim, *_ in some)])
    found = {each.claim.name: each.accepted for each in verdicts_of_coq(parts)}
    assert mutants
    assert found == {claim.name: claim not in mutants for claim in (*(claim for claim, *_ in some), *mutants)}


@pytest.mark.parametrize("chapter", WITHOUT)
def test_each_kernel_is_in_the_record_as_it_is_or_there_is_a_reason(chapter: str) -> None:
    """By its fingerprint: of the declaration, and of all steps of the program."""
    kept = json.loads(files(chapter).joinpath(RECORD).read_text("utf-8"))["kernels"]
    names = {kernel.name for entry in load(chapter) for kernel in entry.kernels}
    assert names - kept.keys() == {*WITHOUT[chapter]}, "`make coq` brings the record up to date"
    session = Session(book=load(chapter))
    prints = Fingerprints()
    for claim, problem in kernels_of(sample(load(chapter), 8, first=3), session.decide):
        if claim.kernel in WITHOUT[chapter]:
            assert BRANCHES in claim.why_not
        else:
            assert problem is not None
            assert prints.of(problem) == kept[claim.kernel]["declared"], "`make coq` brings the record up to date"
