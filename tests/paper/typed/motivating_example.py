"""Typed formulas of Sections 1, 2 and 4: the rigid system, the motivating example, the extended one."""

from __future__ import annotations

from paper.typed.row import CONSTANTS, QUOTIENT, Row, jets, of_side, order_of, rows

from gspot_verified.paper.section_1 import section_1_cases, section_1_rigid
from gspot_verified.paper.section_2 import general_system, lagrangian, section_2_contact, section_2_sentences
from gspot_verified.paper.section_4 import (
    section_4_fast,
    section_4_inner,
    section_4_matching,
    section_4_outer,
    section_4_slow,
    section_4_trivial,
    section_4_unique,
)
from gspot_verified.paper.section_4_5 import cases, section_4_5, section_4_5_signs
from gspot_verified.paper.section_5 import section_5_matching


def _section_1_and_2() -> list[Row]:
    rigid, trivial, extended = section_1_rigid.PRINTED, section_4_trivial, lagrangian.PRINTED
    names = CONSTANTS | {
        r"\cC": "C",
        r"\cB": "B",
        r"\alpha_{1}": "alpha1",
        r"\alpha_{2}": "alpha2",
        r"\alpha_{3}": "alpha3",
    }
    found = rows(
        "1-force", rigid, names, ("p times the force", 168, 171, 0, of_side(1, "p")), ("p", 168, 171, 1, of_side(1))
    )
    found += rows("1-rescaled", rigid, names, ("p", 253, 253, 0, of_side(1)), ("b", 254, 254, 0, of_side(1)))
    fields = {r"F(\xi)": "F", r"G_T(\xi)": "T", r"G_N(\xi)": "N", r"G(\xi)": "(N - mu*T)", r"\lambda_T": "lamT"}
    found += rows(
        "2-slip-equations",
        {"2-slip-equations": general_system.SYSTEM},
        fields | {r"\lambda_N": "r"},
        ("rate", 442, 442, 0, of_side(1)),
        ("in slip", 469, 470, 0, of_side(1)),
    )
    functions = CONSTANTS | {rf"\alpha_{k}(\xi)": f"alpha{k}" for k in (1, 2, 3)} | {r"\lambda_N": "r"}
    found += rows(
        "2-slip-equations",
        {"2-slip-equations": general_system.PRINTED},
        functions,
        ("p", 486, 488, 0, of_side(1)),
        ("b", 489, 491, 0, of_side(1)),
        ("y", 492, 494, 0, of_side(1)),
        ("v", 495, 496, 0, of_side(1)),
    )
    found += rows(
        "2-motivating",
        {"2-motivating": general_system.MODEL},
        CONSTANTS | {rf"\alpha_{k}^*": f"alpha{k}" for k in (1, 2, 3)} | {r"\lambda_N": "r"},
        *((part, 592 + k, 592 + k, 0, of_side(1)) for k, part in enumerate("pbyv")),
    )
    of_contact = CONSTANTS | {r"\lambda_N": "((z-y)/epsilon^2)"}
    examples = (
        (section_2_sentences.MOTIVATING, (592, 593, 594, 595, 596)),
        (
            section_2_sentences.EXTENDED,
            (669, 670, 672, 673, 674),
        ),
    )
    for table, lines in examples:
        for part, line in zip("pbyvz", lines, strict=True):
            read = of_contact if part == "z" else CONSTANTS | {"p^-": "q"}
            found.append(Row("2-extended-equations", part, table, line, line, 0, of_side(1), read))
    contact = {"2-compliant": section_2_contact.COMPLIANT}
    for line in (576, 596):
        found += rows("2-compliant", contact, CONSTANTS, ("z", line, line, 0, of_side(1)))
    forced = CONSTANTS | {rf"\alpha_{k}(\xi)": f"alpha{k}" for k in (1, 2, 3)}
    for entry, table, read, first, last in (
        ("1-rescaled", section_1_rigid.RATES, forced, (486, 488), (489, 491)),
        ("1-case-I", section_1_cases.RATES, names, (253, 253), (254, 254)),
    ):
        for part, lines in (("p", first), ("b", last)):
            found.append(Row(entry, f"{part}, rate", {f"{part}, rate": table[part]}, *lines, 0, of_side(1), read))
    for part, line in (("p", 602), ("b", 603), ("v", 605)):
        found.append(
            Row(
                "2-trivial",
                part,
                trivial.PRINTED["2-trivial"],
                line,
                line,
                0,
                of_side(1),
                CONSTANTS,
                lambda p, part=part: p[part].replace("c", QUOTIENT),
            )
        )
    for part, times in (("z", "1"), ("y", "2")):
        found.append(
            Row(
                "2-trivial-zy",
                part,
                trivial.PRINTED["2-trivial-zy"],
                604,
                604,
                0,
                of_side(2, times),
                CONSTANTS,
                lambda p, part=part: p[part].replace("*c", f"*{QUOTIENT}"),
            )
        )
    slip = (
        CONSTANTS
        | {"k^+": "kplus", "k^-": "kminus", "p^-": "pminus", "F(\\xi)": "F"}
        | {rf"\xi_{k}": f"x{k}" for k in range(1, 7)}
    )
    found.append(
        Row(
            "2-stick",
            "share",
            extended["2-stick"],
            656,
            659,
            0,
            of_side(1),
            slip,
            lambda p: f"({p['numerator']})/({p['denominator']})",
        )
    )
    found += rows(
        "2-extended",
        extended,
        slip,
        *((part, 684, 688, k, of_side(1)) for k, part in enumerate(("p-", "k+", "k-", "a"))),
    )
    field = (
        [f"F{k}" for k in range(1, 7)]
        + [f"H{k}" for k in range(1, 7)]
        + [f"N{k}" for k in range(1, 7)]
        + ["mu", "x", "y"]
    )
    found += rows(
        "2-extended",
        extended,
        slip,
        *((part, 694, 701, k, of_side(-1, "2*(1-x5)" if part[0] == "H" else "1")) for k, part in enumerate(field)),
    )
    quantities = ("u", "v", "p", "b", "alpha_1", "alpha_2", "alpha_3")
    found += rows(
        "2-quantities", extended, slip, *((part, 705, 707, k, of_side(1)) for k, part in enumerate(quantities))
    )
    return found


