"""PROGRAMS: from a proved equation to a straight line of scalar operations, free of any target language."""
