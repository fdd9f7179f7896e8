"""What follows from each error of the paper: nothing, something local, another conclusion. A reading, not a proof."""

from __future__ import annotations

import enum
from dataclasses import dataclass

from gspot_verified.numbers.written import Written


class Reach(enum.Enum):
    """How far an error reaches."""

    NONE = "none"
    LOCAL = "local"
    CONCLUSION = "changes a conclusion"


@dataclass(frozen=True, slots=True)
class Consequence(Written):
    """The reach of an error, and why."""

    reach: Reach
    why: str


def consequence(identifier: str) -> Consequence | None:
    """What follows from the error that a refuted entry shows; None for an entry that has none recorded.

    >>> consequence("4-order").reach.value
    'none'
    """
    return _CONSEQUENCES.get(identifier)


_CONSEQUENCES = {
    "1-beta": Consequence(Reach.LOCAL, "The Introduction alone; everywhere else β is α_3/α_1."),
    "1-stiffness": Consequence(Reach.NONE, "One sentence of the Introduction; k_1 and k_2 are 1/ε² in Sec. 2."),
    "1-poisson": Consequence(Reach.NONE, "The law is named, and not used."),
    "1-colours": Consequence(Reach.LOCAL, "A reader of the figures looks for a line of the wrong colour."),
    "2-unilateral": Consequence(Reach.NONE, "Contact is y = 0 from the next page on."),
    "2-contact-part": Consequence(Reach.NONE, "The equation for b, which is used, has the right sign."),
    "2-coupling": Consequence(Reach.LOCAL, "What χ adds to the example is a coupling of b and p, within slip."),
    "2-trivial-zy": Consequence(
        Reach.LOCAL, "The trivial solution as printed does not solve the equations; nothing later uses its z and y."
    ),
    "3-trivial-shown": Consequence(Reach.LOCAL, "Panel (a) has no such line; the text says so."),
    "3-caption-equations": Consequence(
        Reach.LOCAL, "Who repeats the simulations from the captions has no equation for z."
    ),
    "3-sides": Consequence(
        Reach.CONCLUSION, "Of two sets of initial values the sentence names the wrong one as the set of impacts."
    ),
    "3-case-II": Consequence(
        Reach.CONCLUSION,
        "In Case II, too, a canard stands between the impact and the lift-off; the starts beside it that pass the "
        "G-spot and lift off shrink to it as ε → 0.",
    ),
    "3-table-1-one-series": Consequence(
        Reach.LOCAL, "Which series of ε was used is not printed; the theoretical exponents are right."
    ),
    "3-table-1-y-1_2": Consequence(
        Reach.LOCAL, "One measured exponent; the theoretical one beside it is right, and so is the conclusion."
    ),
    "4-reference": Consequence(Reach.NONE, "The reader finds the equation from the words."),
    "4-order": Consequence(Reach.NONE, "The printed equation is of fourth order, and is used as such."),
    "4-unique-smooth": Consequence(
        Reach.CONCLUSION, "The distinguished trajectory is unique as a formal series, not among smooth functions."
    ),
    "4-inner-fast": Consequence(Reach.NONE, "The limit that is used does not contain the term."),
    "4-inner-scaling-v": Consequence(
        Reach.LOCAL, "The exponents of line 1237 and of Table 1 are those of the right form."
    ),
    "4-behaves-like": Consequence(
        Reach.CONCLUSION, "(-τ)^β alone does not determine Θ; the condition on e_r and e_i before it does."
    ),
    "4-matching-middle": Consequence(Reach.NONE, "The first and the last form of the line are right."),
    "S-mean-force": Consequence(
        Reach.LOCAL, "With the printed sign the mean force of Case III would pull; the Introduction has the right sign."
    ),
    "S-gamma-intervals": Consequence(
        Reach.CONCLUSION, "As printed, lift-off and impact exchange their sides, and the argument for 0 < β < 1 fails."
    ),
    "S-wording": Consequence(Reach.LOCAL, "Θ stands for dΘ/dτ; the argument is about dΘ/dτ."),
    "S-same-situation": Consequence(
        Reach.LOCAL, "The conclusion, an impact, holds; the argument for it is another one than in Cases I and II."
    ),
    "5-kinds": Consequence(Reach.NONE, "The third-order equation that follows is right."),
    "5-letters": Consequence(Reach.NONE, "The equations that follow from it do not contain ξ."),
    "5-brackets": Consequence(Reach.NONE, "The exponents and the factor are meant as the corrected ones."),
    "5-monomial": Consequence(Reach.NONE, "The coefficient that the argument uses is right."),
    "5-xinprime": Consequence(Reach.LOCAL, "One wrong index in a formula of the recursion."),
    "5-example-b-error": Consequence(Reach.LOCAL, "The error of one printed expansion is larger than stated."),
    "5-fast-system": Consequence(Reach.NONE, "M and its eigenvalues are right, and nothing else is used."),
    "5-ansatz-p0": Consequence(Reach.LOCAL, "The exponent and the leading terms of ξ and λ_N hold; p has another one."),
    "5-bpert-v": Consequence(Reach.LOCAL, "One line of the perturbed variables has a factor too many."),
    "6-sign-of-G": Consequence(Reach.LOCAL, "The functions of Appendix B are those of the right sign."),
    "6-attribution": Consequence(Reach.NONE, "A citation."),
    "6-positive-slip": Consequence(
        Reach.LOCAL, "All formulas hold for a belt that is fast enough; without its velocity no run can end in stick."
    ),
    "6-any-beta": Consequence(Reach.LOCAL, "The simulated β = 7/3 is below the bound."),
    "6-colours": Consequence(Reach.LOCAL, "A reader of Figure 13 takes one curve for the other."),
    "A-th5-condition": Consequence(
        Reach.LOCAL, "Where the formulas are used, β is not an integer, and there they hold."
    ),
}
