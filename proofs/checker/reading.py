"""From bytes to numbers and ranges: what a file may be, strictly (certificate.md, Text).

A line is canonical JSON with integers as its only numbers and no key twice; rationals are texts in lowest terms. All
lengths are bounded before a number is made, so reading costs no more than the length of the file.
"""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections import namedtuple
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from limits import Limits, reject, require

INFINITY = math.inf  # stands for an infinite end of a range; no float takes part in a bound
NUMBER = "-?(?:0|[1-9][0-9]{0,3999})(?:/[1-9][0-9]{0,3999})?"
RANGE = rf"([\[(])(-inf|{NUMBER}), (inf|{NUMBER})([\])])"

Range = namedtuple("Range", "start end closed text")  # of τ or β; closed at the start, closed at the end; in words


def integer(text: str) -> int:
    """A JSON integer; its length is bounded before the conversion."""
    require(re.fullmatch("-?[0-9]{1,4000}", text), f"{text!a:.50} is not an integer of at most 4000 digits")
    return int(text)


def object_of(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """A JSON object with no key twice."""
    value = dict(pairs)
    require(len(value) == len(pairs), "a key occurs twice in one object")
    return value


def read_line(line: bytes) -> Any:
    """One line of canonical JSON: integers are its only numbers."""
    try:
        text = line.decode()
        value = json.loads(
            text, object_pairs_hook=object_of, parse_int=integer, parse_float=integer, parse_constant=integer
        )
        canonical = json.dumps(value, sort_keys=True, separators=(",", ":"))
    except RecursionError:
        reject("JSON is nested too deeply")
    except UnicodeDecodeError:
        reject("the text is not UTF-8")
    except ValueError:
        reject("a line is not JSON")
    require(canonical == text, "a line is not canonical JSON")
    return value


def read_lines(data: bytes, limits: Limits) -> list[bytes]:
    """The lines of a file but for the last one, which is their hash; their number, lengths and lists are bounded."""
    limits.keep("bytes", len(data))
    require(re.fullmatch(rb"(?s).*\nsha256 [0-9a-f]{64}\n", data), "the last line is not sha256 and a hash")
    body, last = data[:-72], data[-72:]
    require(hashlib.sha256(body).hexdigest().encode() == last[7:71], "the hash does not match")
    limits.keep("lists", body.count(b"["))
    lines = body[:-1].split(b"\n")
    limits.keep("line", max(map(len, lines)))
    return lines


def read_header(line: bytes) -> tuple[Any, Any, Any]:
    """The version, the pages and the statement of the first line, as they are written."""
    names = ("version", "hypotheses", "statement", "format")
    version, hypotheses, statement, form = entries(read_line(line), "the header", *names)
    require(form == "gspot_verified certificate", f"the format is {form!a:.50}")
    return version, hypotheses, statement


def entries(value: Any, name: str, *keys: str) -> list[Any]:
    """The values of an object that has exactly these keys."""
    require(isinstance(value, dict) and sorted(value) == sorted(keys), f"{name} has not the keys {', '.join(keys)}")
    return [value[key] for key in keys]


def rational(value: Any) -> Fraction:
    """A rational number as text in lowest terms."""
    matches = isinstance(value, str) and re.fullmatch(NUMBER, value)
    require(matches, f"{value!a:.50} is not a rational number as text of at most 4000 digits")
    number = Fraction(value)
    require(str(number) == value, f"{value!a:.50} is not in lowest terms")
    return number


def one_of(value: Any, allowed: Sequence[int], name: str) -> int:
    """An integer (no boolean) out of a few."""
    require(type(value) is int and value in allowed, f"{name} is {value!a:.50}")
    return int(value)


def has(where: Range, x: Any) -> bool:
    """Whether x is in a range."""
    at_an_end = (x == where.start and where.closed[0]) or (x == where.end and where.closed[1])
    return bool(where.start < x < where.end or at_an_end)


def read_range(value: Any, name: str) -> Range:
    """A range as text, and in words."""
    match = re.fullmatch(RANGE, value) if isinstance(value, str) else None
    if match is None:
        reject(f"{value!a:.50} is not a range")
    left, low, high, right = match.groups()
    start = -INFINITY if low == "-inf" else rational(low)
    end = INFINITY if high == "inf" else rational(high)
    require(left + low != "[-inf" and high + right != "inf]", f"the range {value!a:.50} is closed at infinity")
    require(start < end or (start == end and left + right == "[]"), f"the range {value!a:.50} is empty")
    text = f"for every {name} in {value}" if start < end else f"at {name} = {low}"
    return Range(start, end, (left == "[", right == "]"), text)


def check_cover(parts: Sequence[Any], start: Any, end: Any, name: str) -> None:
    """Each part begins where the one before it ends, and together they just cover a range."""
    for before, after in pairwise(parts):
        require(before.end >= after.start, f"a gap between {name}")
        require(before.end <= after.start, f"an overlap of {name}")
        require(before.start < before.end and after.start < after.end, f"one of several {name} is a single point")
    require(parts and parts[0].start <= start and parts[-1].end >= end, f"the {name} do not cover the whole range")
    require(parts[0].end >= start and parts[-1].start <= end, f"one of the {name} lies outside the range")
