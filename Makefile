# `make derive` and `make test` do everything on a machine with Python >= 3.11 and make.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --quiet --disable-pip-version-check
# An extension that can't be compiled is left out, and pip is silent about it.
SAY_COMPILED := $(BIN)/python .ci/compiled.py
# A path to the tree, not a finder: a finder is asked last, after a folder named spragsym beside the script, as a clone is.
# Bytecode is made of what is imported, then: half of an installation is the bytecode of what never is.
EDIT := $(PIP) install --no-compile --config-settings editable_mode=compat -c constraints.txt -e

# One stamp for each set of extras, remade when what it was installed from changes.
DERIVE := $(VENV)/.derive
TEST := $(VENV)/.test
ALL := $(VENV)/.all
SOURCES := pyproject.toml constraints.txt Makefile
# Bytecode is kept whatever the environment says: without it each process compiles the package anew, and each worker the tests.
unexport PYTHONDONTWRITEBYTECODE

# Compiled code is made of these.
COMPILED := setup.py spragsym/kang_nam/quartic/_compiled.c spragsym/motion/_carried.c spragsym/numerics/_contractors.c spragsym/numerics/_search.c spragsym/numerics/_tape.c spragsym/numerics/_affine.h spragsym/numerics/_arrays.h spragsym/numerics/_newton.h spragsym/numerics/_operations.h spragsym/numerics/_rounding.h generated/c/spragsym.c generated/c/spragsym.h

# A source distribution comes without symbolic links.
LINKS := spragsym/derive spragsym/generated

