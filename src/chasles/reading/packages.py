"""Commands of LaTeX packages that are made of others."""

from __future__ import annotations

ALWAYS = r"""
\newcommand\prescript[3]{{}^{#1}_{#2}{#3}}
\newcommand\leftidx[3]{{}#1{#2}#3}
\newcommand\abs[1]{\left|#1\right|} \newcommand\norm[1]{\left\|#1\right\|}
\newcommand\vect[1]{\vec{#1}} \newcommand\vb[1]{\mathbf{#1}} \newcommand\mbf[1]{\mathbf{#1}}
\newcommand\Exp{\operatorname{Exp}} \newcommand\Log{\operatorname{Log}} \newcommand\tr{\operatorname{tr}}
\newcommand\diag{\operatorname{diag}} \newcommand\R{\mathbb{R}} \newcommand\half{\frac{1}{2}}
\newcommand\bs[1]{\boldsymbol{#1}} \newcommand\mbs[1]{\boldsymbol{#1}} \newcommand\mb[1]{\mathbf{#1}}
\newcommand\mat[1]{\mathbf{#1}} \newcommand\mtx[1]{\mathbf{#1}} \newcommand\vct[1]{\mathbf{#1}}
\newcommand\Mat[1]{\mathbf{#1}} \newcommand\Vec[1]{\mathbf{#1}} \newcommand\vv[1]{\overrightarrow{#1}}
\newcommand\Norm[1]{\left\|#1\right\|} \newcommand\la{\langle} \newcommand\ra{\rangle} \newcommand\degree{^\circ}
\newcommand\uvec[1]{\hat{\mathbf{#1}}} \newcommand\uvect[1]{\hat{\mathbf{#1}}} \newcommand\unitvec[1]{\hat{\mathbf{#1}}}
\newcommand\pdiff[2]{\frac{\partial #1}{\partial #2}} \newcommand\pder[2]{\frac{\partial #1}{\partial #2}}
\newcommand\pdv{\derivative\partial} \newcommand\dv{\derivative d}
\newcommand\dif{\mathrm{d}} \newcommand\mathd{\mathrm{d}} \newcommand\dd{\mathrm{d}} \newcommand\ud{\mathrm{d}}
\newcommand\cross{\times} \newcommand\vector[1]{\vec{#1}} \newcommand\mag[1]{\left|#1\right|}
\newcommand\Transpose{\top} \newcommand\transpose{\top}
\newcommand\T{\top} \newcommand\transp{\top} \newcommand\tran{\top} \newcommand\comma{,}
\newcommand\SO{\operatorname{SO}} \newcommand\SE{\operatorname{SE}}
\newcommand\asin{\arcsin} \newcommand\acos{\arccos} \newcommand\atan{\arctan}
\newcommand\grad{\nabla} \newcommand\curl{\nabla\times} \newcommand\laplacian{\nabla^2}
\newcommand\sgn{\operatorname{sgn}} \newcommand\num[1]{#1} \newcommand\ang[1]{#1^\circ}
\newcommand\argmin{\operatorname{argmin}} \newcommand\argmax{\operatorname{argmax}}
\newcommand\ds{\displaystyle} \newcommand\bbm{\begin{bmatrix}} \newcommand\ebm{\end{bmatrix}}
\newcommand\bpm{\begin{pmatrix}} \newcommand\epm{\end{pmatrix}}
"""
"""What is the same in every package that has it, or a usual name for it where the page does not define it."""

UNITS = {
    "metre": "m",
    "meter": "m",
    "gram": "g",
    "kilogram": "kg",
    "second": "s",
    "minute": "min",
    "hour": "h",
    "newton": "N",
    "joule": "J",
    "watt": "W",
    "pascal": "Pa",
    "hertz": "Hz",
    "radian": "rad",
    "volt": "V",
    "ampere": "A",
    "kelvin": "K",
    "tesla": "T",
    "per": "/",
    "squared": "^2",
    "cubed": "^3",
    "kilo": "k",
    "centi": "c",
    "milli": "m",
    "nano": "n",
    "mega": "M",
    "giga": "G",
}
"""By the names that siunitx has for them."""
PACKAGES = {
    "physics": r"""
\newcommand\qty[1]{\left(#1\right)} \newcommand\vb{\mathbf} \newcommand\va[1]{\vec{\mathbf{#1}}}
\newcommand\vu[1]{\hat{\mathbf{#1}}} \newcommand\eval[1]{\left.#1\right|}
\newcommand\vdot{\cdot} \newcommand\div{\nabla\cdot}
""",
    "tensor": r"\newcommand\tensor[3][]{{}#1{#2}#3}",
    "siunitx": r"\newcommand\SI[3][]{#2\text{#3}} \newcommand\qty[3][]{#2\text{#3}}"
    + "".join(rf"\newcommand\{name}{{{unit}}}" for name, unit in UNITS.items()),
}
"""By the name of the package, what a page that uses it may write."""
