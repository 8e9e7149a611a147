"""The exercises of Section 3.9, one module an exercise: what is asked, the data, the way to the answer."""
