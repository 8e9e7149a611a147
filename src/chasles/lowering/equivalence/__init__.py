"""Does a program compute what it should? Programs are read as fractions in what goes in, and compared exactly.

`requests.differences` holds a program against a request, `programs.equivalent` against another program;
`sums.same_but_for_order` does that for programs of any length that share, order and group alike values in other ways.
"""
