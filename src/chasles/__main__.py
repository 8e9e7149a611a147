"""`python -m chasles` is the command line."""

from chasles.cli import main

if __name__ == "__main__":
    main()