def _section_4() -> list[Row]:
    outer, inner, fast, slow, unique = (
        module.PRINTED
        for module in (section_4_outer, section_4_inner, section_4_fast, section_4_slow, section_4_unique)
    )
    plain, hatted = CONSTANTS | jets("b", "t", "b"), CONSTANTS | jets(r"\hat{b}", "t", "b")
    recovered = ("y", "v", "z", "lambda")
    found = rows("4-eliminated", outer, plain, ("equation", 983, 985, 0, of_side(0)))
    of_difference = plain | {
        r"\alpha_2": "alpha2",
        "(z-y)": "1",
        r"(\dot{z}-\dot{y})": "1",
        r"(\ddot{z}-\ddot{y})": "1",
    }
    found += rows("4-difference", outer, of_difference, *((str(k), 978, 980, k, of_side(1)) for k in range(3)))
    found += rows(
        "4-recover", outer, plain, *((part, 990 + k, 990 + k, 0, of_side(1)) for k, part in enumerate(recovered))
    )
    for part, line, name in (("order 0", 1026, "b_0"), ("order n", 1045, "b_n")):
        symbol = "b" if part == "order 0" else "f"
        found += rows("4-unique", unique, CONSTANTS | jets(name, "t", symbol), (part, line, line + 2, 0, of_side(0)))
    found.append(
        Row(
            "4-unique",
            "b",
            unique["4-unique"],
            1051,
            1053,
            0,
            of_side(1),
            CONSTANTS | {r"\beta": "alpha3/alpha1"},
            lambda p: p["b"].replace("c", QUOTIENT),
        )
    )
    found += rows("4-deviation", outer, hatted, ("equation", 1066, 1069, 0, of_side(0)))
    found += rows(
        "4-deviation-recover",
        outer,
        hatted,
        *((part, 1073 + k, 1073 + k, 0, of_side(1)) for k, part in enumerate(recovered)),
    )
    found += rows("4-fast", fast, CONSTANTS | jets(r"\hat{b}", "t_f", "f"), ("equation", 1086, 1091, 0, of_side(0)))
    found += rows("4-fast-polynomial", fast, CONSTANTS, ("polynomial", 1095, 1097, 0, of_side(0)))
    found.append(
        Row(
            "4-discriminant",
            "discriminant",
            fast["4-discriminant"],
            1108,
            1108,
            0,
            of_side(1),
            CONSTANTS,
            layout="inline",
        )
    )
    found += rows("4-slow", slow, hatted, ("equation", 1117, 1119, 0, of_side(0)))
    found += rows(
        "4-slow", slow, hatted, *((part, 1130, 1136, k, of_side(1, "alpha1*t")) for k, part in enumerate(recovered))
    )
    scaled = CONSTANTS | jets(r"\hat{b}", "s", "g")
    found += rows("4-inner", inner, scaled, ("equation", 1149, 1151, 0, of_side(0)))
    found += rows(
        "4-inner-fast", inner, CONSTANTS | jets(r"\hat{b}", "s_f", "f"), ("equation", 1160, 1162, 0, of_side(0))
    )
    found.append(
        Row(
            "4-inner-fast-polynomial",
            "polynomial",
            inner["4-inner-fast-polynomial"],
            1164,
            1164,
            0,
            of_side(0),
            CONSTANTS,
            layout="inline",
        )
    )
    found += rows("4-inner-slow", inner, scaled, ("equation", 1170, 1172, 0, of_side(0)))
    theta = CONSTANTS | {r"\frac{d^3}{d\tau^3}\theta": "h3", r"\frac{d}{d\tau}\theta": "h1", r"\theta": "h0"}
    found += rows("4-theta", inner, theta, ("equation", 1179, 1182, 0, of_side(0)))
    found.append(
        Row(
            "4-theta",
            "equation of Appendix A",
            inner["4-theta"],
            2370,
            2373,
            0,
            of_side(0),
            theta,
            lambda p: p["equation"],
        )
    )
    found += rows("5-perturbation-theta", section_5_matching.PRINTED, theta, ("equation", 1179, 1182, 0, of_side(0)))
    branch = CONSTANTS | {"C_1": "1", "(-t)": "w"}
    found.append(
        Row("4-slow", "exponent", slow["4-slow"], 1124, 1124, 0, of_side(0), branch, lambda p: f"w^({p['exponent']})")
    )
    found += rows("4-theta", inner, CONSTANTS, ("kappa cubed", 1175, 1177, 1, lambda sides: f"({sides[1]})^3"))
    for k, part in enumerate(recovered):
        entry = "4-inner-scaling-v" if part == "v" else "4-inner-scaling"
        size = {"y": "epsilon^2", "v": "epsilon", "z": "epsilon^2", "lambda": "1"}[part]
        hat = {"y": r"\hat{y}", "v": r"\hat{v}", "z": r"\hat{z}", "lambda": r"\hat{\lambda}_N"}[part]
        found += rows(entry, inner, scaled, (part, 1192, 1197, k, of_side(1)))
        found += rows(
            entry, inner, scaled | {hat: size, r"\alpha_3^*": "1"}, (f"{part} factor", 1192, 1197, k, of_side(0))
        )
    matching = section_4_matching.PRINTED
    positive = CONSTANTS | {"s": "-x", "t": "-w", "C_1": "1", r"\Theta(\kappa s,\beta)": "1"}
    logs = {"K": "log(kappa)", "E": "log(epsilon)", "S": "log(x)"}

    def power(text: str) -> str:
        for name, value in logs.items():
            text = text.replace(name, value)
        return f"exp({text})"

    whole = matching["4-matching"]
    found += [
        Row("4-matching", "scale", whole, 1224, 1228, 0, of_side(1), positive, lambda p: power(p["scale"])),
        Row(
            "4-matching",
            "argument",
            whole,
            1224,
            1228,
            0,
            of_side(2),
            positive,
            lambda p: power(f"{p['scale']}+beta*({p['argument']})"),
        ),
        Row("4-matching", "outer", whole, 1224, 1228, 0, of_side(4), positive, lambda p: f"w^({p['outer']})"),
        Row(
            "4-matching-middle",
            "middle",
            matching["4-matching-middle"],
            1224,
            1228,
            0,
            of_side(3),
            positive,
            lambda p: power(p["middle"]),
        ),
    ]
    for k, part in enumerate(("b", "y", "v", "z", "lambda")):
        found.append(
            Row(
                "4-exponents",
                part,
                matching["4-exponents"],
                1235 + k,
                1235 + k,
                0,
                order_of(1),
                CONSTANTS,
                lambda p, part=part: f"epsilon^(({p[part]})/3)",
            )
        )
    slope = CONSTANTS | {r"\frac{d\Theta}{d\tau}(\tau,\beta)": "slope", "C_1": "C_1"}
    both = {**section_4_5.PRINTED["S-mean-force"], "deviation": section_4_5.PRINTED["S-deviation-force"]["force"]}
    found.append(
        Row(
            "S-deviation-force",
            "sum with S-mean-force",
            both,
            1249,
            1252,
            0,
            of_side(2),
            slope,
            lambda p: f"{p['force']} + {p['deviation']}",
        )
    )
    signs = section_4_5_signs.PRINTED
    found += rows("S-zero", signs, CONSTANTS, ("sign of", 1264, 1264, 0, of_side(0)))
    found += rows("S-plus-infinity", signs, CONSTANTS, ("sign of", 1265, 1265, 0, of_side(0)))
    found.append(Row("S-side", "side", cases.PRINTED["S-side"], 1300, 1300, 0, of_side(0), slope, layout="inline"))
    return found


ROWS = [*_section_1_and_2(), *_section_4()]
