# make          sets up .venv; decides the chapter, emits, compiles and verifies the kernels
# make test     sets up .venv; runs the tests (ARGS="-k twist" narrows them)
# make quick    sets up .venv; runs in less than a minute those tests that find most
# make bench    sets up .venv and the peers; times the kernels beside them (ARGS="--rounds 3" and the like)
# make docs     sets up .venv; executes and builds the manual: docs/_build/html/index.html
# make coq      sets up .venv; writes the verdicts as theorems to proofs/, where Coq checks them (Debian package coq)
# make lint | types | compile | wheel | clean
#
# PYTHON=python3.12 chooses the interpreter, CC=clang the compiler. Where a compiler and Python.h are at hand, kernels
# that do not compile are an error; CHASLES_REQUIRE_C=0 goes on with the NumPy kernels.

PYTHON ?= python3
ARGS ?=
export CC
# Tests and the manual start some hundred processes: what they import is compiled for all of them.
unexport PYTHONDONTWRITEBYTECODE

VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check --quiet
# One build folder, so that a rebuild compiles only what has changed.
INSTALL := SKBUILD_BUILD_DIR=$(VENV)/build $(PIP) install --no-build-isolation --editable
BUILD_FILES := pyproject.toml CMakeLists.txt $(wildcard cmake/*) src/chasles/__init__.py
C_FILES := $(wildcard generated/c/include/* generated/c/src/* generated/gufunc/*)

.PHONY: all chapter compile test quick bench docs coq lint types wheel clean
.DELETE_ON_ERROR:

all: chapter

# The main job. Emitting may change C files, hence the second look at what has to be compiled.
chapter: compile
	@$(BIN)/chasles decide --brief
	@$(BIN)/chasles emit
	@$(MAKE) --no-print-directory compile
	@$(BIN)/chasles summary

compile: $(VENV)/.compiled
	@:

test: $(VENV)/.compiled $(VENV)/.tools
	@$(BIN)/python -m pytest -n 2 --dist worksteal $(ARGS)

# Of each room what fails first: names and imports, the verdicts on record, proofs and points checked again, grades,
# programs and their kernels, what the commands print.
QUICK := \
    asking assumptions by_hand certificate checked complex derive drawn enclosures formulas_in_html imports intervals \
    judge kernel_choice kernel_names lengths_and_angles mistakes names no_heuristics printed recheck recheck_relations \
    sentences side_conditions slips spelling verdicts \
    exercises/test_claims exercises/test_grading exercises/test_grading_of_signs \
    lowering/test_branches lowering/test_builder lowering/test_lower lowering/test_rounding \
    targets/test_targets_emission targets/test_targets_spelling cli/test_cli_contract cli/test_cli_usage

quick: $(VENV)/.compiled $(VENV)/.tools
	@$(BIN)/python -m pytest -n 2 --dist worksteal -m 'not slow' $(ARGS) $(QUICK:%=tests/test_%.py)

bench: $(VENV)/.compiled $(VENV)/.tools $(VENV)/.peers
	@$(BIN)/python -m benchmarks.kernels $(ARGS)
	@$(BIN)/python benchmarks/against_sympy.py --budget 1 --every 20
	@$(BIN)/python benchmarks/deciding.py 1
	@$(BIN)/python -m benchmarks.cost

# Cells are executed anew each time: what they show depends on all of the code. A warning is an error.
docs: $(VENV)/.compiled $(VENV)/.tools $(VENV)/.docs
	@rm -rf docs/_build
	@$(BIN)/python -m sphinx -W --keep-going --nitpicky --quiet --jobs 2 --builder html docs docs/_build/html
	@echo "docs/_build/html/index.html"

coq: $(VENV)/.compiled
	@$(BIN)/chasles decide --brief --coq proofs/derivations $(ARGS)
	@$(BIN)/chasles --chapter chasles.rotations decide --brief --coq proofs/rotations $(ARGS)
ifndef ARGS
	@for chapter in derivations rotations; do ! test -f proofs/$$chapter/COQ.json || cp proofs/$$chapter/COQ.json $$chapter/; done
endif

lint: $(VENV)/.tools
	@$(BIN)/ruff check
	@$(BIN)/ruff format --check

types: $(VENV)/.compiled $(VENV)/.tools
	@mkdir -p .types/chasles && ln -sfn ../../derivations ../../rotations ../../generated .types/chasles/
	@$(BIN)/mypy

wheel: $(VENV)/pyvenv.cfg
	@$(PIP) wheel --no-deps --wheel-dir dist .
	@ls dist/*.whl

clean:
	rm -rf $(VENV) .types build dist docs/_build .mypy_cache .pytest_cache .ruff_cache .hypothesis .benchmarks

# The folder first, and pip before the environment that would have it: what venv says of either is no help.
$(VENV)/pyvenv.cfg:
	@test -w . || { echo "This folder cannot be written, and make sets up $(VENV) in it: $(CURDIR)" >&2; \
	    echo "Make it writable, or copy the checkout to a folder of yours and run make there." >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	    || { echo "chasles needs Python 3.11 or newer as '$(PYTHON)'; make PYTHON=... names another" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { \
	    echo "'$(PYTHON)' cannot make a virtual environment: install the Debian package python3-venv" >&2; exit 1; }
	@echo "Setting up $(VENV): a minute or so, most of it downloads"
	@$(PYTHON) -m venv $(VENV) >/dev/null || { rm -rf $(VENV); \
	    echo "'$(PYTHON) -m venv $(VENV)' did not succeed: what it says stands above" >&2; exit 1; }

$(VENV)/.buildtools: pyproject.toml | $(VENV)/pyvenv.cfg
	@$(BIN)/python -c 'import tomllib; t = tomllib.load(open("pyproject.toml", "rb")); \
	    print(*t["build-system"]["requires"], *t["project"]["optional-dependencies"]["build"], sep="\n")' >$@.txt
	@$(PIP) install --requirement $@.txt
	@touch $@

$(VENV)/.compiled: $(BUILD_FILES) $(C_FILES) | $(VENV)/.buildtools
	@echo "Installing chasles and compiling its kernels"
	@test -n '$(C_FILES)' && sh cmake/can_compile.sh '$(CC)' $(BIN)/python && able=1 || able=0; \
	    CHASLES_REQUIRE_C=$${CHASLES_REQUIRE_C:-$$able} $(INSTALL) '.[fast]'
	@touch $@

# A peer without a wheel for this interpreter must not keep out the others.
$(VENV)/.peers: pyproject.toml | $(VENV)/.compiled
	@echo "Installing the peers"
	@$(INSTALL) '.[bench]' || for peer in matplotlib casadi symforce wrenfold numba scipy cython setuptools; do \
	    $(PIP) install $$peer || echo "$$peer cannot be installed here: it is left out"; done
	@touch $@

$(VENV)/.docs: pyproject.toml | $(VENV)/.compiled
	@echo "Installing what the manual is built with"
	@$(INSTALL) '.[docs]'
	@touch $@

$(VENV)/.tools: pyproject.toml | $(VENV)/.compiled
	@echo "Installing the test tools"
	@$(INSTALL) '.[test,dev]'
	@touch $@
