"""Typed premises: equations and definitions that no entry claims, and that the checks of entries rest on."""

from __future__ import annotations

from paper.typed.row import CONSTANTS, Names, Row, difference, of_side

from gspot_verified.paper.section_1 import section_1_negative_p, section_1_rigid, section_1_sentences
from gspot_verified.paper.section_2 import general_system, no_trivial_solution, section_2_contact, section_2_sentences
from gspot_verified.paper.section_3 import section_3_captions, varsim2
from gspot_verified.paper.section_4 import section_4_inner, section_4_unique
from gspot_verified.paper.section_5 import section_5_recursion, section_5_smoothest
from gspot_verified.paper.section_6 import section_6_sentences

_AS_FUNCTIONS = CONSTANTS | {rf"\alpha_{k}(\xi)": f"a{k}" for k in (1, 2, 3)} | {r"F(\xi)": "f", r"G(\xi)": "g"}


def _projected() -> list[Row]:
    """Newton's law at the contact point, with the arguments of its functions, and Coulomb's law."""
    names = {r"a(q,\dot{q},t)": "a", r"b(q,\dot{q},t)": "b", r"\lambda_{T}": "lamT", r"\lambda_{N}": "lam"}
    names |= {rf"\c{letter}(q,t)": letter for letter in "ABC"}
    of_v = (("1-mirror", section_1_sentences.PROJECTED["v"]), ("1-force", section_1_rigid.NORMAL))
    found = [Row(entry, "dv/dt", {"dv/dt": text}, 146, 147, 0, of_side(1), names) for entry, text in of_v]
    found.append(Row("1-mirror", "u", section_1_sentences.PROJECTED, 144, 145, 0, of_side(1), names))
    forwards, backwards = (CONSTANTS | {"(u)": sign} for sign in ("1", "0-1"))
    edge = {r"\lambda_N": "1"}
    slips: tuple[tuple[str, str, str, Names], ...] = (
        ("1-mirror", "forwards", section_1_sentences.FRICTION["forwards"], forwards),
        ("1-mirror", "backwards", section_1_sentences.FRICTION["backwards"], backwards),
        ("1-force", "friction", section_1_rigid.TANGENTIAL, forwards),
        ("2-two-forces", "forward edge", section_2_sentences.EDGES["lp"], forwards | edge),
        ("2-two-forces", "backward edge", section_2_sentences.EDGES["lm"], backwards | edge),
    )
    return found + [Row(entry, part, {part: text}, 158, 162, 1, of_side(1), read) for entry, part, text, read in slips]


def _defined() -> list[Row]:
    """What p, b, v and the α's are, as Lie derivatives along F and along G of positive slip."""
    names = CONSTANTS | {rf"\alpha_{k}": f"alpha{k}" for k in (1, 2, 3)}
    names |= {rf"\mathsterling_{field} {name}": f"L{field}{name}" for field in "FG" for name in "pbyv"}
    places = (
        ("LGv", 473, 476, 0, "({0})-({2})"),
        ("LFp", 473, 476, 1, "({0})-({1})"),
        ("LFb", 473, 476, 2, "({0})-({1})"),
        ("LGb", 473, 476, 3, "({1})-({0})"),
        ("LFy", 452, 452, 1, "({0})-({1})"),
        ("LFv", 453, 453, 1, "({0})-({1})"),
    )
    return [
        Row(
            "2-slip-equations",
            part,
            general_system.DEFINED,
            first,
            last,
            piece,
            lambda sides, form=form: form.format(*(sides[k] if f"{{{k}}}" in form else "" for k in range(3))),
            names,
            # -α_3 = L_G b is printed as α_3 = -L_G b.
            lambda table, part=part: f"{table[part]}-{part}" if part != "LGb" else f"-{part}+({table[part]})",
        )
        for part, first, last, piece, form in places
    ]


def _contact() -> list[Row]:
    """The springs and the damper, and their constants as powers of ε."""
    names = CONSTANTS | {"k_1": "k1", "k_2": "k2", r"y(\xi)": "1"}
    balance, constants = section_2_contact.BALANCE, section_2_contact.CONSTANTS
    force = section_2_contact.COMPLIANT["force"]
    found = [
        Row("2-compliant", "z", balance, 530, 533, 0, of_side(1), names),
        # The condition y < z follows without a comma: its y is read as a factor.
        Row("2-compliant", "y", balance, 537, 537, 0, of_side(0, "1/y"), names, lambda p: f"{p['y']} + lam"),
        Row(
            "2-contact-condition", "force", {"force": section_2_sentences.FORCE}, 537, 537, 0, of_side(0, "1/y"), names
        ),
        Row(
            "2-compliant",
            "force",
            {"force": force},
            580,
            580,
            0,
            of_side(0),
            names,
            lambda p: f"({p['force']})/epsilon^2",
        ),
    ]
    powers = {name: f"1/epsilon^{-power}" for name, power in constants.items()}
    places = (("k1", 0, 2), ("k2", 0, 2), ("c", 1, 1))
    return found + [
        Row("2-compliant", name, powers, 546, 549, piece, of_side(side), names) for name, piece, side in places
    ]


def _model_again() -> list[Row]:
    """The motivating example and the acceleration in slip where other files hold them."""
    names = CONSTANTS | {r"\lambda_N": "(lam/epsilon^2)"}
    found = []
    for k, (name, rate) in enumerate(section_3_captions.EQUATIONS.values()):
        read = names if name == "z" else CONSTANTS
        found.append(Row("3-after-contact", name, {name: rate}, 592 + k, 592 + k, 0, of_side(1), read))
    slip = {"dv/dt": section_1_negative_p.ACCELERATION}
    return [*found, Row("1-negative-p", "dv/dt", slip, 495, 496, 0, of_side(1), CONSTANTS | {r"\lambda_N": "l"})]


