# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reads model files as docs/model_format.md § 2 describes them, with Python's JSON parser, a
CRC-32C of its own and nothing of the C++ code.

    model_layout_test.py FILE...
"""

import array
import json
import math
import pathlib
import re
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from crc32c import crc32c  # noqa: E402

ITEM_BYTES = {"F64": 8, "I64": 8, "F32": 4, "I32": 4, "U8": 1}
ARRAY_TYPES = {"F64": "d", "I64": "q", "F32": "f", "I32": "i", "U8": "B"}


def read_tensors(data):
    """Name → numbers, key → text; checks § 2.1 to § 2.3 on the way."""
    (length,) = struct.unpack_from("<Q", data)
    text = data[8:8 + length].decode("utf-8")
    header = json.loads(text)
    compact = json.dumps(header, separators=(",", ":"), ensure_ascii=False)
    assert text.rstrip(" ") == compact, "the header is not compact JSON"
    names = list(header)
    assert names == sorted(names) and names[0] == "__metadata__", "keys are not sorted"
    metadata = header.pop("__metadata__")
    assert list(metadata) == sorted(metadata), "metadata keys are not sorted"
    assert all(isinstance(value, str) for value in metadata.values())
    start = 8 + length
    assert start % 64 == 0, "the data are not aligned"

    tensors, end = {}, 0
    for name, entry in sorted(header.items(), key=lambda t: (-ITEM_BYTES[t[1]["dtype"]], t[0])):
        assert re.fullmatch(r"[a-z][a-z0-9_.]{0,62}", name), name
        begin = entry["data_offsets"][0]
        assert begin == end, f"a gap or overlap before {name}"
        assert begin % ITEM_BYTES[entry["dtype"]] == 0, f"{name} is not aligned"
        end = entry["data_offsets"][1]
        numbers = array.array(ARRAY_TYPES[entry["dtype"]], data[start + begin:start + end])
        assert len(numbers) == math.prod(entry["shape"]), f"{name} has another shape"
        tensors[name] = numbers
    assert start + end == len(data), "the tensors do not end with the file"
    return tensors, metadata


def check_logistic(tensors):
    weights, rows = tensors["weights"], tensors["selftest.input"]
    for i, expected in enumerate(tensors["selftest.output"]):
        row = rows[i * len(weights):(i + 1) * len(weights)]
        z = tensors["intercept"][0] + sum(w * x for w, x in zip(weights, row))
        probability = 1.0 / (1.0 + math.exp(-z))
        assert abs(probability - expected) <= tensors["selftest.tolerance"][0], f"self-test row {i}"


def check(path):
    with open(path, "rb") as file:
        data = file.read()
    tensors, metadata = read_tensors(data)
    mark = tensors["zz.crc"].tobytes()
    assert mark[:4] == b"C32C" and mark == data[-8:], "the checksum is not last"
    assert struct.unpack("<I", mark[4:])[0] == crc32c(data[:-8]), "the checksum is wrong"
    assert all(math.isfinite(x) for t in tensors.values() for x in t), "a number is not finite"
    assert metadata["hc.format"] == "1.0"
    if metadata["hc.kind"] == "logistic":
        check_logistic(tensors)
    print(f"{path}: {metadata['hc.kind']}, {len(tensors)} tensors, {len(data)} bytes: ok")


def main():
    assert crc32c(b"123456789") == 0xE3069283
    for path in sys.argv[1:]:
        check(path)
    assert len(sys.argv) > 1, "no file given"


if __name__ == "__main__":
    main()
