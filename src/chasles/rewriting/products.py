"""Products multiplied out: an expression as a sum of numbers times scalars times factors in their order."""

from __future__ import annotations

from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import product

from chasles import vocabulary as w
from chasles.rewriting.coefficients import added
from chasles.rewriting.product import Product, cancelled, chained, collected, contraction, divided, spelled_out
from chasles.vocabulary import Node


def without_brackets(node: Node) -> Node:
    """The expression without the brackets and arguments that are printed only to be seen."""
    match node:
        case w.Group(of) | w.At(of):
            return without_brackets(of)
        case _:
            parts = node.below
            changed = tuple(map(without_brackets, parts))
            if changed == parts:
                return node
            if isinstance(node, w.Contract):
                return chained(changed)
            return w.rebuilt(node, changed)


def multiplied_out(node: Node) -> Node:
    """The expression as a sum of products, equal ones put together, in the order in which they arise."""
    return spelled_out(_merged(collected(products(node))), node.shape)


def _merged(terms: list[Product]) -> list[Product]:
    """The terms, matrices of blocks added entry by entry where all of them are such, with blocks of the same sizes."""
    blocks = [p.factors[0] for p in terms if len(p.factors) == 1 and isinstance(p.factors[0], w.Block)]
    sizes = {tuple(tuple(part.shape for part in row) for row in block.rows) for block in blocks}
    if len(terms) < 2 or len(blocks) < len(terms) or len(sizes) != 1:
        return terms
    weights = [spelled_out([with_fields(p, factors=(), shape=(1, 1))], (1, 1)) for p in terms]
    rows, columns = len(blocks[0].rows), len(blocks[0].rows[0])

    def entry(i: int, j: int) -> Node:
        return multiplied_out(
            added([w.Scale(weight, block.rows[i][j]) for weight, block in zip(weights, blocks, strict=True)])
        )

    return [_atom(w.Block(tuple(tuple(entry(i, j) for j in range(columns)) for i in range(rows))))]


def products(node: Node) -> list[Product]:
    """The products that add up to the expression."""
    shape = node.shape
    match node:
        case w.Group(of) | w.At(of):
            return products(of)
        case w.Number(value):
            return [Product(value, (), (), (), shape)] if value else []
        case w.Zero():
            return []
        case w.Identity():
            return [Product(Fraction(1), (), (), (), shape)]
        case w.Sum(terms):
            return collected(p for term in terms for p in products(term))
        case w.Negative(term):
            return [with_fields(p, number=-p.number) for p in products(term)]
        case w.Scale(factor, term):
            return collected(_scaled(a, b) for a, b in product(products(factor), products(term)))
        case w.Quotient(above, below):
            return [divided(p, below) for p in products(above)]
        case w.Contract(factors):
            return _contracted([products(factor) for factor in factors])
        case w.Power(base, exponent) if not isinstance(base, w.Norm) and not isinstance(base, w.Symbol | w.Rate):
            return _contracted([products(base)] * exponent)
        case w.Power(w.Norm(of), 2) if isinstance(of, w.Sum):
            return products(w.Dot(of, of))
        case w.Transpose(of):
            return collected(_flipped(p) for p in products(of))
        case w.Dot(left, right) | w.Cross(left, right):
            return collected(_paired(node, a, b) for a, b in product(products(left), products(right)))
        case w.Skew(of) | w.Vect(of) | w.Trace(of):
            return collected(_mapped(node, p) for p in products(of))
        case w.Block(rows):
            return [_atom(w.Block(tuple(tuple(map(multiplied_out, row)) for row in rows)))]
        case w.Integral(of):
            return collected(_integrated(node, p) for p in products(of))
        case w.Rate() | w.Call():
            return [_atom(node)]
        case _:
            parts = node.below
            return [_atom(w.rebuilt(node, tuple(map(multiplied_out, parts))) if parts else node)]


def _atom(node: Node) -> Product:
    if node.is_scalar:
        return Product(Fraction(1), (node,), (), (), node.shape)
    return Product(Fraction(1), (), (), (node,), node.shape)


def _scaled(factor: Product, term: Product) -> Product:
    scalars = (*factor.scalars, *((contraction(factor.factors),) if factor.factors else ()), *term.scalars)
    shape = term.shape if factor.shape == (1, 1) else factor.shape
    return cancelled(factor.number * term.number, scalars, (*factor.divisors, *term.divisors), term.factors, shape)


