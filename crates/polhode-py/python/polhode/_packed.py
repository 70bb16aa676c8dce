"""The data of a page, packed for a notebook: `viewer/src/packed.ts` unpacks them.

A row of numbers keeps what a screen can show of it: some 30 bits of its range, so that what is a ten-thousandth of the largest has four digits, or all of a double's if it varies by
less. Its differences, of the order that makes them smallest, are sorted by bytes and deflated.
"""

from __future__ import annotations

import base64
import json
import math
import struct
import zlib
from typing import Any, Mapping, NamedTuple

import numpy as np
import numpy.typing as npt

Integers = npt.NDArray[np.int64]

#: Most bytes of what is packed: as base64 less than 192 kB.
MOST = 144_000
#: Bits of the range of a row, and what all but times have lost if they would be too large: as many are left as a float of 32 bits has.
_BITS, _LOST = 30, 6
#: A motion is not thinned to fewer samples.
FEWEST = 126
#: Orders of differences that are tried.
_ORDERS = range(5)
#: Bits that a number of kind ``float`` has less than one of 32.
_SHORT = 12


class _Form(NamedTuple):
    """How a row is kept."""

    #: What the page makes of it: ``f64``, ``f32``, ``u32``, or ``float``: three digits, however small.
    kind: str
    #: How many numbers belong together.
    columns: int
    #: Of the range of each column.
    bits: int = _BITS
    #: Even if others lose some.
    always: bool = False


_ONE, _THREE, _CURVE = _Form("f64", 1), _Form("f64", 3), _Form("f64", 3, 20)
_MOTION = {
    "times": _Form("f64", 1, always=True),
    "attitude": _Form("f64", 4),
    **dict.fromkeys(("omega", "momentum", "torque", "center", "point"), _THREE),
    **dict.fromkeys(("kinetic", "potential", "normalForce", "friction", "slip", "frictionWork", "groundWork"), _ONE),
}
_NAMED: dict[str, _Form] = dict.fromkeys(("momentum", "speed", "motor", "values"), _ONE)
_DRIFT = {"values": _Form("float", 1)}
_FREE: dict[str, _Form] = dict.fromkeys(("polhode", "herpolhode", "separatrix", "family", "trace"), _CURVE)
_SHAPE = {
    **dict.fromkeys(("vertices", "centers"), _Form("f32", 3, 16)),
    "radii": _Form("f32", 1, 16),
    "triangles": _Form("u32", 3),
}
_DTYPES = {"f64": "<f8", "float": "<f8", "f32": "<f4", "u32": "<u4"}


def pack(data: str) -> bytes:
    """What a page holds as JSON, packed. A motion of so many numbers that it would be too large has fewer bits, and then every second sample, every fourth, …"""
    page = json.loads(data)
    packed = _packed(page, 0, 1)
    count, each = page["motion"]["count"], 1
    while len(packed) > MOST and count // each >= FEWEST:
        packed = _packed(page, _LOST, each)
        each *= 2
    return packed


def pack_text(data: str) -> str:
    """The same as base64."""
    return base64.b64encode(pack(data)).decode("ascii")


def _packed(page: dict[str, Any], lost: int, each: int) -> bytes:
    rows = _Rows(lost)
    motion, free = page["motion"], page["free"]
    count = motion["count"]
    if each > 1:
        rows.chosen = np.unique(np.append(np.arange(0, count, each), count - 1))
        said = f"this notebook shows every {each}{'nd' if each == 2 else 'th'} of its samples; page() has them all"
        page = {**page, "findings": [*page["findings"], {"severity": "info", "message": said}]}
    contact = motion["contact"]
    moved = {
        **rows.of(motion, _MOTION),
        "count": count if rows.chosen is None else len(rows.chosen),
        "work": None if motion["work"] is None else rows.of(motion["work"], _NAMED),
        "drift": [rows.of(one, _DRIFT) for one in motion["drift"]],
        "wheels": [rows.of(one, _NAMED) for one in motion["wheels"]],
        "pointings": [rows.of(one, _NAMED) for one in motion["pointings"]],
        "contact": None if contact is None else {**rows.of(contact, _MOTION), "surface": _shape(rows, contact["surface"])},
    }
    body = {**page["body"], "shapes": [_shape(rows, shape) for shape in page["body"]["shapes"]]}
    # Curves have points of their own.
    rows.chosen = None
    text = json.dumps(
        {**page, "body": body, "motion": moved, "free": None if free is None else rows.of(free, _FREE)}, ensure_ascii=False, separators=(",", ":")
    ).encode()
    return zlib.compress(struct.pack("<I", len(text)) + text + b"".join(rows.parts), 9)