# Generated C, as a reader finds it, and C that is written by hand; what the printer fills in is checked where it is filled.
C_FILES := $(wildcard generated/c/*.c generated/c/*.h) spragsym/kang_nam/quartic/_compiled.c spragsym/motion/_carried.c $(wildcard spragsym/numerics/_*.c spragsym/numerics/_*.h) $(wildcard derive/kang_nam/runtime/c/tests/*.c)
# A function's results are a struct, of which its caller may leave one unread.
CPPCHECK = cppcheck --quiet --suppress=toomanyconfigs --suppress=unusedStructMember --error-exitcode=1 --std=c11 --enable=warning,style,performance,portability \
	-I generated/c -I spragsym/numerics -I $$($(BIN)/python -c 'import sysconfig; print(sysconfig.get_paths()["include"])')

# As many workers as cores, at most four.
WORKERS ?= $(shell $(BIN)/python -c 'import os; print(min(4, os.cpu_count() or 1))' 2>/dev/null || echo 1)
# Files go to workers in the order that tests/conftest.py gives them: the longest first.
TESTS = $(BIN)/python -m pytest -n $(WORKERS) --dist loadfile --no-loadscope-reorder

.PHONY: help install derive test poor check lint thorough validate coverage regenerate installs package explorer bench figures docs check-claims clean
.DEFAULT_GOAL := help

help:
	@echo "make install       set up .venv with all extras, for use without the tests"
	@echo "make derive        derive, check against the article, write generated/"
	@echo "make test          run the quick tests, those marked neither thorough nor validate: what .ci/run runs; some minutes"
	@echo "make poor          run them as on a machine without compiler, heyoka, symbolic links and UTF-8, set up for it"
	@echo "make lint          ruff with its formatter, mypy in strict mode, contracts of imports, clang-format, cppcheck if installed"
	@echo "make thorough      quick and thorough tests, with more random cases: the second job of CI; half an hour"
	@echo "make validate      tests marked validate and all campaigns, by hand; hours, goes on where it was"
	@echo "make coverage      as make thorough, and the lines and branches that they reach; twice the time"
	@echo "make regenerate    derive again and compare generated/ with what is committed"
	@echo "make check         what both jobs of CI run: lint, types, generated/ as committed, quick and thorough tests; and installs"
	@echo "make installs      every extra resolves from wheels on Windows, macOS and Linux, quick tests with the lowest versions, if a registry can be reached"
	@echo "make package       build the wheel and the source distribution into dist/"
	@echo "make bench         time the solvers"
	@echo "make figures       draw the article's figures into figures/"
	@echo "make explorer      bundle the explorer's drawings and libraries anew, with node"
	@echo "make docs          build the documentation into docs/_build/"
	@echo "make check-claims  hold the article's statements against computation"
	@echo "make clean         remove what the other targets made, .venv included"

$(VENV)/.made:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "$(PYTHON) is older than 3.11; name a newer one: make PYTHON=python3.12" >&2; exit 1; }
	@echo "setting up $(VENV)"
	@$(PYTHON) -m venv $(VENV)
	@touch $@

$(LINKS):
	@ln -s ../$(@F) $@

$(DERIVE): $(SOURCES) | $(VENV)/.made $(LINKS)
	@$(EDIT) '.[derive]'
	@touch $@

$(ALL): $(SOURCES) $(COMPILED) | $(VENV)/.made $(LINKS)
	@$(EDIT) '.[all]'
	@$(SAY_COMPILED)
	@touch $@ $(DERIVE)

$(TEST): $(SOURCES) $(COMPILED) | $(VENV)/.made $(LINKS)
	@$(EDIT) '.[all,test,docs]'
	@$(SAY_COMPILED)
	@touch $@ $(DERIVE)

install: $(ALL)
	@echo "now: . $(BIN)/activate && spragsym --help"

derive: $(DERIVE)
	$(BIN)/python -m derive

# As many workers as processors leave none for the threads of OpenBLAS; `make thorough` keeps them, so that both are tested.
test: $(TEST)
	OPENBLAS_NUM_THREADS=1 $(TESTS) -m "not thorough and not validate"

# In an environment of its own, from what is committed.
poor:
	PYTHON=$(PYTHON) .ci/poor -n $(WORKERS) --dist loadfile

lint: $(TEST)
	$(BIN)/ruff check .
	$(BIN)/ruff check --preview --select PLW1514 .  # what a file's encoding is by default differs between machines
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/mypy tests/conformance/user_code.py
	@if command -v node >/dev/null; then $(BIN)/pyright --pythonpath $(BIN)/python tests/conformance/user_code.py; \
	else echo "node is not installed: pyright is skipped, mypy has read the same"; fi
	$(BIN)/lint-imports
	$(BIN)/clang-format --dry-run --Werror $(C_FILES)
	@if command -v cppcheck >/dev/null; then $(CPPCHECK) $(filter %.c,$(C_FILES)); \
	else echo "cppcheck is not installed: skipped, C is checked for its layout only"; fi
	@if command -v check-jsonschema >/dev/null; then check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml; \
	else echo "check-jsonschema is not installed: skipped, the workflow is not checked"; fi

thorough: $(TEST)
	HYPOTHESIS_PROFILE=all $(TESTS) --durations=20 -m "not validate"

# By hand: too long for CI. WORKERS for the tests, campaigns use all cores by themselves.
validate: $(TEST)
	.ci/validate .validate -n $(WORKERS) --dist load

# What they reach of spragsym decides nothing, and to count it doubles the time: CI does not.
coverage: $(TEST)
	HYPOTHESIS_PROFILE=all $(TESTS) --cov --cov-branch --cov-report=term -m "not validate"

# The derivation, then the committed bytes: what went wrong is the last line.
regenerate: $(DERIVE)
	$(BIN)/python -m derive
	git diff --exit-code -- generated/
	@test -z "$$(git status --porcelain -- generated/)" || { git status --short -- generated/; exit 1; }

check: lint regenerate thorough installs

# Every extra from wheels alone, on each machine and Python, and the quick tests with the lowest versions: where a registry can be reached.
installs: $(TEST)
	$(BIN)/python .ci/installs.py
	OPENBLAS_NUM_THREADS=1 $(BIN)/python .ci/installs.py lowest -n $(WORKERS) --dist loadfile --no-loadscope-reorder

package: $(TEST)
	$(BIN)/python -m build --no-isolation --outdir dist .

bench: $(TEST)
	$(BIN)/python -m benchmarks --write docs/performance.md

figures: $(TEST)
	$(BIN)/spragsym figures --out figures --force

# Libraries as the lock file says, then the committed bytes. Users need no node: the package carries the bundle.
explorer:
	cd explorer && npm ci --no-audit --no-fund && node build.mjs

docs: $(TEST)
	$(BIN)/spragsym explore --no-open --force --out docs/_build/explorer.html
	for model in $$($(BIN)/python -c "import runpy; print(*runpy.run_path('docs/gallery.py')['explored']())"); do $(BIN)/spragsym explore --model $$model --no-open --force --out docs/_build/explorer_$$model.html || exit 1; done
	$(BIN)/sphinx-build -W docs docs/_build

check-claims: $(TEST)
	$(BIN)/spragsym check --claims --again

clean:
	rm -rf $(VENV) .lowest build dist figures docs/_build docs/jupyter_execute *.egg-info
	rm -rf .pytest_cache .mypy_cache .ruff_cache .hypothesis .coverage htmlcov
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
