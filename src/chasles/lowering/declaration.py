"""From a declaration and its verdict to a request: the accepted form, with the definitions that it is given."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

from chasles.decisions.session import Decision
from chasles.lowering.cases import Choice, choices_of
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, Request, composed
from chasles.lowering.rewriting import Angle
from chasles.statements import Condition, Entry, Hypothesis, Inverse, Kernel, Packed, Statement, Theorem
from chasles.statements.arrays import argument_name, meaning_of, variants
from chasles.statements.definitions import definitions_behind
from chasles.statements.statement import bare, is_rule
from chasles.verdict import Contradictory, IllFormed, Undecided, Verdict
from chasles.vocabulary import Block, Group, Node, Symbol, members_of, undotted
from chasles.vocabulary.families import indices_of

Sentence = Statement | Theorem | Inverse
Decide = Callable[[Sentence], Decision]


@dataclass(slots=True)
class _Definitions:
    """What the given sentences say of symbols; a rule of a sentence that is not accepted may not be used."""

    rules: dict[Node, Node] = field(default_factory=dict)
    false: dict[Node, str] = field(default_factory=dict)
    choices: list[Choice] = field(default_factory=list)
    angles: dict[Symbol, Angle] = field(default_factory=dict)


def requested(sentence: Entry | Sentence, decide: Decide, kernel: Kernel | None = None) -> Request:
    """The request that a sentence's kernel makes, or that `kernel` makes of it.

    `decide` gives verdicts, as `Session.decide` does. Raises `LoweringError` where the sentence asks for no kernel,
    where neither it nor a correction is accepted, and where the kernel cannot be made of it.
    """
    name = ""
    if isinstance(sentence, Entry):
        name, sentence = sentence.name, sentence.statement
    kernel = kernel or (sentence.kernel and variants(sentence.kernel, name)[0])
    if kernel is None or isinstance(sentence, Theorem):
        raise LoweringError(f"({sentence.number}) asks for no kernel: give it `kernel=Kernel(of=...)`")
    name = kernel.name or name
    if not name:
        raise LoweringError(f"the kernel of ({sentence.number}) has no name: give it one, or lower a chapter's entry")
    if not decide(sentence).stands:
        raise LoweringError(f"{name}: {_not_accepted(sentence, decide(sentence))}")
    definitions = _Definitions()
    for given in sentence.given:
        _define(definitions, given, decide)
    for given in definitions_behind(sentence.given):
        if bare(given.left) not in definitions.rules:
            _define(definitions, given, decide)
    if isinstance(sentence, Inverse):
        _define(definitions, sentence, decide)
        outputs = _outputs_of_inverse(name, sentence, kernel)
    else:
        outputs = _outputs(name, *decide(sentence).sides, kernel)
    request = composed(
        name,
        kernel.of,
        outputs,
        rules=definitions.rules,
        hypotheses=tuple(dict.fromkeys(_hypotheses(sentence))),
        choices=definitions.choices,
        angles=definitions.angles,
        form=_form(kernel),
    )
    used = next((left for left, _ in request.rules if left in definitions.false), None)
    if used is not None:
        raise LoweringError(f"{name} rests on a statement that is not accepted: {definitions.false[used]}")
    return request


def _not_accepted(sentence: Sentence, decision: Decision) -> str:
    """Why no form of the sentence may be used, in one line."""
    said = f"({sentence.number}) {_words(decision.verdict, 'as printed')}"
    if decision.correction is None:
        return f"{said}; no correction is declared or found"
    return f"{said}; its {decision.correction.form} form {_words(decision.correction.verdict)}"


def _words(verdict: Verdict, which: str = "") -> str:
    said = verdict.name if verdict.name == "fails" else f"is {verdict.name}"
    said = f"{said} {which}".rstrip()
    return f"{said} ({verdict.reason})" if isinstance(verdict, Undecided | IllFormed | Contradictory) else said


def _define(definitions: _Definitions, given: Sentence, decide: Decide) -> None:
    """Add what a given sentence says of symbols."""
    decision = decide(given)
    if isinstance(given, Inverse):
        if not decision.stands:
            raise LoweringError(_not_accepted(given, decision))
        choices, rules, angles = choices_of(given, largest=given.largest, sign=given.sign)
        definitions.choices += choices
        definitions.rules |= rules
        definitions.angles |= angles
        return
    if isinstance(given, Condition | Theorem):
        return
    left, right = decision.sides
    pairs = [(bare(left), right)] if is_rule(given) else members_of(left, right) if indices_of(left) else []
    for one, other in pairs:
        if definitions.rules.setdefault(one, other) != other:
            raise LoweringError(f"two given statements say what {one} is, one is ({given.number}): name one of them")
        if not decision.stands:
            definitions.false[one] = _not_accepted(given, decision)


def _hypotheses(sentence: Sentence) -> Iterator[Hypothesis]:
    """What the sentence and all that it rests on assume."""
    yield from sentence.assuming
    for given in sentence.given:
        yield from _hypotheses(given)


def _outputs(name: str, left: Node, right: Node, kernel: Kernel) -> list[Output]:
    """The right side, or its blocks where several results are named; what the kernel calls symmetric is packed."""
    if len(kernel.results) > 1:
        sides = [_lines(side) for side in (left, right)]
        if len(sides[1]) != len(kernel.results):
            raise LoweringError(
                f"{name}: {len(kernel.results)} results are named, and the right side has {len(sides[1])} blocks"
            )
        said = sides[0] if len(sides[0]) == len(sides[1]) else sides[1]
        triples = zip(kernel.results, said, sides[1], strict=True)
        return [_output(word, of, value, kernel) for word, of, value in triples]
    left = bare(left)
    word = (
        kernel.results[0]
        if kernel.results
        else argument_name(left)
        if isinstance(undotted(left)[0], Symbol)
        else "result"
    )
    return [_output(word, left, right, kernel)]


def _output(word: str, left: Node, value: Node, kernel: Kernel) -> Output:
    packed = left in kernel.symmetric
    return Output(word, meaning_of(Packed(left) if packed else left), value, packed)


def _outputs_of_inverse(name: str, sentence: Inverse, kernel: Kernel) -> list[Output]:
    words = kernel.results or tuple(map(argument_name, sentence.gives))
    if len(words) != len(sentence.gives):
        raise LoweringError(f"{name}: {len(words)} results are named, and the inverse gives {len(sentence.gives)}")
    return [Output(word, meaning_of(node), node) for word, node in zip(words, sentence.gives, strict=True)]


def _form(kernel: Kernel) -> list[Node]:
    if kernel.form is None:
        return []
    return _lines(kernel.form) if len(kernel.results) > 1 else [kernel.form]


def _lines(node: Node) -> list[Node]:
    """The rows of blocks of a matrix of blocks."""
    while isinstance(node, Group):
        node = node.of
    if not isinstance(node, Block):
        return [node]
    return [row[0] if len(row) == 1 else Block((row,)) for row in node.rows]
