#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a tiny tree named as the Cornell grasping data set is: six drawn pictures of a bar, with
one positive and one negative rectangle each. Run it in its folder."""

import numpy as np
import struct
import zlib

WIDTH, HEIGHT = 160, 120


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(path, pixels):
    height, width, _ = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n"
                   + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def write_rectangle(path, u, v, half_width, half_height):
    with open(path, "w", encoding="ascii") as file:
        for du, dv in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            file.write(f"{u + du * half_width} {v + dv * half_height}\n")


for index, number in enumerate(range(100, 160, 10)):
    u, v = 50 + 10 * index, 45 + 5 * index
    pixels = np.full((HEIGHT, WIDTH, 3), 110, np.uint8)
    pixels += np.random.default_rng(number).integers(0, 8, (HEIGHT, WIDTH, 1), np.uint8)
    pixels[v - 30:v + 30, u - 6:u + 6] = (190, 60, 40)
    write_png(f"pcd{number:04}r.png", pixels)
    write_rectangle(f"pcd{number:04}cpos.txt", u, v, 18, 8)
    write_rectangle(f"pcd{number:04}cneg.txt", 20, 100, 10, 6)
