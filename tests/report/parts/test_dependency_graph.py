"""The graph shows each arrow once, and cycles do not stop it."""

import xml.etree.ElementTree as ElementTree

from hypothesis import given
from hypothesis import strategies as st

from gspot_verified.report.parts.dependency_graph import Node, graph_svg


def shown(names, arrows):
    svg = ElementTree.fromstring(graph_svg([Node(name, f"{name}.html", "page") for name in names], arrows))
    boxes = [text.text for text in svg.iter("text")]
    return boxes, len(list(svg.iter("path")))


def test_what_names_nothing_and_is_not_named_is_left_out():
    assert shown("abc", {"a": ["b"]}) == (["a", "b"], 1)


def test_an_arrow_to_nothing_is_left_out():
    assert shown("ab", {"a": ["b", "x"]}) == (["a", "b"], 1)


def test_names_are_escaped():
    made = graph_svg([Node("<b>", "x.html", "page"), Node("b", "y.html", "page")], {"<b>": ["b"]})
    assert "<b>" not in made


@given(st.dictionaries(st.sampled_from("abcdef"), st.lists(st.sampled_from("ghij"), unique=True)))
def test_each_arrow_from_the_left_is_drawn_once(arrows):
    boxes, curves = shown("abcdefghij", arrows)
    assert curves == sum(len(others) for others in arrows.values())
    assert sorted(boxes) == sorted(
        {*(name for name in arrows if arrows[name]), *(x for o in arrows.values() for x in o)}
    )


def test_a_cycle_behind_a_statement():
    assert shown("abc", {"a": ["b"], "b": ["c"], "c": ["b"]}) == (["a", "b", "c"], 3)
