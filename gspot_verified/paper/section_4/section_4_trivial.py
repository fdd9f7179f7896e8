"""Ledger of the trivial solution of the motivating example (Sec. 2), and of its signs in Case I (Sec. 3)."""

from __future__ import annotations

from collections.abc import Mapping

from flint import fmpq_mpoly

from gspot_verified.paper.checks.closed_forms import ClosedForm, rational
from gspot_verified.paper.checks.entry import Builders, Entry, Rung, Section
from gspot_verified.paper.checks.formulas import Forms, FormulaClaim, closed_form, put
from gspot_verified.paper.checks.identities import Claim, Parts
from gspot_verified.paper.section_2.extended_system import extended_terms
from gspot_verified.paper.section_4.section_4_outer import ALGEBRA, around, with_c
from gspot_verified.paper.section_4.section_4_outer import PRINTED as OUTER

_SYMBOLS = ALGEBRA.symbols
PRINTED: dict[str, dict[str, str]] = {
    "2-trivial": {"p": "alpha1*t", "b": "c*alpha1*t", "v": "0*t"},
    "2-trivial-zy": {"z": "-epsilon^2*c", "y": "-2*epsilon^2*c"},
}
CORRECTED: dict[str, dict[str, str]] = {"2-trivial-zy": {"z": "epsilon^2*c", "y": "2*epsilon^2*c"}}
CASE_I = {"alpha1": "-u-w", "alpha2": "-x", "alpha3": "-w"}
"""Case I (Sec. 1) by positive symbols."""
TRIVIAL_SIGNS = {"b p": "1", "force": "-1"}
"""Signs on the trivial solution in Case I, as printed."""
IN_CONTACT = {
    "II": {"alpha1": "-u-w", "alpha2": "x", "alpha3": "-w"},
    "III": {"alpha1": "-w", "alpha2": "-x", "alpha3": "-u-w"},
}
"""Cases II and III."""
CONTACT_SIGNS = {"force": "1"}
"""Contact: y < z, that is λ_N > 0."""
_WITH_C = "c = α_2/(α_1 - α_3) is a symbol"


def _claim(identifier: str) -> Claim:
    return Claim(ALGEBRA, PRINTED[identifier], CORRECTED.get(identifier, {}))


def in_model_system(values: Mapping[str, fmpq_mpoly]) -> list[fmpq_mpoly]:
    """p(0) = 0 and modelsys1 to modelsys5, times epsilon^2 where lambda_N = (z - y)/epsilon^2 enters."""
    p, b, y, v, z = (values[name] for name in "pbyvz")
    epsilon, force = _SYMBOLS["epsilon"], z - y
    found = [
        ALGEBRA.coefficient_of(p, "t", 0),
        _rate(p) - _SYMBOLS["alpha1"],
        epsilon**2 * (_rate(b) - _SYMBOLS["alpha2"]) + _SYMBOLS["alpha3"] * force,
        _rate(y) - v,
        epsilon**2 * (_rate(v) - b) - p * force,
        epsilon * _rate(z) + z + force,
    ]
    return [with_c(value) for value in found]


def recovered(line: fmpq_mpoly, values: Mapping[str, fmpq_mpoly]) -> list[fmpq_mpoly]:
    """The single equation at b = line, and the given variables against what the recovery formulas make of that b."""
    nothing = ALGEBRA.constant(0)
    found = [around(ALGEBRA.read(OUTER["4-eliminated"]["equation"]), line, nothing)]
    for name, value in values.items():
        found.append(around(ALGEBRA.read(OUTER["4-recover"][name]), line, nothing) - _SYMBOLS["alpha3"] * value)
    return found


def first_terms() -> dict[str, fmpq_mpoly]:
    """p_0, b_0, y_0, v_0, z_0 of Theorem 1's recursion for the model system, s as t, alpha2 = c (alpha1 - alpha3)."""
    terms = extended_terms(1, chi=False)
    found = {}
    for name in "pbyvz":
        powers = (ALGEBRA.bring(a) * _SYMBOLS["t"] ** k for k, a in enumerate(terms[name][0]))
        found[name] = sum(powers, start=ALGEBRA.constant(0))
    return found


def _rate(value: fmpq_mpoly) -> fmpq_mpoly:
    return value.derivative("t")


def _corrected(name: str) -> fmpq_mpoly:
    return ALGEBRA.read(CORRECTED["2-trivial-zy"][name])


def _printed(name: str) -> fmpq_mpoly:
    return ALGEBRA.read(PRINTED["2-trivial"][name])


def _trivial() -> Entry:
    this = _claim("2-trivial")

    def single_equation(parts: Parts) -> list[fmpq_mpoly]:
        p = parts["p"]
        motion = [_rate(p) - _SYMBOLS["alpha1"], ALGEBRA.coefficient_of(p, "t", 0)]
        return [*motion, *recovered(parts["b"], {"v": parts["v"]})]

    return Section("Section 2").settled(
        "2-trivial",
        "eqs. modelSysDistP, modelSysDistB, modelSysDistV",
        r"\bar p=\alpha_1^*t,\quad \bar b=\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}\alpha_1^*t,\quad \bar v=0",
        "In contact, ε² λ_N = z - y, and for α_1 ≠ α_3 the motivating example has the solution p = α_1 t, "
        "b = α_2 α_1 t/(α_1 - α_3), v = 0, with the corrected z and y of 2-trivial-zy",
        this.check(
            f"put into modelsys1 to modelsys5; {_WITH_C}",
            lambda parts: in_model_system({**parts, "z": _corrected("z"), "y": _corrected("y")}),
        ),
        this.check(f"b in the equation for b of line 984, v by modelSysRecoverV; {_WITH_C}", single_equation),
        this.check(
            "the terms n = 0 of Theorem 1's recursion with symbols α_1, α_3, c (the later ones: 4-unique)",
            lambda parts: [parts[name] - first_terms()[name] for name in "pbv"],
            Rung.POINTS,
        ),
    )


