# make verify   set everything up, check the paper's statements, write report/
# make test     set everything up, run the tests
# make quick    the tests that can notice what has changed since the last commit, within 45 s
# make test-all the same with the slow tests, and with those that cost more than the fast set may (tests/costs.py)
# make coverage which lines the tests of make test reach: build/coverage/index.html
# make prove    the formal proofs of proofs/coq/, for which Coq and Coquelicot must be there (it says how to get them)
# make docs     the documentation site, build/docs/index.html; it is read without a network
# make lint     formatting, lint, types, and what a file that concludes may not write (tests/rigour/README.md)
# make attack   questions to the package against independent references: MINUTES=30, OPTIONS="--seed 7 --kind theta" (tests/attack/README.md)
# make mutants  mutation testing: FILES="gspot_verified/numbers/dyadic.py ...", OPTIONS="--sample 20" (tests/mutants/README.md)

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
RUNS := $(VENV)/.runs
READY := $(VENV)/.ready
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile -c constraints.txt

# The tests start many processes of their own: compiled files, also where the environment asks for none, make those quick.
export PYTHONDONTWRITEBYTECODE :=
# One worker a core: threads of linear algebra within a worker only wait for each other.
test quick test-all coverage costs: export OPENBLAS_NUM_THREADS := 1

.PHONY: verify test quick test-all coverage costs prove docs lint mutants attack clean

# Results are kept in build/ledger, under the hash of everything that they depend on; a fresh clone has none. VERIFY=--full runs all again.
# Of formal proofs nothing is kept: they count where VERIFY=--formal has them run now, by prove.py.
# Exit code 1 means that a printed statement of the paper is refuted: that is a result, not a failure of the run.
verify: $(RUNS)
	@$(PYTHON) -I proofs/coq/prove.py --state
	@$(BIN)/gspot-verified verify --output report $(VERIFY); code=$$?; [ $$code -le 1 ] || exit $$code

test: $(READY)
	$(BIN)/pytest -n auto --dist worksteal -m "not slow" --fast
	@$(PYTHON) -I proofs/coq/prove.py --state

quick: $(READY)
	$(BIN)/pytest -n auto --dist worksteal -m "not slow" --fast $$(PYTHONPATH=tests $(BIN)/python -m costs)

test-all: $(READY)
	$(BIN)/pytest -n auto --dist worksteal

# Which lines and branches the tests of `make test` reach.
coverage: $(READY)
	$(BIN)/pytest -n auto --dist worksteal -m "not slow" --fast --cov --cov-report=term:skip-covered --cov-report=html:build/coverage

# What each test costs, for --fast: on a machine that does nothing else.
costs: $(READY)
	$(BIN)/pytest -n auto --dist worksteal -m "not slow" --record-costs

# Coq alone: no virtual environment. Installs nothing.
prove:
	@$(PYTHON) -I proofs/coq/prove.py

docs: $(READY)
	$(BIN)/python -m sphinx -W -q -b html docs build/docs

lint: $(READY)
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/mypy
	PYTHONPATH=tests $(BIN)/python -m rigour

FILES ?= gspot_verified/numbers/dyadic.py gspot_verified/numbers/verdict.py

mutants: $(READY)
	PYTHONPATH=tests $(BIN)/python -m mutants $(FILES) $(OPTIONS)

MINUTES ?= 5

attack: $(READY)
	PYTHONPATH=tests $(BIN)/python -m attack --minutes $(MINUTES) $(OPTIONS)

# What the package itself needs. Files are compiled when they are first imported: of all that is installed a tenth is.
$(RUNS): pyproject.toml constraints.txt
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed: make PYTHON=python3.12 ...")'
	$(PYTHON) -m venv --clear $(VENV)
	$(PIP) -e .
	touch $@

# And on top of it what the tests, the linters and the documentation need.
$(READY): $(RUNS)
	$(PIP) -e '.[test,docs]'
	touch $@

clean:
	rm -rf $(VENV) report build .coverage* *.egg-info .pytest_cache .mypy_cache .ruff_cache .hypothesis
