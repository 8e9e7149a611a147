"""READING: displayed equations of a page, and a notation that says what its letters are, to words."""
