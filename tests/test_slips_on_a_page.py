"""A slip planted on a page is told: what was right becomes wrong, with what it should say."""

from __future__ import annotations

import re

from chasles import read

from .sampling import sample

NOTATION = r"""
[operators]
skew = ['[#]_\times']

[symbols]
'q_{0}' = 'scalar'
'\mathbf{q}' = 'vector'
'q_{1|2|3}' = { is = "component", of = '\mathbf{q}' }
'\mathbf{C}' = 'rotation'

[page]
assuming = ['q_0^2 + \|\mathbf{q}\|^2 = 1']
"""
PAGE = r"""
$$\mathbf C = \mathbf 1 + 2 q_0 [\mathbf q]_\times + 2 [\mathbf q]_\times^2$$
$$\mathbf C = \begin{bmatrix}
 q_0^2 + q_1^2 - q_2^2 - q_3^2 & 2q_1q_2 - 2q_0q_3 & 2q_0q_2 + 2q_1q_3 \\
 2q_0q_3 + 2q_1q_2 & q_0^2 - q_1^2 + q_2^2 - q_3^2 & 2q_2q_3 - 2q_0q_1 \\
 2q_1q_3 - 2q_0q_2 & 2q_0q_1 + 2q_2q_3 & q_0^2 - q_1^2 - q_2^2 + q_3^2 \end{bmatrix}$$
$$\mathbf C^T = \mathbf 1 - 2 q_0 [\mathbf q]_\times + 2 [\mathbf q]_\times^2$$
"""
SLIPS = ((r" \+ ", " - "), (r" - ", " + "), (r"\^T", ""), (r"q_1", "q_2"), (r"2q_0", "q_0"))


def slips() -> list[str]:
    """The page with one slip, for some of the places at which one can be."""
    places = [(found.span(), instead) for pattern, instead in SLIPS for found in re.finditer(pattern, PAGE)]
    return [PAGE[:begin] + instead + PAGE[end:] for (begin, end), instead in sample(places, 8)]


def test_the_page_is_right() -> None:
    first, *others = (each.verdict for each in read(PAGE, NOTATION).equations)
    assert first == "defined"
    assert set(others) <= {"holds", "holds-under"}


def test_each_slip_is_told_with_what_is_right() -> None:
    pages = [read(slip, NOTATION) for slip in slips()]
    assert len(pages) > 4
    for page in pages:
        wrong = [each for each in page.equations if each.verdict == "fails"]
        assert wrong, repr(page)
        assert all(each.finding is not None and each.finding.instead for each in wrong)


def test_a_letter_that_was_meant_for_another_is_told() -> None:
    notation = r"""
[symbols]
'n_{#}' = "unit vector"
'a_{#}' = "unit vector"
[page]
assuming = ['n_x \cdot n_y = 0', 'n_z = n_x \times n_y']
"""
    page = "\n".join(
        rf"$$ a_{left} = (a_{right} \cdot n_x) n_x + (a_{right} \cdot n_y) n_y + (a_{right} \cdot n_z) n_z $$"
        for left, right in ("xx", "yy", "xz")
    )
    *right, wrong = read(page, notation).equations
    assert [each.verdict for each in right] == ["holds-under", "holds-under"]
    assert wrong.verdict == "fails"
    assert str(wrong.finding.instead.left) == "a_z"


def test_a_slip_for_which_no_point_is_found_is_told_with_what_was_likely_meant() -> None:
    letters = {**{rf"\mathbf{{{each}}}": "vector" for each in "abc"}, r"\theta": "angle", "m": "scalar"}
    law, slip = r"\mathbf{c} = 2 \mathbf{b} - 3 \cos\theta \mathbf{b}", r"2 \mathbf{b} - m \mathbf{b}"
    lengths = (rf"\|\mathbf{{a}} \times \mathbf{{b}} + \mathbf{{b}} - {k} \mathbf{{c}}\|" for k in range(2, 18))
    length = r"\theta = \|\mathbf{a}\| + " + " + ".join(lengths)
    said = (
        length.replace(r"\mathbf{c}", r"\mathbf{b} \times \mathbf{a}"),
        law,
        rf"\mathbf{{c}} + m \mathbf{{b}} + 3 \cos\theta \mathbf{{b}} = {slip}",
    )
    *_, slip = read("\n".join(f"$$ {each} $$" for each in said), {"symbols": letters}).equations
    assert slip.verdict == "open"
    assert str(slip.finding.instead.left) == "c - m b + 3 cos(theta) b"


NUMBERS = {"symbols": dict.fromkeys(("a", "b", "c", "x", "y", "z", "k", "m", "u"), "scalar")}


