"""Every command's --json satisfies the schema of the command; the schemas are strict enough to notice a change."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import typer
from jsonschema import Draft202012Validator

from gspot_verified.cli import main
from gspot_verified.cli.app import app, schema_name
from gspot_verified.cli.main import load_commands
from gspot_verified.cli.schema import RESULTS, Schema, schema_of
from gspot_verified.cost.benchmarks.theta import CostReport
from gspot_verified.cost.times.rows import Row, Target, TimeCurve
from gspot_verified.paper.section_4_5 import cases
from gspot_verified.report.check_again import CheckedAgain
from gspot_verified.report.write import Supplement

ROOT = Path(__file__).resolve().parents[2]
FORMS = (
    "theta",
    "side",
    "sign",
    "zeros",
    "iwc",
    "verdict",
    "force",
    "events",
    "simulate",
    "scenes",
    "wrong-sides",
    "simulators",
    "classify",
    "approach",
    "expand",
    "sweep",
    "check",
    "hard-cases",
)
SCHEMAS = sorted(RESULTS)
STATE = "--state=1/2,-2/11,-8/11000000,0,-4/11000000"
RUNS = [
    ("theta", "1", "3/2"),
    ("theta", "0", "3", "--derivative", "1"),
    ("theta", "1+2i", "3/2"),
    ("side", "1/2", "4"),
    ("side", "13/2", "--eps", "1e-3", STATE),
    ("sign", "--tau=-inf..inf", "--beta", "0..1"),
    ("sign", "--tau", "0..1", "--beta", "0..3"),
    ("sign", "--tau=-inf..inf", "--beta", "0..1", "--budget", "1"),
    ("zeros", "--beta", "7/3"),
    ("zeros", "--beta", "3"),
    ("zeros", "--beta", "1..2"),
    ("zeros", "--beta", "1..2", "--budget", "1"),
    ("zeros", "--beta", "5/2", "--eps", "1/100"),
    ("zeros", "--beta", "5", "--eps", "32"),
    ("zeros", "--beta", "17/4..35/8", "--eps", "1"),
    ("iwc", "--beta", "7/3"),
    ("verdict", "--beta", "3/2"),
    ("verdict", "--beta", "3/2", "--from", "p=1/2,b=-2", "--eps", "1e-2", "--within", "1/3"),
    ("iwc", "--beta", "7/3", "--c1", "1", "--epsilon", "1/1000", "--growth"),
    ("iwc", "--beta", "1/2", "--alpha2", "0"),
    ("iwc", "--mechanism", "genot_brogliato_rod"),
    ("iwc", "--mechanism", "frictional_impact_oscillator_all_parameters", "--c1", "1"),
    ("iwc", "--mechanism", "frictional_impact_oscillator_all_parameters", "--epsilon", "2"),
    ("force", "--beta", "5/2", "--eps", "1e-6", "--t", "1e-4"),
    ("force", "--beta", "13/2", "--eps", "1e-3", "--t", "1e-3", STATE, "--certify"),
    ("events", "--beta", "3/2", "--eps", "1e-6", "--nu", "2"),
    ("simulate", "fig-varsim1", "--compare"),
    ("simulate", str(ROOT / "tests" / "scenes" / "hostile" / "c_notang_neg.toml")),
    ("simulate", str(ROOT / "tests" / "scenes" / "hostile" / "c_notang_neg.toml"), "--float"),
    ("simulate", "fig-varsim1", "--nu", "1"),
    ("simulate", "fig-varsim2", "--float", "--set", "chi=0"),
    ("simulate", "rod", "--float", "--set", "until=1/100"),
    ("scenes",),
    ("wrong-sides", "--eps", "1/1000", "--beta", "13/2", "--nu", "2", "--method", "LSODA", "--tolerance", "1e-6"),
    ("simulators", "rod-with-wrist", "--from", "X=0,X_dot=5,theta=4/5,theta_dot=17/5", "--eps", "1e-2"),
    ("classify", "oscillator"),
    ("classify", "rod"),
    ("classify", "rod", "--all"),
    ("classify", "genot_brogliato_rod", "--set", "mu=13/10"),
    ("classify", "genot_brogliato_rod", "--set", "mu=4/3"),
    ("classify", "oscillator", "--box", "phi=0..1"),
    ("approach", "oscillator", "--from", "phi=phi_ref + 1/10,phi_dot=-9/10"),
    ("approach", "model", "--from", "x=0,u=1,p=1/2,b=-2"),
    ("approach", "model", "--from", "x=0,u=3,p=1/2,b=-1"),
    ("expand", "extended", "--order", "3"),
    ("expand", "extended", "--order", "4", "--in-time", "--at", "1,1/10"),
    ("expand", "extended", "--order", "4", "--at", "1,1/10", "--residual", "1,1/10"),
    ("expand", "extended", "--order", "4", "--uniform=-1/4,1/4,1/20"),
    ("expand", "extended", "--order", "4", "--uniform=0,1,9"),
    ("expand", "extended", "--order", "8", "--side=-1,1/50"),
    ("expand", "extended", "--order", "8", "--side=-1,1/5"),
    ("expand", "extended", "--order", "4", "--chi", "symbolic"),
    ("expand", "genot_brogliato_rod", "--order", "3", "--in-time"),
    ("sweep", "oscillator", "--over", "beta=3/2..5/2:2"),
    ("sweep", "oscillator", "--over", "beta=7/4..9/4:2", "--over", "kappa=0..1:2"),
    ("sweep", "genot_brogliato_rod", "--over", "mu=1.3..1.4:1"),
    ("check", str(ROOT / "proofs" / "iwc_0_1.cert")),
    ("check", str(ROOT / "README.md")),
    ("hard-cases", "side", "spots-meet", "certificate"),
]


def printed(capsys: pytest.CaptureFixture[str], *arguments: str) -> dict[str, Any]:
    code = main([*arguments, "--json"])
    assert code in (0, 1, 2)
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return found


def schema(command: str) -> Schema:
    return schema_of(command, schema_name(command))


def errors(command: str, data: object) -> list[str]:
    return [error.message for error in Draft202012Validator(schema(command)).iter_errors(data)]


def test_every_command_that_prints_json_has_a_schema() -> None:
    load_commands()
    found = set()
    for command in app.registered_commands:
        assert command.callback is not None
        if "as_json" in command.callback.__annotations__:
            found.add(command.name or command.callback.__name__.replace("_", "-"))
    assert found == set(SCHEMAS)
    assert isinstance(app, typer.Typer)


@pytest.mark.parametrize("command", SCHEMAS)
def test_schemas_are_schemas(command: str) -> None:
    found = schema(command)
    Draft202012Validator.check_schema(found)
    assert found["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert found["$id"] == schema_name(command)
    assert found["$id"].startswith(f"gspot-verified/{command}/")
    for variant in found["anyOf"]:
        assert variant["properties"]["schema"] == {"const": found["$id"]}
        assert "schema" in variant["required"]


@pytest.mark.parametrize("arguments", RUNS, ids=" ".join)
def test_what_is_printed_satisfies_the_schema(capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...]) -> None:
    data = printed(capsys, *arguments)
    assert errors(arguments[0], data) == []
    for other in changes(data):
        assert errors(arguments[0], other) != []


def changes(data: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """The same with one key more, one key less, a float in the place of an exact number."""
    yield {**data, "surprise": 1}
    yield {key: value for key, value in data.items() if key != "schema"}
    yield {**data, "schema": "gspot-verified/nothing/1"}
    if "verdict" in data:
        worse = copy.deepcopy(data)
        worse["verdict"]["outcome"] = "true"
        yield worse
    for name in ("beta", "alpha_1", "t"):
        if name in data:
            yield {**data, name: 0.5}


def test_every_form_was_run() -> None:
    assert {arguments[0] for arguments in RUNS} == set(FORMS)
    assert set(SCHEMAS) >= {*FORMS, "verify", "report", "cost"}


def test_verify_and_report(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    entries = [cases.ENTRIES["S-iwc"]()]
    monkeypatch.setattr("gspot_verified.paper.verify.verify_paper", lambda *_: entries)
    monkeypatch.setattr("gspot_verified.report.write.write_report", lambda *_: None)
    whole = printed(capsys, "verify", "--output", str(tmp_path), "--cache", str(tmp_path))
    assert errors("verify", whole) == []
    named = printed(capsys, "verify", "S-iwc", "--cache", str(tmp_path))
    assert errors("verify", named) == []
    assert named["run"] == {"entries": 1, "now": 1, "cached": 0}
    assert printed(capsys, "verify", "S-iwc", "--cache", str(tmp_path))["run"] == {"entries": 1, "now": 0, "cached": 1}
    for other in changes(whole):
        assert errors("verify", other) != []
    source = tmp_path / "report.json"
    source.touch()
    monkeypatch.setattr("gspot_verified.report.write.render_report", lambda *_: tmp_path / "index.html")
    assert errors("report", printed(capsys, "report", str(source), "--output", str(tmp_path))) == []
    made = Supplement((tmp_path / "errata.tex",), ("no LaTeX",))
    monkeypatch.setattr("gspot_verified.report.write.write_supplement", lambda *_: made)
    assert errors("report", printed(capsys, "report", str(source), "--supplement", str(tmp_path))) == []
    again = [CheckedAgain("iwc_0_1.cert", True, "VERIFIED")]
    monkeypatch.setattr("gspot_verified.report.check_again.check_report", lambda *_: again)
    assert errors("report", printed(capsys, "report", "--check", str(tmp_path))) == []


def test_cost(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    rows = (Row("case", "asked", Target("cold", 0.005, "s"), 0.001), Row("case", "asked", Target("x", 8), None))
    report = CostReport(rows, (), (TimeCurve("it", ((10, 0.5),)),), ("remark",), False, 1.5)
    monkeypatch.setattr("gspot_verified.cost.benchmarks.theta.run", lambda *_: report)
    data = printed(capsys, "cost", "theta")
    assert errors("cost", data) == []
    assert errors("cost", {**data, "rows": [{}]}) != []


def test_equal_names_mean_equal_things() -> None:
    """A definition that several schemas share is the same in all of them."""
    shared: dict[str, Any] = {}
    for command in SCHEMAS:
        for name, definition in schema(command).get("$defs", {}).items():
            assert shared.setdefault(name, definition) == definition, (command, name)
    assert {"rational", "enclosure", "verdict"} <= set(shared)


def test_the_command_line_prints_a_schema(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--schema", "sign"]) == 0
    assert json.loads(capsys.readouterr().out) == schema("sign")
    assert main(["--schema", "figure"]) == 64
    assert "expected one of theta, side" in capsys.readouterr().err
