"""Questions made up at random, asked of the product, and answers held against numbers that share nothing with it.

`python -m tests.fuzzing --seconds 600 --seed 1` looks for false verdicts. What is generated depends on the seed and the
question's number alone. Values are power series in time, to 50 digits, at points that satisfy all that is given.
"""
