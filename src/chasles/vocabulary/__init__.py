"""WORDS: the frozen expression nodes in which the book's equations are written, exactly as printed.

Nodes keep the author's order and spelling and never simplify. Shapes and physical dimensions are checked when a node
is made. `@` contracts matrices, `*` scales by a scalar, `.T` transposes, `/` divides by a scalar.
"""

from chasles.vocabulary.dimension import (
    ACCELERATION,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    MOMENT,
    NO_DIMENSION,
    TIME,
    VELOCITY,
    Dimension,
)
from chasles.vocabulary.families import Entry, Family, Index, Kronecker, Member, members_of
from chasles.vocabulary.fitting import printed
from chasles.vocabulary.layout import At, Block, Call, Group, Integral, Rate
from chasles.vocabulary.letters import Identity, Symbol, Zero
from chasles.vocabulary.measure import Measure, Misfit, uniform
from chasles.vocabulary.nodes import Contract, Negative, Node, Number, Power, Quotient, Scale, Sum, Transpose
from chasles.vocabulary.plain import latex, plain
from chasles.vocabulary.spatial import Cofactor, Cross, Determinant, Dot, Inverse, Norm, Skew, Trace, Vect
from chasles.vocabulary.tree import children, rebuilt, replace, symbols_of, undotted, walk
from chasles.vocabulary.words import (
    CPM,
    PI,
    abbreviation,
    array,
    at,
    bracket,
    column,
    cos,
    cot,
    cross,
    det,
    dot,
    in_frame,
    integral,
    inverse,
    matrix,
    norm,
    number,
    over,
    paren,
    rate,
    row,
    scalar,
    sin,
    square,
    tan,
    tr,
    vect,
    vector,
)

__all__ = [
    "ACCELERATION", "CPM", "FORCE", "FREQUENCY", "LENGTH", "MASS", "MOMENT", "NO_DIMENSION", "PI", "TIME", "VELOCITY",
    "At", "Block", "Call", "Cofactor", "Contract", "Cross", "Determinant", "Dimension", "Dot", "Entry", "Family",
    "Group", "Identity", "Index", "Integral", "Inverse", "Kronecker", "Measure", "Member", "Misfit", "Negative", "Node",
    "Norm", "Number", "Power", "Quotient", "Rate", "Scale", "Skew", "Sum", "Symbol", "Trace", "Transpose", "Vect",
    "Zero", "abbreviation", "array", "at", "bracket", "children", "column", "cos", "cot", "cross", "det", "dot",
    "in_frame", "integral", "inverse", "latex", "matrix", "members_of", "norm", "number", "over", "paren", "plain",
    "printed", "rate", "rebuilt", "replace", "row", "scalar", "sin", "square", "symbols_of", "tan", "tr", "undotted",
    "uniform", "vect", "vector", "walk",
]  # fmt: skip
