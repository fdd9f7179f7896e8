"""Hypothesis profiles, the guard against precision leaks, and the sabotage switch.

``HYPOTHESIS_PROFILE=thorough`` runs more examples, drawn at random; the default runs the same examples every time.

``--sabotage ROUTE:EXPONENT`` makes the error bound of one route wrong on purpose, to see that the tests notice:
``negative:20`` shrinks every bound of ``theta_function/sums/negative.py`` by the factor 1 - 2^-20, ``positive:-20``
multiplies every bound of ``theta_function/sums/positive.py`` by 2^-20.
"""

from __future__ import annotations

import ast
import importlib
import os
import random
import re
import resource
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import costs
import pytest
from flint import arb, ctx
from hypothesis import settings

if TYPE_CHECKING:
    from gspot_verified.paper.cache import Cache
    from gspot_verified.paper.checks.entry import Entry

settings.register_profile("default", max_examples=60, deadline=None, derandomize=True, database=None)
settings.register_profile("thorough", max_examples=1000, deadline=None, database=None, print_blob=True)

SABOTAGED_MODULES = {
    place.rpartition(".")[2]: place
    for place in (
        "theta_function.value.majorant",
        "theta_function.value.mean_value",
        "theta_function.sums.taylor",
        "theta_function.sums.splitting",
        "theta_function.sums.negative",
        "theta_function.sums.positive",
        "theta_function.sums.laplace",
        "theta_function.sums.finite_part",
        "theta_function.boxes.box",
        "compliant.slow.grid",
        "compliant.slow.slow_integral",
        "compliant.slow.epsilon_series",
        "compliant.slow.slow_coefficient",
        "compliant.fast.fast_coefficient",
        "compliant.side.side_rule",
        "integrator.box_steps.step",
        "integrator.norm_steps.norm_step",
        "expansion.from_state.affine_hand_over",
        "expansion.from_state.affine_tube",
        "expansion.true_solutions.growth",
        "expansion.true_solutions.piece",
    )
}
_MAX_EXPONENT = 10_000
AddRemainder = Callable[[arb, arb], arb]


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--sabotage",
        metavar="ROUTE:EXPONENT",
        default=None,
        help="make a route's error bound wrong: times 1 - 2^-EXPONENT, or times 2^EXPONENT when EXPONENT < 0 "
        f"({', '.join(SABOTAGED_MODULES)})",
    )

    parser.addoption("--fast", action="store_true", help="leave out the tests that costs.json says are costly")
    parser.addoption("--order-seed", metavar="N", default=None, help="run the tests in an order drawn from N")
    parser.addoption("--record-costs", action="store_true", help="measure every test that runs and write costs.json")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(SharedCosts())
    profile = os.environ.get("HYPOTHESIS_PROFILE", "default")
    if profile not in ("default", "thorough"):
        raise pytest.UsageError(f"HYPOTHESIS_PROFILE must be default or thorough, got {profile!r}")
    settings.load_profile(profile)
    request = config.getoption("--sabotage")
    if request is not None:
        sabotage(*parse_sabotage(request))


def pytest_report_header(config: pytest.Config) -> list[str]:
    request = config.getoption("--sabotage")
    return [] if request is None else [f"SABOTAGE: {request} (the error bound of this route is wrong on purpose)"]


def parse_sabotage(request: str) -> tuple[str, int]:
    """The module name and the exponent of ``ROUTE:EXPONENT``."""
    match = re.fullmatch(r"([a-z_]+):(-?[0-9]{1,5})", request)
    if match is None:
        raise pytest.UsageError(f"--sabotage: expected ROUTE:EXPONENT, such as negative:20, got {request!r}")
    route, exponent = match[1], int(match[2])
    if route not in SABOTAGED_MODULES:
        raise pytest.UsageError(f"--sabotage: ROUTE must be one of {', '.join(SABOTAGED_MODULES)}, got {route!r}")
    if exponent == 0 or abs(exponent) > _MAX_EXPONENT:
        raise pytest.UsageError(f"--sabotage: EXPONENT must be in 1..{_MAX_EXPONENT} or its negative, got {exponent}")
    return route, exponent


def sabotage(route: str, exponent: int) -> None:
    """Replace ``add_remainder`` as the module ``route`` sees it."""
    module = importlib.import_module(f"gspot_verified.{SABOTAGED_MODULES[route]}")
    honest = getattr(module, "add_remainder", None)
    if honest is None:
        raise pytest.UsageError(f"--sabotage: {module.__name__} has no add_remainder to replace")
    module.add_remainder = shrinking(honest, exponent)  # type: ignore[attr-defined]


