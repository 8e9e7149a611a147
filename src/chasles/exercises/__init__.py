"""Exercises: data read, solved step by step on a worksheet, drawn, practised and graded."""
