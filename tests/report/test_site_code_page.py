"""Source pages: every line is there, and each function has its address."""

import html
import inspect
import re

import pytest

from gspot_verified.paper.section_3 import section_3
from gspot_verified.paper.section_6 import section_6
from gspot_verified.paper.verify import PARTS, code_of
from gspot_verified.report.site import code_address, code_page


@pytest.mark.parametrize("module", [section_3, section_6])
def test_the_source_is_whole(module):
    path = module.__name__.replace(".", "/") + ".py"
    shown = re.sub(r"<i>\d+</i>", "", code_page(path))
    assert html.unescape(re.sub(r"<[^>]*>", "", shown)).split() == inspect.getsource(module).split()


def test_every_entry_has_its_function_on_a_page():
    for builders in PARTS.values():
        for build in builders.values():
            path, _, function = code_of(build).partition(":")
            place = code_address(path, function).partition("#")[2]
            assert f'id="{place}"' in code_page(path)


@pytest.mark.parametrize(
    "path", ["", "gspot_verified/paper/../balls.py", "gspot_verified/numbers/balls.py", "/etc/passwd"]
)
def test_nothing_but_modules_of_the_ledger_is_shown(path):
    assert code_page(path) == ""