def _trivial_zy() -> Entry:
    this = _claim("2-trivial-zy")
    return Section("Section 2").settled(
        "2-trivial-zy",
        "eq:modelSysDistZY",
        r"\bar z=\frac{\bar y}2=-\epsilon^2\frac{\alpha_2^*}{\alpha_1^*-\alpha_3^*}",
        "For α_1 ≠ α_3 the deformation of the trivial solution is z = y/2 = -ε² α_2/(α_1 - α_3)",
        this.check(
            f"put into modelsys1 to modelsys5; {_WITH_C}",
            lambda parts: in_model_system({**parts, "p": _printed("p"), "b": _printed("b"), "v": _printed("v")}),
            fault="with the printed sign the two sides of eq. modelsys2, times ε², differ by {left}",
        ),
        this.check(
            "modelSysRecoverY and modelSysRecoverZ with b = c α_1 t",
            lambda parts: recovered(_printed("b"), {"z": parts["z"], "y": parts["y"]}),
            fault="they give z and y with the other sign",
        ),
        this.check(
            "the terms n = 0 of Theorem 1's recursion with symbols α_1, α_3, c",
            lambda parts: [parts[name] - _SYMBOLS["epsilon"] ** 2 * first_terms()[name] for name in "zy"],
            Rung.POINTS,
            fault="they are z and y with the other sign",
        ),
        corrected="z = y/2 = ε² α_2/(α_1 - α_3)",
        note="In the findings c is α_2/(α_1 - α_3). With the corrected sign λ_N = (z - y)/ε² is α_2/(α_3 - α_1), the "
        "limit that Sec. 1 states for Case III. For α_2 = 0 both forms are 0. "
        "The example of Section 5 has the right sign: z_0 = -2 for α = (-1, -1, -3/2).",
    )


def on_trivial(text: str, case: Mapping[str, str] = CASE_I) -> list[str]:
    """A formula of 2-trivial or 2-trivial-zy in a Case, before and after t = 0."""
    image = put(text, c="alpha2/(alpha1-alpha3)")
    return [put(image, t=time, **case) for time in ("tau", "-tau")]


def _in_contact() -> Entry:
    line, rest = PRINTED["2-trivial"], CORRECTED["2-trivial-zy"]

    def signed(forms: Forms, text: str) -> list[ClosedForm]:
        return [forms["force"] * closed_form(force) for case in IN_CONTACT.values() for force in on_trivial(text, case)]

    claim = FormulaClaim(CONTACT_SIGNS)
    return Section("Section 2").settled(
        "2-trivial-contact",
        "lines 599 to 608",
        r"\text{assuming }y<z",
        "In Cases II and III the trivial solution, with the corrected z and y of 2-trivial-zy, is in contact, y < z "
        "and λ_N > 0, at every t other than 0 and every ε, for all α's of the Case",
        claim.check_sign(
            "λ_N = -b/p with b and p of 2-trivial, for all values of the symbols",
            lambda forms: signed(forms, "-({b})/({p})".format(**line)),
        ),
        claim.check_sign(
            "λ_N = (z - y)/ε² with the corrected z and y of 2-trivial-zy",
            lambda forms: signed(forms, "({z}-({y}))/epsilon^2".format(**rest)),
        ),
        note="It is constant, and so positive at t = 0 too. In Case I it is negative: 3-case-I-trivial.",
    )


def _trivial_in_case_i() -> Entry:
    line, rest = PRINTED["2-trivial"], CORRECTED["2-trivial-zy"]
    claim = FormulaClaim(TRIVIAL_SIGNS)

    def by_the_line(forms: Forms) -> list[ClosedForm]:
        product, force = (on_trivial(text.format(**line)) for text in ("({b})*({p})", "-({b})/({p})"))
        signed = [(forms["b p"], text) for text in product] + [(forms["force"], text) for text in force]
        return [sign * closed_form(text) for sign, text in signed]

    def by_the_deformation(forms: Forms) -> list[ClosedForm]:
        force = on_trivial("({z}-({y}))/epsilon^2".format(**rest))
        return [sign * closed_form(text) for text in force for sign in (forms["force"], rational(-1) * forms["b p"])]

    return Section("Section 3").settled(
        "3-case-I-trivial",
        "lines 766 to 767",
        r"bp>0,\text{ implying }\lambda_N<0",
        "In Case I the trivial solution, with the corrected z and y of 2-trivial-zy, has b p > 0 and λ_N < 0, for "
        "all α's of Case I, at every t other than 0",
        claim.check_sign("b p and λ_N = -b/p with b and p of 2-trivial, for all values of the symbols", by_the_line),
        claim.check_sign(
            "λ_N = (z - y)/ε² with the corrected z and y of 2-trivial-zy, and b p = -p² λ_N", by_the_deformation
        ),
    )


ENTRIES: Builders = {"2-trivial": _trivial, "2-trivial-zy": _trivial_zy, "2-trivial-contact": _in_contact}
"""The trivial solution of Sec. 2."""
IN_CASE_I: Builders = {"3-case-I-trivial": _trivial_in_case_i}
"""Its signs in Case I (Sec. 3)."""
