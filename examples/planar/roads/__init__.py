"""How results come about, one module a road."""

ROADS = ("r01_acceleration",)