def verdicts(*equations: str) -> list[str]:
    """The verdicts on a page with scalars, and what stands in its sections."""
    return [each.verdict for each in read("\n\n".join(equations), NUMBERS, "md").equations]


def test_another_small_number_is_a_slip() -> None:
    *_, wrong = read("$$x = a + b$$ $$x^2 = a^2 + 3 a b + b^2$$", NUMBERS, "md").equations
    assert wrong.verdict == "fails"
    assert str(wrong.finding.instead.right) == "a^2 + 2 a b + b^2"


def test_a_slip_behind_an_open_equation_fails_where_others_rest_on_it() -> None:
    law, right, slip = "$$m x = a (b - c)$$", "$$m x = a b - a c$$", "$$m x + a c = 2 a b$$"
    assert verdicts(law, slip) == ["open", "open"]
    assert verdicts(law, slip, right) == ["open", "fails", "holds-under"]
    assert verdicts(law, "# Another", slip, right) == ["open", "open", "holds-under"]


def test_what_is_said_anew_in_another_section_is_a_definition() -> None:
    first, second = "$$x = a + b$$", "$$x = a b c$$"
    assert verdicts(first, second) == ["defined", "open"]
    assert verdicts(first, "# Another", second, "$$x^2 = a^2 b^2 c^2$$") == ["defined", "defined", "holds"]


def test_a_rate_follows_and_what_is_said_behind_defines() -> None:
    assert verdicts(r"$$x \equiv y z$$", r"$$\dot x \equiv \dot y z + y \dot z$$") == ["defined", "holds"]
    assert verdicts("$$a x = b$$", "$$a = 2 c$$", "$$b = 2 c x$$") == ["holds", "defined", "defined"]


def test_a_slip_is_told_of_what_a_letter_is_by_its_kind_beside_what_the_page_says_of_it() -> None:
    page = r"""
$$R = \begin{bmatrix} n & o & a \end{bmatrix}$$
$$R R = 1$$
$$q = p - m a$$
$$H = \frac{p}{m} \cdot p - g m = \frac{\|q\|^2}{m} - g m$$
$$x = y + z = y + h$$
$$T = \begin{bmatrix} R & a \\ 0 & 1 \end{bmatrix}$$
$$T^{-1} = \begin{bmatrix} R & -R^T a \\ 0 & 1 \end{bmatrix}$$
"""
    letters = {
        "R": "rotation",
        "T": {"is": "matrix", "shape": [4, 4]},
        **dict.fromkeys("noapq", "vector"),
        **dict.fromkeys("Hgmxyzh", "scalar"),
    }
    found = read(page, {"symbols": letters}).equations
    wrong = [each for each in found if each.verdict == "fails"]
    assert [each.line for each in wrong] == [3, 5, 8]
    assert wrong[0].finding
    assert "R is a rotation" in wrong[0].finding.against


def test_another_letter_is_a_slip_in_what_is_said_of_known_quantities_together() -> None:
    letters = {"symbols": {letter: {"is": "scalar"} for letter in "abcuv"}}
    *_, found = read("$$u = a b$$\n$$v = a + c$$\n$$u + v = a b + a + b$$", letters).equations
    assert (found.verdict, str(found.finding and found.finding.instead.right)) == ("fails", "a b + a + c")


def test_what_is_said_of_a_rate_in_another_frame_is_no_slip_of_a_letter() -> None:
    letters = {"symbols": {rf"\mathbf{{{letter}}}": {"is": "vector"} for letter in "rsw"}}
    page = r"$$\mathbf r = \mathbf s$$" + "\n" + r"$$\dot{\mathbf r} = \dot{\mathbf s} + \mathbf w \times \mathbf s$$"
    assert [each.verdict for each in read(page, letters).equations] == ["defined", "open"]


ROTATION = r"""
$$\theta = \sqrt{a^2 + b^2 + c^2}, \quad s = \frac{\sin\theta}{\theta}, \quad k = \frac{1 - \cos\theta}{\theta^2}$$

$$R = \begin{bmatrix} 1 - k (b^2 + c^2) & k a b - s c & k a c + s b \\ k a b + s c & 1 - k (a^2 + c^2) & k b c - s a \\
k a c - s b & k b c + s a & 1 - k (a^2 + b^2) \end{bmatrix}$$

$$\operatorname{tr}(R) = 3 - 2 \frac{1 - \cos\theta}{\theta^2} (a^2 - b^2 + c^2)$$
"""


def test_a_slip_is_told_in_what_is_long_where_it_is_written_out() -> None:
    letters = dict.fromkeys((r"\theta", *"abcsk"), "scalar") | {"R": "matrix"}
    found = read(ROTATION, {"symbols": letters}, "md").equations[-1]
    assert found.verdict == "fails"
    assert "a^2 + b^2 + c^2" in str(found.finding.instead)
