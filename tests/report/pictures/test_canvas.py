import base64
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from IPython.core.formatters import DisplayFormatter
from matplotlib.figure import Figure

from gspot_verified.report.pictures.canvas import INK, PAPER, canvas, picture, save_figure, styled


@styled
def small():
    figure = canvas(1.0)
    figure.add_subplot().plot([0, 1], [0, 1], color=INK)
    return picture(figure, "small", "t", "x = 1 < 2, 1/Γ", "a")


def test_a_picture_says_its_title_to_those_who_hear_it(tmp_path: Path) -> None:
    """As the first title of the SVG: on a page, in a file, and of a picture that is written at once."""
    drawn = small()
    place = drawn.save(tmp_path / "picture.svg")
    sweep = save_figure(Figure(), "sweep", "a sweep & more", tmp_path / "sweep.svg")
    for text, title in (
        (drawn.svg, drawn.title),
        (place.read_text(encoding="utf-8"), drawn.title),
        (sweep.read_text(encoding="utf-8"), "a sweep & more"),
    ):
        found = ElementTree.fromstring(text).find("{http://www.w3.org/2000/svg}title")
        assert found is not None
        assert found.text == title


def test_svg_is_well_formed_and_follows_light_and_dark():
    svg = small().svg
    assert ElementTree.fromstring(svg).tag.endswith("svg")
    assert "prefers-color-scheme:dark" in svg
    body = svg[svg.index("</style>") :]
    assert INK not in body
    assert PAPER not in body
    assert "url(http" not in svg


def test_two_drawings_give_the_same_bytes():
    first, second = small(), small()
    assert first == second
    assert first.png.startswith(b"\x89PNG")


def test_matplotlib_settings_are_restored():
    import matplotlib

    before = dict(matplotlib.rcParams)
    small()
    assert dict(matplotlib.rcParams) == before


def test_caption_has_no_break_next_to_a_relation():
    assert small().caption == "x\u00a0=\u00a01\u00a0<\u00a02, 1/\u2060Γ"


def test_a_notebook_gets_the_picture_and_not_a_text():
    drawn = small()
    assert repr(drawn) == "<Picture small: t, 1152 × 160>"
    bundle, metadata = drawn._repr_mimebundle_()
    assert drawn._repr_html_() is None
    assert bundle == {
        "text/plain": repr(drawn),
        "image/svg+xml": drawn._repr_svg_(),
        "image/png": base64.b64encode(drawn.png).decode(),
    }
    assert metadata == {"image/svg+xml": {"alt": "a"}, "image/png": {"alt": "a"}}


def test_the_display_of_ipython_finds_both_images():
    bundle, metadata = DisplayFormatter().format(small())
    assert {*bundle} == {"text/plain", "image/svg+xml", "image/png"}
    assert ElementTree.fromstring(bundle["image/svg+xml"]).tag.endswith("svg")
    assert metadata["image/png"] == {"alt": "a"}