def _contracted(parts: list[list[Product]]) -> list[Product]:
    total = parts[0]
    for part in parts[1:]:
        total = collected(p for a, b in product(total, part) for p in _joined(a, b))
    return total


def _joined(a: Product, b: Product) -> list[Product]:
    """The product of two products; blocks that meet and fit together are multiplied."""
    shape = (a.shape[0], b.shape[1])
    number, scalars, divisors = a.number * b.number, (*a.scalars, *b.scalars), (*a.divisors, *b.divisors)
    if a.shape == (1, 1) and a.factors and not (a.shape[1] == b.shape[0] == 1 and b.factors):
        return [_scaled(a, b)]
    if a.factors and b.factors:
        met = _blocks(a.factors[-1], b.factors[0])
        if met is not None:
            inner = w.Contract((*a.factors[:-1], met, *b.factors[1:])) if len(a.factors) + len(b.factors) > 2 else met
            outer = Product(number, scalars, divisors, (), (1, 1))
            return [_scaled(outer, p) for p in (products(inner) if inner != met or met.is_scalar else [_whole(met)])]
    return [cancelled(number, scalars, divisors, (*a.factors, *b.factors), shape)]


def _whole(block: Node) -> Product:
    return _atom(block) if isinstance(block, w.Block) else Product(Fraction(1), (), (), (block,), block.shape)


def _blocks(left: Node, right: Node) -> Node | None:
    """The product of two matrices of blocks, if the blocks fit together; one block alone stands for itself."""
    if not isinstance(left, w.Block) or not isinstance(right, w.Block) or len(left.rows[0]) != len(right.rows):
        return None
    if [b.shape[1] for b in left.rows[0]] != [row[0].shape[0] for row in right.rows]:
        return None
    columns = list(zip(*right.rows, strict=True))

    def entry(row: tuple[Node, ...], column: tuple[Node, ...]) -> Node:
        return multiplied_out(added([w.Contract((a, b)) for a, b in zip(row, column, strict=True)]))

    rows = tuple(tuple(entry(row, column) for column in columns) for row in left.rows)
    return rows[0][0] if len(rows) == 1 and len(rows[0]) == 1 else w.Block(rows)


def _flipped(p: Product) -> Product:
    rows, columns = p.shape
    sign = 1
    factors: list[Node] = []
    for factor in reversed(p.factors):
        flip, flipped = _transposed(factor)
        sign *= flip
        factors.append(flipped)
    return Product(sign * p.number, p.scalars, p.divisors, tuple(factors), (columns, rows))


def _transposed(node: Node) -> tuple[int, Node]:
    """A sign and the transpose of one factor."""
    match node:
        case w.Transpose(of):
            return 1, of
        case w.Skew() | w.Symbol(stands_for=w.Skew()):
            return -1, node
        case w.Block(rows):
            return 1, w.Block(
                tuple(tuple(multiplied_out(w.Transpose(b)) for b in column) for column in zip(*rows, strict=True))
            )
        case w.Power(base, exponent):
            sign, flipped = _transposed(base)
            return sign**exponent, w.Power(flipped, exponent)
        case _:
            return 1, w.Transpose(node)


def _paired(node: w.Dot | w.Cross, a: Product, b: Product) -> Product:
    number, scalars, divisors = a.number * b.number, (*a.scalars, *b.scalars), (*a.divisors, *b.divisors)
    left, right = contraction(a.factors), contraction(b.factors)
    if isinstance(node, w.Dot):
        return cancelled(number, (*scalars, w.Dot(left, right)), divisors, (), (1, 1))
    if left == right:
        return Product(Fraction(0), (), (), (), node.shape)
    return cancelled(number, scalars, divisors, (w.Cross(left, right),), node.shape)


def _mapped(node: w.Skew | w.Vect | w.Trace, p: Product) -> Product:
    inner = contraction(p.factors) if p.factors else w.Identity(p.shape[0])
    if isinstance(node, w.Trace):
        return cancelled(p.number, (*p.scalars, w.Trace(inner)), p.divisors, (), (1, 1))
    return Product(p.number, p.scalars, p.divisors, (w.rebuilt(node, (inner,)),), node.shape)


def _integrated(node: w.Integral, p: Product) -> Product:
    """The integral of a product: its number comes out, and what is the same for all elements stays where it is."""
    inner = spelled_out([with_fields(p, number=Fraction(1))], p.shape)
    return with_fields(_atom(with_fields(node, of=inner)), number=p.number)
