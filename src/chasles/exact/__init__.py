"""GEOMETRY: exact numbers, lines, screws and frames, and the sheet on which an exercise is solved step by step."""