def shrinking(honest: AddRemainder, exponent: int) -> AddRemainder:
    """``honest`` with its bound multiplied by 1 - 2^-exponent, or by 2^exponent when that is negative."""
    from gspot_verified.numbers.balls import working_bits

    def shrunk(value: arb, bound: arb) -> arb:
        size = bound.abs_upper()
        # At a precision that keeps the product exact. A radius has 30 bits: beyond about 2^-28 nothing gets smaller.
        with working_bits(max(ctx.prec, 128) + abs(exponent)):
            smaller = size - size * arb((1, -exponent)) if exponent > 0 else size * arb((1, exponent))
        return honest(value, smaller)

    return shrunk


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Tests of the whole ledger come last: its entries are then in the cache, from the tests of single entries."""
    if (seed := config.getoption("--order-seed")) is None:
        items.sort(key=lambda item: "whole_ledger" in getattr(item, "fixturenames", ()))
    else:
        random.Random(seed).shuffle(items)
    if config.getoption("--fast"):
        left_out = costs.costly(costs.recorded())
        config.hook.pytest_deselected(items=[item for item in items if item.nodeid in left_out])
        items[:] = [item for item in items if item.nodeid not in left_out]


_COSTS = pytest.StashKey[dict[str, float]]()
_SHARED = pytest.StashKey[float]()


def _processor_seconds() -> float:
    own, children = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return own.ru_utime + own.ru_stime + children.ru_utime + children.ru_stime


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Measure the test with what is set up for it alone, where that is asked for."""
    item.config.stash[_SHARED] = 0.0
    begin = _processor_seconds()
    found = yield
    spent = _processor_seconds() - begin - item.config.stash[_SHARED]
    item.config.stash.setdefault(_COSTS, {})[item.nodeid] = spent
    return found


class SharedCosts:
    """A plugin by itself: for a fixture of the whole session pytest asks no conftest.py below its root."""

    @pytest.hookimpl(wrapper=True)
    def pytest_fixture_setup(self, fixturedef: pytest.FixtureDef[Any], request: pytest.FixtureRequest) -> Iterator[Any]:
        """What several tests share is not charged to the one that comes first: without it the next one would pay."""
        begin = _processor_seconds()
        found = yield
        if fixturedef.scope != "function":
            request.config.stash[_SHARED] = request.config.stash.get(_SHARED, 0.0) + _processor_seconds() - begin
        return found


def _left_out(config: pytest.Config) -> dict[str, float]:
    """The rows of the tests that a run of the fast set does not measure."""
    known = costs.recorded() if config.getoption("--fast") else {}
    return {name: known[name] for name in costs.costly(known)}


def pytest_sessionfinish(session: pytest.Session) -> None:
    """A worker hands its measurements on; the last process writes them."""
    config = session.config
    found = config.stash.get(_COSTS, {})
    if not config.getoption("--record-costs"):
        return
    if hasattr(config, "workeroutput"):
        config.workeroutput["costs"] = found
    else:
        costs.record(_left_out(config) | found)


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """What a worker has measured."""
    node.config.stash.setdefault(_COSTS, {}).update(getattr(node, "workeroutput", {}).get("costs", {}))


@pytest.fixture(scope="session")
def package_trees() -> Mapping[Path, ast.Module]:
    """Every file of the package as it is parsed, once for all tests that read the source."""
    from house.test_layout import FILES, tree_of

    return {path: tree_of(path) for path in FILES}


@pytest.fixture(scope="session")
def ledger_cache(tmp_path_factory: pytest.TempPathFactory) -> Cache:
    """Where all workers of the run keep results of the ledger, so that each entry is found once."""
    from gspot_verified.paper.cache import Cache

    own = tmp_path_factory.getbasetemp()
    return Cache((own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "ledger")


@pytest.fixture(scope="session")
def whole_ledger(ledger_cache: Cache) -> list[Entry]:
    """The whole ledger, run once for all tests that read it."""
    from gspot_verified.paper.verify import verify_paper

    return verify_paper(cache=ledger_cache)


@pytest.fixture(autouse=True)
def precision_is_restored() -> Iterator[None]:
    """flint's precision is one number for the process: no test may leave it changed."""
    before = ctx.prec
    yield
    after = ctx.prec
    ctx.prec = before
    assert after == before, f"the test leaves flint's precision at {after} bits, it was {before}"
