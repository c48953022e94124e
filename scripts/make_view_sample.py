#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cuts a made-up set of views and demonstrations down to a small sample.

    scripts/make_view_sample.py FOLDER OUT --classes mug,drill --radius-m 0.15

FOLDER is what `handcraft data synth demonstrations` wrote. Kept are the pictures, object masks,
clouds and poses of those classes; of a cloud what lies within the radius of the turntable's axis,
everything else becomes NaN, and the file is compressed. Same folder, same bytes.
"""

import argparse
import csv
import math
import pathlib
import shutil
import struct

LEFT_OUT = ("depth", "scene")


def compress(data: bytes) -> bytes:
    """LZF, as binary_compressed PCD files have it: literal runs and matches of 3 to 264 bytes."""
    packed = bytearray()
    literals = bytearray()
    last_seen = {}

    def flush() -> None:
        for begin in range(0, len(literals), 32):
            run = literals[begin:begin + 32]
            packed.append(len(run) - 1)
            packed.extend(run)
        literals.clear()

    at = 0
    while at < len(data):
        key = data[at:at + 3]
        found = last_seen.get(key, -1) if len(key) == 3 else -1
        last_seen[key] = at
        if found < 0 or at - found > 8192:
            literals.append(data[at])
            at += 1
            continue
        length = 3
        while length < 264 and at + length < len(data) and data[found + length] == data[at + length]:
            length += 1
        flush()
        high, low = divmod(at - found - 1, 256)
        packed.append(min(length - 2, 7) << 5 | high)
        if length - 2 >= 7:
            packed.append(length - 9)
        packed.append(low)
        at += length
    flush()
    return bytes(packed)


def cut_cloud(source: pathlib.Path, target: pathlib.Path, radius_m: float) -> None:
    mark = b"DATA binary\n"
    header, points = source.read_bytes().split(mark, maxsplit=1)
    if b"FIELDS x y z\n" not in header:
        raise SystemExit(f"{source}: the fields are not x y z")
    kept = [(x, y, z) if math.hypot(x, y) <= radius_m else (math.nan,) * 3
            for x, y, z in struct.iter_unpack("<3f", points)]
    columns = b"".join(struct.pack(f"<{len(kept)}f", *column) for column in zip(*kept))
    packed = compress(columns)
    target.write_bytes(header + b"DATA binary_compressed\n" +
                       struct.pack("<2I", len(packed), len(columns)) + packed)


def cut_list(source: pathlib.Path, target: pathlib.Path, classes: set) -> list:
    with source.open(newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["class"] in classes]
    if not rows:
        raise SystemExit(f"{source}: no row of {', '.join(sorted(classes))}")
    columns = [name for name in rows[0] if name not in LEFT_OUT]
    with target.open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--classes", required=True, help="names, separated by commas")
    parser.add_argument("--radius-m", type=float, required=True)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    classes = set(options.classes.split(","))
    cut_list(options.folder / "demonstrations.csv", options.out / "demonstrations.csv", classes)
    for view in cut_list(options.folder / "views.csv", options.out / "views.csv", classes):
        for column in ("image", "object_mask", "cloud"):
            (options.out / view[column]).parent.mkdir(exist_ok=True)
        for column in ("image", "object_mask"):
            shutil.copyfile(options.folder / view[column], options.out / view[column])
        cut_cloud(options.folder / view["cloud"], options.out / view["cloud"], options.radius_m)


if __name__ == "__main__":
    main()
