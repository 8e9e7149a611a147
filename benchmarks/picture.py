"""A picture of the times per element."""

from __future__ import annotations

from pathlib import Path
from typing import Any

SIZE = "10000 out="


def draw(evidence: dict[str, Any], to: Path) -> None:
    """Bars of ns per element for 10^4 elements, as SVG; nothing where matplotlib is not installed."""
    try:
        import matplotlib
    except ImportError:
        print("no picture: matplotlib is not installed")
        return
    matplotlib.use("svg")
    matplotlib.rcParams["svg.hashsalt"] = "chasles"
    from matplotlib import pyplot

    kernels = [kernel for kernel in evidence["kernels"].values() if SIZE in kernel["ns"]]
    peers = evidence["peers"]
    figure, axes = pyplot.subplots(figsize=(11, 5), layout="constrained")
    width = 0.85 / len(peers)
    colors = pyplot.get_cmap("tab20").colors
    for i, (name, title) in enumerate(peers.items()):
        shown = [(k, kernel["ns"][SIZE][name]) for k, kernel in enumerate(kernels) if name in kernel["ns"][SIZE]]
        if shown:
            places = [k + width * (i - len(peers) / 2) for k, _ in shown]
            axes.bar(places, [ns for _, ns in shown], width, label=title, color=colors[i % 20])
    axes.set_yscale("log")
    axes.set_ylabel("ns per element, $n = 10^4$, output given")
    axes.set_xticks(range(len(kernels)), [kernel["title"] for kernel in kernels])
    axes.legend(fontsize="small", ncols=2)
    figure.savefig(to, metadata={"Date": None})
    pyplot.close(figure)