def _shape(rows: _Rows, shape: dict[str, Any] | None) -> dict[str, Any] | None:
    if shape is None:
        return None
    chosen, rows.chosen = rows.chosen, None
    packed = rows.of(shape, _SHAPE)
    rows.chosen = chosen
    return packed


class _Rows:
    """The rows behind the JSON."""

    def __init__(self, lost: int) -> None:
        self.lost = lost
        self.parts: list[bytes] = []
        self.size = 0
        #: Which samples are kept; all, unless it is said.
        self.chosen: Integers | None = None

    def of(self, table: dict[str, Any], forms: Mapping[str, _Form]) -> dict[str, Any]:
        """A table whose rows are packed."""
        return {name: self._put(value, forms[name]) if name in forms else value for name, value in table.items()}

    def _put(self, row: Any, form: _Form) -> Any:
        if isinstance(row, list):
            return [self._put(one, form) for one in row]
        if not isinstance(row, str):
            return row
        values = np.frombuffer(base64.b64decode(row), _DTYPES[form.kind]).reshape(-1, form.columns)
        if self.chosen is not None:
            values = values[self.chosen]
        whole, zero, per = _whole(np.ascontiguousarray(values.T), form, form.bits if form.always else min(form.bits, _BITS - self.lost))
        order, codes = min((_codes(whole, order) for order in _ORDERS), key=lambda tried: float(np.log2(1.0 + tried[1]).sum()))
        width = max(1, -(-int(codes.max(initial=0)).bit_length() // 8))
        planes = codes.astype("<u4").view(np.uint8).reshape(*codes.shape, 4)
        self.parts.append(np.moveaxis(planes, -1, 0)[:width].tobytes())
        at, self.size = self.size, self.size + width * codes.size
        entry = {"kind": form.kind, "at": at, "count": len(values), "bytes": width, "order": order, "zero": zero, "per": per}
        return {"row": entry}


def _whole(columns: npt.NDArray[Any], form: _Form, bits: int) -> tuple[Integers, list[float], list[float]]:
    """Columns as whole numbers from 0 on; where their zeros are, and how many of them are one.

    They are decimal fractions as long as these tell enough apart: 0 and 0.01 stay what they are.
    """
    if form.kind == "u32" or columns.shape[1] == 0:
        return columns.astype(np.int64), [0] * len(columns), [1] * len(columns)
    if form.kind == "float":
        whole = columns.astype(np.float32).view(np.int32).astype(np.int64)
        return (whole + (1 << _SHORT - 1)) >> _SHORT, [0] * len(columns), [1] * len(columns)
    wholes, zeros, pers = [], [], []
    for column in columns.astype(np.float64):
        least, most = float(column.min()), float(column.max())
        last_bit = float(np.spacing(max(-least, most, 1e-290)))
        # Halves, as the range of numbers near the largest of all is beyond it.
        wanted = max((most / 2 - least / 2) / 2.0 ** (bits + 0.9), last_bit)
        decimals = -math.ceil(math.log10(wanted))
        per = float(f"1e{decimals}") if last_bit < 0.1 * wanted else 1.0 / last_bit
        whole = np.rint(column * per)
        zeros.append(float(whole.min()))
        wholes.append((whole - zeros[-1]).astype(np.int64))
        pers.append(per)
    return np.array(wholes), zeros, pers


def _codes(whole: Integers, order: int) -> tuple[int, Integers]:
    """Differences of an order, as numbers that are not negative: 0, −1, 1, −2, … by turns; sums of 32 bits bring them back."""
    for _ in range(order):
        whole = np.diff(whole, axis=1, prepend=0)
    signed = (whole + 2**31) % 2**32 - 2**31
    return order, np.where(signed < 0, -2 * signed - 1, 2 * signed)
