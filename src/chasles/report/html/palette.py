"""The colours of the page, light and dark; each colour of text has enough contrast to each ground that it is used on.

The four colours of curves are near those of Okabe and Ito, which colour-blind readers tell apart.
"""

from __future__ import annotations

LIGHT = {
    "ground": "#ffffff",
    "raised": "#f5f6f8",
    "ink": "#1b1f24",
    "quiet": "#565d68",
    "rule": "#d5d9e0",
    "link": "#0b57a4",
    "good": "#14692f",
    "good-ground": "#e3f4e7",
    "bad": "#a3161c",
    "bad-ground": "#fdeaea",
    "odd": "#86198f",
    "odd-ground": "#f9e8fb",
    "open": "#7a4b00",
    "open-ground": "#fdf1d7",
    "plain": "#2a4a7a",
    "plain-ground": "#e6eefa",
    "taken-ground": "#fbd5d5",
    "added-ground": "#c9efd3",
    "first": "#0072b2",
    "second": "#b84a00",
    "third": "#007a59",
    "fourth": "#946200",
}
DARK = {
    "ground": "#14171b",
    "raised": "#1e2228",
    "ink": "#e8eaed",
    "quiet": "#a6adb8",
    "rule": "#3a414b",
    "link": "#8ab8f5",
    "good": "#86d99a",
    "good-ground": "#15321e",
    "bad": "#ff9d98",
    "bad-ground": "#42191b",
    "odd": "#e7a6f0",
    "odd-ground": "#3a1a40",
    "open": "#f3c667",
    "open-ground": "#3b2c0c",
    "plain": "#a9c5f2",
    "plain-ground": "#1d2c46",
    "taken-ground": "#5c2326",
    "added-ground": "#1b4a2b",
    "first": "#5ab4e8",
    "second": "#ff9350",
    "third": "#3cc79b",
    "fourth": "#f0bd45",
}
