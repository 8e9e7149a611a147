"""Edits inside the definitions of symbols on the right side, block by block.

Arrays are opened to their blocks. A block may be wrong or missing; one that is missing in an array that occurs several
times, as P does in P P^T, is put in wherever the array occurs.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace as with_fields

from chasles.repairs.modular_testing import ModularTest
from chasles.repairs.one_term import Change, instead, new_coefficients
from chasles.rewriting.places import everywhere
from chasles.rewriting.term_basis import TermBasis, fit
from chasles.vocabulary import Block, Identity, Negative, Node, Zero, plain, printed, replace
from chasles.vocabulary.tree import with_parts


def block_edits(test: ModularTest, basis: TermBasis) -> Iterator[Change]:
    """The right sides, arrays opened, that are true with one other block, or with that and a block put in."""
    rules = dict(test.problem.rules)
    right = _opened(test.right, rules)
    if right == test.right:
        return
    names = {_opened(letter, rules): f"{plain(letter)} = " for letter in reversed(rules)}
    one_block = list(new_coefficients(test.of(right)))
    yield from one_block
    for array, other in () if one_block else _completed(right, [*basis.nodes, *_blocks(_opened(test.left, rules))]):
        new = _replaced(right, array, other)
        words = names.get(array, "") + instead(other, array)
        if fit(test.left, new):
            for change in new_coefficients(test.of(new)):
                more = () if change.right == new else change.words
                yield with_fields(change, words=(words, *more))


def _replaced(node: Node, old: Node, new: Node) -> Node:
    return printed(lambda: replace(node, {old: new}))


def _opened(node: Node, rules: Mapping[Node, Node]) -> Node:
    """The expression with arrays of blocks in place of the letters that stand for them."""
    if node in rules:
        body = _opened(rules[node], rules)
        return body if isinstance(body, Block) else node
    return with_parts(node, lambda part: _opened(part, rules))


def _completed(node: Node, fillings: Sequence[Node]) -> Iterator[tuple[Block, Block]]:
    """Arrays that occur several times, and the same with something in the place of a zero block."""
    arrays = [part for _, part in everywhere(node) if isinstance(part, Block)]
    for array in dict.fromkeys(array for array in arrays if arrays.count(array) > 1):
        for i, row in enumerate(array.rows):
            for j, block in enumerate(row):
                if isinstance(block, Zero):
                    for new in _fillings(block, fillings):
                        line = (*row[:j], new, *row[j + 1 :])
                        yield array, Block((*array.rows[:i], line, *array.rows[i + 1 :]))


def _fillings(block: Zero, nodes: Sequence[Node]) -> Iterator[Node]:
    square = (Identity(block.rows),) if block.rows == block.columns else ()
    for node in dict.fromkeys((*square, *nodes)):
        if node.shape == block.shape and not isinstance(node, Zero):
            yield from (node, Negative(node))


def _blocks(node: Node) -> Iterator[Node]:
    """The blocks of an array, without their signs."""
    for row in node.rows if isinstance(node, Block) else ():
        yield from (block.term if isinstance(block, Negative) else block for block in row)
