# Read by every shell of a cell: it stops at the first command that fails, and nothing is coloured, whatever Jupyter asks.
set -e
unset FORCE_COLOR CLICOLOR
