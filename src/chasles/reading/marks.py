"""What one atom may be: a letter of the notation with what its accents and scripts do to it, a number, brackets."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from itertools import chain, product

from chasles.reading.applying import applied, made_of, with_marks
from chasles.reading.atoms import Atom, Atoms, Terms, said_of
from chasles.reading.case_grids import ENVIRONMENTS, case_fits
from chasles.reading.commands import DOTS
from chasles.reading.context import KINDS, FittingContext
from chasles.reading.fits import UNUSUAL, Fit, Shape, kept
from chasles.reading.glyphs import Glyph, in_latex, latex_of, letter_of, spelled, text_of_atom
from chasles.reading.letter_table import named_apart
from chasles.reading.matrices import block_fits, grid_fits, row_of_blocks
from chasles.reading.quotients import exponential_fits, fraction_fits, of_atoms
from chasles.reading.spellings import signed
from chasles.reading.typefaces import UNBRACKETED
from chasles.vocabulary import Group, Identity, Node, Number, Symbol, Transpose, Zero, latex
from chasles.vocabulary.families import Entry, Kronecker

INFINITY = r"\infty"
SIZE = re.compile(r"(\d+)(?: \\times (\d+))?")
WITHOUT_BARS = (r"\langle\rangle", r"\lfloor\rfloor", r"\lceil\rceil", r"\|\|")
"""Brackets that may stand for a mean, or for a norm of matrices."""
WITHOUT_WORD = {
    ".": "a full stop stands inside a formula",
    "!": "no word for a factorial",
    **{sign: f"no word for {sign}" for sign in (r"\sum", r"\prod", r"\int", r"\oint", r"\lim", r"\nabla")},
    **{dots: f"{dots} stands for what is left out" for dots in DOTS},
}


def atom_fits(atom: Atom, ctx: FittingContext) -> list[Fit]:
    """The readings of an atom with all its scripts; none, and a note why, where the notation does not know it."""
    letter = letter_of(atom)
    problems = len(ctx.problems)
    found = letter_fits(letter, ctx) or _indexed(letter, ctx) or _thin(letter, ctx)
    if not found:
        found = _constant(letter, ctx) or _nucleus(atom, letter, ctx)
    if found:
        del ctx.problems[problems:]
    elif len(ctx.problems) == problems and atom.kind in ("LETTER", "COMMAND"):
        ctx.note(WITHOUT_WORD.get(atom.text) or _unknown(letter, ctx), atom.place)
    return kept(found)


def _unknown(letter: Glyph, ctx: FittingContext) -> str:
    """Why it is no letter, or one whose marks do not fit what it is."""
    if letter.base.startswith(r"\sqrt"):
        return "what stands under a root does not fit together"
    for node, rest in ctx.notation.letters.meanings(letter):
        if replace(rest, base="") != Glyph(""):
            size = "a scalar" if node.is_scalar else " x ".join(map(str, node.shape))
            return f"{latex(node)} is {size}: {spelled(letter)} has no meaning"
    return f"the notation does not say what {spelled(letter)} is"


def letter_fits(letter: Glyph, ctx: FittingContext, is_function: bool = False) -> list[Fit]:
    """What the letter means, and what the marks that are not part of its name make of it."""
    found: list[Fit] = []
    longest: Glyph | None = None
    for node, rest in ctx.notation.letters.meanings(letter, is_function):
        if isinstance(node, Identity | Zero) and SIZE.fullmatch(rest.loose.sub):
            continue  # its size
        said = named_apart(node, ctx.notation.names) if isinstance(node, Symbol) and letter.arguments else node
        fits = with_marks([_of_symbol(said)], rest, ctx)
        longest = longest or (rest if fits else None)
        found += fits if rest == longest else [replace(fit, cost=fit.cost + UNUSUAL) for fit in fits]
    return found


def _of_symbol(node: Node) -> Fit:
    """A letter; a zero or an identity may have any size that the notation knows."""
    if isinstance(node, Identity | Zero) and "_" not in node.letter:
        return Fit(None, sized=lambda shape: _sized(node, shape), usual=node.shape)
    return Fit(node)


def _sized(node: Identity | Zero, shape: Shape) -> Node | None:
    if isinstance(node, Zero):
        return Zero(*shape, node.letter)
    return Identity(shape[0], node.letter) if shape[0] == shape[1] != 1 else None


def _indexed(letter: Glyph, ctx: FittingContext) -> list[Fit]:
    """A member of a family, an entry of a matrix printed with a small letter, or the Kronecker delta."""
    notation = ctx.notation
    indices = [notation.indices[each] for each in letter.sub.split() if each in notation.indices]
    if not indices or len(indices) != len(letter.sub.split()) or letter.accents:
        return []
    found: list[Node] = []
    if len(indices) == 1:
        family = notation.families.get(Glyph(letter.base, (), "", letter.primes, letter.sups))
        found = [family[indices[0]]] if family else []
    elif len(indices) == 2 and letter.base == r"\delta":
        found = [Kronecker(*indices)]
    elif len(indices) == 2:
        large = [meaning(each) for each, meanings in notation.letters.exact.items() for meaning in meanings
                 if letter.base.isalpha() and each.loose.base.strip("[ ]") == letter.base.upper()]  # fmt: skip
        squares = [node for node in large if node.shape[0] != 1 and node.shape[0] == node.shape[1]]
        squares.sort(key=lambda node: not (isinstance(node, Symbol) and node.letter.startswith("[")))
        found = [Entry(squares[0], indices[0], indices[1], letter.base)] if squares else []
    return [Fit(node) for node in found]


def _thin(letter: Glyph, ctx: FittingContext) -> list[Fit]:
    """Entries are printed thin where the whole is printed bold."""
    if not letter.sub or letter.base.startswith(r"\math"):
        return []
    bold = ctx.notation.letters.meanings(replace(letter, base=rf"\mathbf {letter.base}"))
    bold = (each for each in bold if not isinstance(each[0], Identity | Zero))
    found = [(node, replace(rest, base="")) for node, rest in bold if rest.sub == letter.sub]
    return [fit for node, rest in found for fit in with_marks([_of_symbol(node)], rest, ctx)]


def _nucleus(atom: Atom, letter: Glyph, ctx: FittingContext) -> list[Fit]:
    """What is no letter of the notation: numbers, brackets, fractions, matrices, accents over expressions."""
    rest = replace(letter, base="", accents=())
    if any(letter.before) and atom.kind not in ("GROUP", "GRID"):
        return []
    spellings = ctx.notation.spellings
    match atom.kind:
        case "NUMBER":
            fits = _number(atom.text)
        case "LETTER" if atom.text == "e" and len(atom.sups) == 1 and not atom.sub:
            return exponential_fits(atom.sups[0], ctx)
        case "BRACKET" if len(atom.inside) == 1:
            return _bracketed(atom, rest, ctx)
        case "BRACKET" if len(atom.inside) > 2 and atom.text == r"\langle\rangle":
            return _column(atom, rest, ctx)
        case "BRACKET" if makes := spellings.brackets.get((f"{atom.text},", rest.loose.sub, " ".join(rest.loose.sups))):
            return list(made_of(makes, list(product(*map(ctx.terms, atom.inside))), None, ctx))
        case _ if _has_no_word(atom):
            at = f"{ctx.where}:{atom.place.line}:{atom.place.column}"  # two of them are not equal
            fits = ctx.of_its_own(latex_of(atom), here=at if atom.text == INFINITY else "")
        case "BRACKET" if atom.inside and atom.text in ("()", "[]"):
            return _column(atom, rest, ctx)
        case "GROUP" | "GRID" if any(atom.before):
            inner = of_atoms((replace(atom, before=((), ())),), ctx)
            return ctx.of_its_own(in_latex(text_of_atom(atom)), [fit.node for fit in inner if fit.node is not None])
        case "GRID" if atom.text in ENVIRONMENTS:
            fits = case_fits(atom, ctx, of_atoms) or ctx.of_its_own(latex_of(atom))
        case "GRID":
            fits = grid_fits(atom, ctx, of_atoms)
        case "COMMAND_OF_TWO" if "frac" in atom.text:
            fits = fraction_fits(atom, ctx)
        case "GROUP" if atom.arguments[0]:
            fits = of_atoms(atom.arguments[0], ctx)  # with the scripts in it; the others are put on all of it
            rest = replace(rest, sub=said_of(atom.sub or ()), primes=atom.primes, sups=tuple(map(said_of, atom.sups)))
        case "COMMAND" if atom.text in spellings.names:
            fits = applied(spellings.names[atom.text], of_atoms(atom.arguments[0], ctx), ctx, rest, atom.text)
        case "COMMAND" if atom.text.replace("wide", "") in spellings.accents:
            makes = spellings.accents[atom.text.replace("wide", "")]
            fits = applied(makes, of_atoms(atom.arguments[0], ctx), ctx, rest, atom.text)
        case _:
            return []
    return with_marks(fits, rest, ctx)


def _has_no_word(atom: Atom) -> bool:
    """Whether it is an event, a binomial, an infinity, a list in braces, or something with dots."""
    match atom.kind:
        case "GRID":
            return any(map(_leaves_out, chain.from_iterable(atom.rows)))
        case "BRACKET" if len(atom.inside) > 1:
            is_list = atom.text in (r"\{\}", r"\langle\rangle")
            return is_list or any(_leaves_out(row) for each in atom.inside for row in each.rows)
        case _:
            return atom.kind == "EVENT" or atom.text in (r"\binom", INFINITY)


def _leaves_out(cell: Atoms) -> bool:
    """Whether dots stand there for what is left out."""
    return said_of(cell) == r"\cdot" or any(piece.text in DOTS for piece in cell)


def _constant(letter: Glyph, ctx: FittingContext) -> list[Fit]:
    r"""An identity or a zero that shows its size, as 0_{3\times 1} and I_3 do, or is set in bold."""
    name, size = letter.loose.base, SIZE.fullmatch(letter.loose.sub)
    is_bare = not letter.sub and (letter.base != name or letter.accents in ((r"\vec",), (r"\bar",)))
    if name not in ("0", "1", "O", "I") or letter.primes or not (size or (is_bare and name in "01")):
        return []
    own = replace(letter, sups=(), place=None)
    rows, columns = (int(size[1]), int(size[2] or 0)) if size else (0, 0)
    columns = columns or (rows if name in "1I" else 0)

    def sized(shape: Shape) -> Node | None:
        fits = rows in (0, shape[0]) and columns in (0, shape[1])
        node = Identity(shape[0], spelled(own)) if name in "1I" else Zero(*shape, spelled(own))
        return node if fits and (name in "0O" or shape[0] == shape[1] != 1) else None

    usual = (rows or 3, columns or (3 if name in "1I" else 1))
    node = sized(usual) if rows and columns else None
    fit = Fit(node) if node is not None else Fit(None, sized=sized, usual=usual)
    return with_marks([fit], replace(letter, base="", accents=(), sub=""), ctx)


def _number(text: str) -> list[Fit]:
    found = [Fit(Number(Fraction(text)))]
    if text in ("0", "1"):
        constant = Zero(3, 1, "0") if text == "0" else Identity(3, "1")
        found.append(Fit(None, 1, sized=lambda shape: _sized(constant, shape) if shape != (1, 1) else None))
    return found


def _bracketed(atom: Atom, rest: Glyph, ctx: FittingContext) -> list[Fit]:
    """Brackets that spell a word with their scripts, or that hold together what stands in them."""
    brackets = ctx.notation.spellings.brackets
    loose = rest.loose
    text, inside = signed(atom)
    spelled: list[Fit] = []
    for sub, sups in dict.fromkeys(((loose.sub, " ".join(loose.sups)), (loose.sub, ""), ("", ""))):
        if (makes := brackets.get((text, sub, sups))) and not spelled:
            left = replace(rest, sub="" if sub else rest.sub, sups=() if sups else rest.sups)
            spelled = with_marks(applied(makes, ctx.terms(inside), ctx, rest, text), left, ctx)
            if spelled and (sub or sups):
                return spelled
    if text not in ("()", "[]", r"\{\}"):
        ctx.note(f"{text} has no meaning in the notation", atom.place)
        return spelled or (with_marks(ctx.of_its_own(latex_of(atom)), rest, ctx) if text in WITHOUT_BARS else [])
    if atom.text == "[]" and rest.sub.startswith(r"\mathcal "):
        frame = rf"\mathcal{{{rest.sub.split()[1]}}}"
        framed = applied((lambda of: Group(of, "[]", frame),), ctx.terms(atom.inside[0]), ctx, rest, rest.sub)
        return with_marks(framed, replace(rest, sub=""), ctx)
    inner = ctx.terms(atom.inside[0])
    if only_grid := _grid_of(atom.inside[0]):
        return with_marks(atom_fits(only_grid, ctx), rest, ctx)
    fits = [_in_brackets(fit, atom.text) for fit in inner]
    if ctx.level and atom.text == "[]" and not atom.sub and not atom.sups:
        fits += [replace(fit, cost=fit.cost + 2) for fit in row_of_blocks(atom.inside[0], ctx)]
    plain = with_marks(fits, rest, ctx)
    return [*spelled, *(replace(fit, cost=fit.cost + bool(spelled)) for fit in plain)]


def _column(atom: Atom, rest: Glyph, ctx: FittingContext) -> list[Fit]:
    """A column that is printed in a line, with commas; transposed where a sign of that stands behind."""
    parts = [ctx.terms(each) for each in atom.inside]
    makes = ctx.notation.spellings.scripts.get(" ".join(rest.loose.sups), ())
    fits = block_fits([[part] for part in parts], ctx)
    if rest.sups and Transpose not in makes:
        return []
    shapes = [{fit.shape for fit in part} for part in parts]
    if atom.text == "[]" and not rest.sups and len(shapes) == 2 and shapes[0] & shapes[1]:
        if (shapes[0] & shapes[1]) - {None} == {(1, 1)}:  # an interval, a row or a column
            return with_marks(ctx.of_its_own(latex_of(atom)), rest, ctx)
        ctx.note("two in square brackets may be a commutator: write a column as a matrix", atom.place)
        return []
    return with_marks([replace(fit, cost=fit.cost + 1) for fit in fits], replace(rest, sups=()), ctx)


def _grid_of(terms: Terms) -> Atom | None:
    """The array without brackets of its own, where nothing else stands here."""
    piece = terms.rows[0][0]
    is_bare = piece.kind == "GRID" and piece.text in UNBRACKETED
    return piece if is_bare and terms.signs == ("",) and len(terms.rows[0]) == 1 else None


def _in_brackets(fit: Fit, brackets: str) -> Fit:
    """The same with brackets around it; those inside stand for a group."""
    if not fit.brackets:
        return replace(fit, brackets=brackets)
    kind, sized = KINDS[fit.brackets], fit.sized
    if sized is None:
        return Fit(None if fit.node is None else Group(fit.node, kind), fit.cost, brackets)
    grouped = lambda shape: None if (node := sized(shape)) is None else Group(node, kind)  # noqa: E731
    return replace(fit, brackets=brackets, sized=grouped)