def _slip_again() -> list[Row]:
    """The extended example in positive slip, c = 1, and rigid slip, where other files hold them."""
    # The constants of eq. newex6; λ_N in a rate, (z - y)/ε² in that of z.
    slip = CONSTANTS | {"c": "1", "p^-": "1", "a": "0", "k^+": "0-1", "k^-": "2"}
    slip |= {r"\lambda^+": "lam", r"\lambda^-": "0"}
    flow, force = varsim2.SLIP, {r"\lambda_N": "((z-y)/epsilon^2)"}
    found = [Row("3-large-slip", "u", flow, 650, 652, 0, of_side(1), slip)]
    found += [
        Row("3-large-slip", name, flow, line, line, 0, of_side(1), slip | (force if name == "z" else {}))
        for name, line in zip("pbyvz", (669, 670, 672, 673, 674), strict=True)
    ]
    rates = no_trivial_solution.RATES | {"v": no_trivial_solution.BALANCE}
    constant = slip | {r"\lambda_N": "L"}
    found += [
        Row("2-no-trivial", name, rates, line, line, 0, of_side(1), constant)
        for name, line in zip("pbv", (669, 670, 673), strict=True)
    ]
    names = CONSTANTS | {rf"\alpha_{{{k}}}": f"alpha{k}" for k in (1, 2, 3)}
    rigid = section_5_smoothest.SLIP
    return found + [
        Row("5-smoothest-graph", name, rigid, line, line, 0, of_side(1), names)
        for name, line in (("p", 253), ("b", 254))
    ]


def _two_forces() -> list[Row]:
    names = CONSTANTS | {"k^+": "kplus", "k^-": "kminus", r"\lambda^+": "lp", r"\lambda^-": "lm"}
    shares, extended = section_2_sentences.SHARES, section_2_sentences.EXTENDED
    return [
        Row("2-two-forces", "lp", shares, 632, 634, 0, of_side(1), names),
        Row("2-two-forces", "lm", shares, 632, 634, 1, of_side(1), names),
        Row("2-tangential", "x", extended, 622, 622, 0, of_side(1), names),
        Row("2-tangential", "u", extended, 650, 652, 0, of_side(1), names),
    ]


def _inner_scale() -> list[Row]:
    scale = {name: str(value) for name, value in section_4_inner.INNER_SCALE.items()}
    typed = CONSTANTS | {r"\epsilon": scale["epsilon"]}
    first = CONSTANTS | {"b_1": "f0", r"\frac{db_1}{dt}": "f1"}
    return [
        Row("4-inner", "t", scale, 1144, 1146, 0, of_side(1), CONSTANTS),
        # δ = ε^(1/3) with the typed ε.
        Row("4-inner", "epsilon", scale, 1144, 1146, 1, of_side(1), typed, lambda _: "delta"),
        Row("4-unique", "order n", section_4_unique.PRINTED["4-unique"], 1040, 1042, 0, of_side(0), first),
    ]  # fmt: skip


def _general() -> list[Row]:
    """The full system of Sec. 5, its synchronisation, and the scaling of its variables."""
    rates = _AS_FUNCTIONS | {rf"\dot{{{name}}}": f"{name}d" for name in "pbyvz"} | {r"\dot{\xi}": "xd"}
    system = {name: text for name, (text, _) in section_5_recursion.GENERAL.items()}
    lines = (1338, 1339, 1340, 1341, 1342, 1343, 1345)
    found = [
        Row("5-inner-system", f"{name}, not scaled", {f"{name}, not scaled": text}, line, line, 0, difference, rates)
        for (name, text), line in zip(system.items(), lines, strict=True)
    ]
    at_once = {f"{name}(t_0)": name for name in "pbyv"}
    at_once |= {rf"\{name}{name.upper()}(\xi(t_0))": name.upper() for name in "pbyv"}
    found += [
        Row(
            "5-scaled-start",
            f"{name}, not scaled",
            {f"{name}, not scaled": section_5_recursion.SYNCHRONISED[name]},
            1348,
            1350,
            piece,
            lambda sides: f"({sides[1]})-({sides[0]})",
            at_once,
        )
        for piece, name in enumerate("YVPB")
    ]
    scaled = CONSTANTS | {rf"\tilde{{{name}}}(s,\delta)": name for name in "pbyvz"}
    scaled |= {r"\tilde{\xi}(s,\delta)": "xi", r"\xi^*": "0"}
    powers = {name: f"delta^{power}*{name}" for name, power in section_5_recursion.SCALING.items()}
    places = (("xi", 1385), ("p", 1386), ("b", 1387), ("y", 1388), ("v", 1389), ("z", 1390))
    return found + [Row("5-inner-system", name, powers, line, line, 0, of_side(1), scaled) for name, line in places]


def _oscillator() -> list[Row]:
    names = CONSTANTS | {r"\cos(\phi)": "C", r"\sin(\phi)": "S", r"\dot{\phi}": "w"}
    start = section_6_sentences.IN_CONTACT
    return [
        Row("6-starts", name, start, 2199, 2201, piece, of_side(1), names) for piece, name in enumerate(("psi", "x"))
    ]


ROWS = [
    *_projected(), *_defined(), *_contact(), *_model_again(), *_slip_again(),
    *_two_forces(), *_inner_scale(), *_general(), *_oscillator(),
]  # fmt: skip
