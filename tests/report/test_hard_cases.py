"""The hard cases as data of the report: their form is checked when a report is read."""

import copy

import pytest

from gspot_verified.hard_cases.catalogue import families
from gspot_verified.report.hard_cases import NONE, check_hard_cases, hard_cases, measurements


def test_the_report_counts_as_the_catalogue_does(hard):
    assert hard_cases(hard["families"]) == hard
    assert len(measurements()) == len(families())


def test_what_the_catalogue_gives_has_the_form(hard):
    check_hard_cases(hard)
    check_hard_cases(NONE)


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (["summary", "decided"], 1, "hard_cases.summary: the file says"),
        (["families"], None, "hard_cases.families: expected a list"),
        (["families", 0], 1, r"hard_cases.families\[0\]: expected an object"),
        (["families", 0, "why"], 1, "expected text under 'why'"),
        (["families", 0, "growth", "work"], "1", "growth: expected numbers or null"),
        (["families", 1, "rows"], [], "expected one row at least"),
        (["families", 0, "rows", 0, "asked"], None, "expected text under 'asked'"),
        (["families", 0, "rows", 0, "work"], 1.5, "expected integers for level and work"),
        (["families", 0, "rows", 0, "seconds"], None, "expected a time"),
        (["families", 0, "rows", 0, "bits_lost"], "3", "numbers or null"),
        (["families", 0, "rows", 0, "double_right"], 1, "double_right: expected true, false or null"),
        (["families", 0, "rows", 0, "decided"], False, "double_right: expected true, false or null"),
    ],
)
def test_another_form_is_refused(hard, path, value, message):
    changed = copy.deepcopy(hard)
    holder = changed
    for key in path[:-1]:
        holder = holder[key]
    holder[path[-1]] = value
    with pytest.raises(ValueError, match=message):
        check_hard_cases(changed)
