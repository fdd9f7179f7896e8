"""Why each refuted statement is wrong, in one line, and what follows: nothing, something local, another conclusion.

What follows is a reading of the paper, not a proof; the reason says what the checks of the entry show.
"""

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
    """The reach of an error, the one-line reason why the printed form is wrong, and why the error reaches so far.

    ``table``: the table of the paper whose cells the error is about; errors of one table are one item of the errata.
    """

    reach: Reach
    reason: str
    why: str
    table: str = ""


def consequence(identifier: str) -> Consequence | None:
    """What follows from the error that a refuted entry shows; None for an entry that has none recorded.

    >>> consequence("4-order").reach.value
    'none'
    """
    return _CONSEQUENCES.get(identifier)


_CONSEQUENCES = {
    "1-beta": Consequence(
        Reach.LOCAL,
        "In Case III α_1/α_3 is between 0 and 1; (-t)^β solves eq. (46) at ε = 0 for β = α_3/α_1 alone.",
        "The Introduction alone; everywhere else β is α_3/α_1.",
    ),
    "1-stiffness": Consequence(
        Reach.NONE,
        "Eq. (19) has k_1 = k_2 = 1/ε², and only a stiffness that grows gives the rigid limit.",
        "One sentence of the Introduction; k_1 and k_2 are 1/ε² in Sec. 2.",
    ),
    "1-poisson": Consequence(
        Reach.NONE,
        "The contact pushes in both phases, so both impulses are positive.",
        "The law is named, and no formula uses it.",
    ),
    "1-colours": Consequence(
        Reach.LOCAL,
        "The captions of Figures 3 and 4 name another colour than the text.",
        "One of the two sends a reader of the figures to a line of the wrong colour.",
    ),
    "1-scalars": Consequence(Reach.NONE, "Eqs. (1) and (2) have a, b, A, B and C, and no D.", "No formula has a D."),
    "2-unilateral": Consequence(
        Reach.NONE, "Contact is y = 0, which y > 0 leaves out.", "Contact is y = 0 in lines 502 and 508."
    ),
    "2-contact-part": Consequence(
        Reach.NONE,
        "In eq. (36) the term has the minus sign, like α_3 λ_N in eq. (23).",
        "The equation for b, which is used, has the right sign.",
    ),
    "2-coupling": Consequence(
        Reach.LOCAL,
        "In slip neither x nor u enters eqs. (35) to (39), for any χ.",
        "What χ adds to the example is a coupling of b back to p, in slip and in stick.",
    ),
    "2-trivial-zy": Consequence(
        Reach.LOCAL,
        "λ_N = (z - y)/ε² = α_2/(α_3 - α_1) on this solution; the printed sign gives its negative.",
        "The trivial solution as printed does not solve the equations. Lines 1054 to 1057 and 1885 to 1887 refer to "
        "its z and y, the exponent 1.6538 of Table 1 is by this sign, and the mean force of line 1250 has it; the "
        "other exponents of Table 1 are those of the right sign, and no side is found from it.",
    ),
    "3-trivial-shown": Consequence(
        Reach.LOCAL,
        "The text says that the solution is unphysical in panel (a), and not shown.",
        "Panel (a) has no such line; the text says so.",
    ),
    "3-caption-equations": Consequence(
        Reach.LOCAL,
        "Eqs. (22) to (25) contain λ_N, which needs z of eq. (26) by eq. (21).",
        "Who repeats the simulations from the captions has no equation for z.",
    ),
    "3-sides": Consequence(
        Reach.CONCLUSION,
        "All b(0) are negative: the sentence holds for |b(0)| and fails for b(0).",
        "Of two sets of initial values the sentence names the wrong one as that of impacts without a lift-off before.",
    ),
    "3-case-II": Consequence(
        Reach.CONCLUSION,
        "λ_N is constant on the trivial solution, and some starts beside it pass p = 0 and lift off.",
        "In Case II, too, a canard stands between the impact and the lift-off; the starts beside it that pass the "
        "G-spot and lift off shrink to it as ε → 0, at leading order.",
    ),
    "3-table-1-one-series": Consequence(
        Reach.LOCAL,
        "Over any one series of ε <= 1/2500, 1 % apart or more, two of the slopes are closer than printed.",
        "Which series of ε was used is not printed; the theoretical exponents are right.",
        table="Table 1(a)",
    ),
    "3-table-1-y-1_2": Consequence(
        Reach.LOCAL,
        "Over ε = 10^-3, ..., 10^-6 it is the slope of y less eq. (29) as printed, with the wrong sign.",
        "One measured exponent, by the sign of eq. (29) (2-trivial-zy); the theoretical one beside it is right, and "
        "so is the conclusion.",
        table="Table 1(a)",
    ),
    "4-reference": Consequence(
        Reach.NONE,
        "The display is unnumbered, so the reference prints the number of the section.",
        "The reader finds the equation from the words.",
    ),
    "4-order": Consequence(
        Reach.NONE,
        "The equation contains the fourth derivative of b; three is its degree in ε.",
        "The printed equation is of fourth order, and is used as such.",
    ),
    "4-unique-smooth": Consequence(
        Reach.CONCLUSION,
        "A solution of eq. (46) times exp(-1/ε²) can be added, and the sum is smooth too.",
        "For β not an integer the distinguished trajectory is unique as a formal series, not among smooth functions.",
    ),
    "4-inner-fast": Consequence(
        Reach.NONE,
        "Eq. (52) in the time s_f, ds = δ ds_f, times δ³, has the minus sign there.",
        "The limit that is used does not contain the term.",
    ),
    "4-inner-scaling-v": Consequence(
        Reach.LOCAL,
        "Eq. (48) with t = δ² s and ε = δ³; line 1237 has the matching exponent.",
        "The exponents of line 1237 and of Table 1 are those of the right form.",
    ),
    "4-behaves-like": Consequence(
        Reach.LOCAL,
        "Solutions that oscillate, of the smaller size (-τ)^(-β/2-3/4), can be added.",
        "(-τ)^β alone does not determine Θ; with the condition on e_r and e_i, which stands before it, it does.",
    ),
    "4-matching-middle": Consequence(
        Reach.NONE,
        "Both neighbours in the chain of equalities have the exponent β.",
        "The first and the last form of the line are right.",
    ),
    "S-mean-force": Consequence(
        Reach.LOCAL,
        "λ_N = -b/p on the trivial solution of eqs. (27), (28); the Introduction has this sign.",
        "With the printed sign the mean force of Case III would pull; the Introduction has the right sign.",
    ),
    "S-gamma-intervals": Consequence(
        Reach.CONCLUSION,
        "Γ(-1/2) < 0 < Γ(-3/2), and Γ(-β) changes its sign at each positive integer.",
        "Who takes the side from these intervals finds the wrong one for even ⌊β⌋, 0 < β < 1 among them, and both "
        "signs for odd ⌊β⌋. The paper's own conclusions are in Γ(-β), and hold.",
    ),
    "S-gamma-name": Consequence(
        Reach.NONE, "Without its backslash the name is printed as five variables.", "The formulas have Γ."
    ),
    "S-wording": Consequence(
        Reach.LOCAL,
        "Θ is positive at τ = 0 and for τ → −∞; what is negative is its derivative.",
        "Θ stands for dΘ/dτ; the argument is about dΘ/dτ.",
    ),
    "5-kinds": Consequence(
        Reach.NONE,
        "The derivative in eq. (88) is that of z_{n-1}, which is known there.",
        "The third-order equation that follows is right.",
    ),
    "5-typesetting": Consequence(
        Reach.NONE,
        "One sign of a definition stands twice, and an index is not lowered: P_ν - 3 is no space.",
        "The formulas are meant as the corrected ones.",
    ),
    "5-approaching-side": Consequence(
        Reach.NONE,
        "The ansatz (-t)^r that follows is real for t < 0, where p > 0.",
        "The analysis that follows is that of p > 0.",
    ),
    "5-manifold-names": Consequence(
        Reach.NONE,
        "The manifold of ε = 0 is that of the equilibria, and is in general not invariant for ε > 0.",
        "The two words are exchanged; what is said of the manifolds is meant of the right ones.",
    ),
    "5-letters": Consequence(
        Reach.NONE,
        "Eq. (70) has F(ξ) and G(ξ); functions with a tilde are not defined.",
        "The equations of the perturbation, lines 2064 to 2070, do not contain ξ.",
    ),
    "5-brackets": Consequence(
        Reach.NONE,
        "In each of these places one bracket has no partner.",
        "The exponents and the factor are meant as the corrected ones, and the caption as closed after p = 0.",
    ),
    "5-monomial": Consequence(
        Reach.NONE,
        "Eq. (91) contains 2 b_n''', and (s^k)''' = k(k-1)(k-2) s^(k-3).",
        "The coefficient that the argument uses is right.",
    ),
    "5-xinprime": Consequence(
        Reach.LOCAL,
        "The orders of G and λ_N in each product have the sum n.",
        "One wrong index in a formula of the recursion.",
    ),
    "5-example-b-error": Consequence(
        Reach.LOCAL,
        "The recursion of Theorem 1 gives b_7, and it is not 0 for χ other than 0.",
        "The error of one printed expansion is larger than stated.",
    ),
    "5-fast-system": Consequence(
        Reach.NONE,
        "The rate of v_o is b + p λ_N, where b is a constant of the fast system and in general not 0.",
        "M and its characteristic polynomial are right, and nothing else is used.",
    ),
    "5-ansatz-p0": Consequence(
        Reach.LOCAL,
        "The rate of p is α_1(ξ), and ξ deviates by ξ_0 (-t)^β.",
        "The exponent and the leading terms of ξ, b and λ_N hold; p has another one.",
    ),
    "5-bpert-v": Consequence(
        Reach.LOCAL,
        "v is the rate of y (eq. (73)), for the distinguished trajectory too.",
        "One line of the perturbed variables has a factor too many.",
    ),
    "6-sign-of-G": Consequence(
        Reach.LOCAL,
        "λ_T = -μ λ_N in positive slip, and with the printed sign L_G v is not the printed p.",
        "The functions of Appendix B are those of the right sign.",
    ),
    "6-attribution": Consequence(
        Reach.NONE, "Two places cite another work for the oscillator than the third.", "A citation."
    ),
    "6-colours": Consequence(
        Reach.LOCAL,
        "The caption and the text give the two colours in opposite order.",
        "A reader of Figure 12 takes one curve for the other.",
    ),
    "A-th5-condition": Consequence(
        Reach.LOCAL,
        "There 1/Γ is 0, and with it the right side; the left side is a polynomial, and not 0.",
        "They are used for Θ in eq. (A.14) and for dΘ/dτ in eq. (58), which state no condition either: all of them "
        "hold for a β that is not an integer, as line 1016 asks; at integers: A-tlarge, S-plus-infinity.",
    ),
}
