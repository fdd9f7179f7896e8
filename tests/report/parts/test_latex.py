"""LaTeX of the paper becomes MathML, or is refused: nothing is half-set."""

import re
import xml.etree.ElementTree as ElementTree

import pytest

from gspot_verified.paper.checks.paper import _data, printed_number
from gspot_verified.report.parts.latex import NotTypeset, latex_formula, latex_html


def number(label):
    return printed_number(label) if label in _data()["numbers"] else None


def passages():
    return sorted({q["latex"] for citation in _data()["citations"].values() for q in citation["quotations"]})


def test_the_name_of_a_label_is_no_formula():
    shown = latex_html(r"By \eqref{eq:dTheta_sign} it lifts off.", lambda _: None)
    assert "<math" not in shown
    assert "it lifts off." in shown


def test_all_quotations_are_set():
    for source in passages():
        shown = latex_html(source, number)
        assert "\\" not in re.sub(r"<[^>]*>", "", shown)
        assert "$" not in shown
        ElementTree.fromstring(f"<x>{shown.replace('&nbsp;', ' ')}</x>")


@pytest.mark.parametrize(
    ("source", "tags"),
    [
        (r"\frac{1}{2}", ["mfrac"]),
        (r"\alpha_3^*", ["msubsup"]),
        (r"\begin{pmatrix}1&0\\0&1\end{pmatrix}", ["mtable", "mtd"]),
        (r"\eps^{2\beta/3}", ["msup"]),
        (r"\sqrt{x}", ["msqrt"]),
    ],
)
def test_formulas_have_their_structure(source, tags):
    found = ElementTree.fromstring(latex_formula(source))
    names = [element.tag.rpartition("}")[2] for element in found.iter()]
    assert names[0] == "math"
    assert set(tags) <= set(names)


@pytest.mark.parametrize(
    ("body", "parts"),
    [
        (r"a=1,\quad b=2,\qquad c=3.", 3),
        (r"a=1,\quadratic", 0),
        (r"\left(a,\quad b\right)", 0),
        (r"x_{a,\quad b}", 0),
        ("a=1, b=2", 0),
    ],
)
def test_a_display_can_break_after_a_comma_that_no_group_holds(body, parts):
    try:
        shown = latex_html(rf"\[{body}\]", number)
    except NotTypeset:
        shown = ""
    assert shown.count('<span class="part">') == parts
    assert shown.count("<math") == max(parts, 1) or not shown


def test_letters_and_numbers_arrive():
    text = "".join(ElementTree.fromstring(latex_formula(r"\eps \dot b = \alpha_2 - 17 \lambda_N")).itertext())
    assert [c for c in text if c.isalnum()] == ["ε", "b", "α", "2", "1", "7", "λ", "N"]


@pytest.mark.parametrize(
    "source",
    [
        r"\text{<!--><img/src=x>-->}",  # a comment of XML, in HTML one that ends at its first bracket
        r"\text{<!-- a -->}",
        r"\text{<?a?><b/>}",
        r"\text{<![CDATA[<b>]]>}",
        r"\text{<mi/>}",  # in HTML no empty element, but one that is never closed
        r"\text{a <mtext>b</mtext>}",
    ],
)
def test_what_html_reads_otherwise_than_xml_is_refused(source):
    with pytest.raises(NotTypeset):
        latex_formula(source)


@pytest.mark.parametrize("source", [r"\input{x}", r"\unknowncommand", r"\frac{1}", r"\left( x", r"a^b^c", r"\end{x}"])
def test_what_is_not_known_is_refused(source):
    with pytest.raises(NotTypeset):
        latex_formula(source)


def test_a_table():
    source = r"\begin{tabular}{c|c}\hline \multicolumn{2}{|c|}{{\bf both} $x$} \\ 1 & $\beta$ \\ \end{tabular}"
    shown = latex_html(source, number)
    assert re.findall(r"<td[^>]*>", shown) == ['<td colspan="2">', "<td>", "<td>"]
    assert shown.count("<tr>") == 2
    assert shown.count("<math") == 2


@pytest.mark.parametrize("source", [r"see \unknowncommand{x}", r"\begin{tikzpicture} a \end{tikzpicture} $x$"])
def test_prose_that_is_not_known_is_refused(source):
    with pytest.raises(NotTypeset):
        latex_html(source, number)


def test_references_become_printed_numbers():
    shown = latex_html(r"By \eqref{eq:btau} and Theorem~\ref{th:3}, not \eqref{eq:nowhere}.", number)
    assert shown == "<p>By (A.1) and Theorem\u00a04, not [eq:nowhere].</p>"
    bare = latex_html(r"see \ref{eq:btau}, (\ref{eq:hdef}--\ref{eq:eier}) and \eq{eq:btau}", number)
    assert bare == "<p>see A.1, (A.2–A.3) and (A.1)</p>"


def test_paragraphs_titles_and_comments():
    shown = latex_html("\\begin{theorem}[Name]\nLet $x$ be. % hidden\n\n{\\em So} 5\\% it is.\n\\end{theorem}", number)
    assert "hidden" not in shown
    assert shown.startswith("<p><b>Theorem (Name).</b> ")
    assert shown.endswith("<p><em>So</em> 5% it is.</p>")


def test_a_heading_in_the_line():
    for command in ("paragraph", "paragraph*"):
        shown = latex_html(rf"\{command}{{The slow dynamics}} for $\eps=0$", number)
        assert shown.startswith("<p><b>The slow dynamics</b> for <math")


def test_lists_with_titles():
    shown = latex_html("\\begin{description}\n\\item[Case I, $x$.] a\n\\item b\n\\end{description}", number)
    assert shown.count("•") == 2
    assert "Case I, <math" in shown


def test_markup_is_escaped():
    assert latex_html("a <b>c</b> & d", number) == "<p>a &lt;b&gt;c&lt;/b&gt; &amp; d</p>"
    assert "<script" not in latex_formula("<script>")


@pytest.mark.parametrize("bad", ["<script>", "<script>x</script>", "<mi onclick='x'>a</mi>", "<b>x</b>", "&x;"])
def test_text_in_a_formula_never_becomes_markup(bad):
    with pytest.raises(NotTypeset):
        latex_formula(rf"\text{{{bad}}}")
