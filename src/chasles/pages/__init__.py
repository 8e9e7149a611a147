"""Equations of a page decided without a person: which define, which claim, and from what each claim follows."""
