"""Many exact intervals in few bytes: what a long computation keeps of each of its pieces.

An interval takes about a tenth of the memory that a :class:`Dyadic` takes, and crosses to another process at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import overload

from gspot_verified.numbers.dyadic import Dyadic

_LONG = 255  # a length byte that says: the length follows in eight bytes


class PackedIntervals(Sequence[Dyadic | None]):
    """A sequence of intervals, and of None where there is none; each comes back as it was.

    Equal sequences are equal objects with equal hashes: an interval is canonical, and so are its bytes.

    >>> packed = PackedIntervals([Dyadic(-3, 5, -2), None, Dyadic(0, 0)])
    >>> packed[0], packed[1], len(packed)
    (Dyadic(lower=-3, upper=5, exponent=-2), None, 3)
    """

    __slots__ = ("_data",)

    def __init__(self, intervals: Iterable[Dyadic | None]) -> None:
        self._data = b"".join(map(_written, intervals))

    def __reduce__(self) -> tuple[object, tuple[bytes]]:
        return PackedIntervals.of_bytes, (self._data,)

    @classmethod
    def of_bytes(cls, data: bytes) -> PackedIntervals:
        """The sequence with this :attr:`data`."""
        made = cls.__new__(cls)
        made._data = data
        return made

    @property
    def data(self) -> bytes:
        """All of it."""
        return self._data

    def __iter__(self) -> Iterator[Dyadic | None]:
        place = 0
        while place < len(self._data):
            lower, place = _number(self._data, place)
            if lower is None:
                yield None
                continue
            width, place = _number(self._data, place)
            exponent, place = _number(self._data, place)
            assert width is not None
            assert exponent is not None
            yield Dyadic(lower, lower + width, exponent)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    @overload
    def __getitem__(self, index: int) -> Dyadic | None: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[Dyadic | None, ...]: ...
    def __getitem__(self, index: int | slice) -> Dyadic | tuple[Dyadic | None, ...] | None:
        return tuple(self)[index]

    def __eq__(self, other: object) -> bool:
        return self._data == other._data if isinstance(other, PackedIntervals) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._data)

    def __repr__(self) -> str:
        return f"PackedIntervals({list(self)!r})"


def _written(interval: Dyadic | None) -> bytes:
    """Lower end, width and exponent; a length of 0 for None."""
    if interval is None:
        return b"\0"
    numbers = (interval.lower, interval.upper - interval.lower, interval.exponent)
    return b"".join(map(_bytes_of, numbers))


def _bytes_of(number: int) -> bytes:
    length = number.bit_length() // 8 + 1
    data = number.to_bytes(length, "little", signed=True)
    return (bytes([length]) if length < _LONG else bytes([_LONG]) + length.to_bytes(8, "little")) + data


def _number(data: bytes, place: int) -> tuple[int | None, int]:
    """The number that begins there, and where the next one does."""
    length = data[place]
    place += 1
    if length == 0:
        return None, place
    if length == _LONG:
        length, place = int.from_bytes(data[place : place + 8], "little"), place + 8
    return int.from_bytes(data[place : place + length], "little", signed=True), place + length
