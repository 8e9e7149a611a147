"""One page for people: the whole chapter with its verdicts, as a single HTML file that needs nothing else."""
