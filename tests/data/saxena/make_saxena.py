# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pair of picture and label beside it: a bright mug, its handle labelled.

    python3 make_saxena.py
"""

import pathlib
import struct
import zlib

WIDTH, HEIGHT = 32, 24


def chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data +
            struct.pack(">I", zlib.crc32(kind + data)))


def write_png(path, value_at):
    rows = b"".join(b"\0" + bytes(value_at(u, v) for u in range(WIDTH)) for v in range(HEIGHT))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def is_wall(u, v):
    return 8 <= u < 18 and 6 <= v < 20


def is_handle(u, v):
    return 18 <= u < 22 and 9 <= v < 17


folder = pathlib.Path(__file__).parent / "mug"
write_png(folder / "mug_0001.png", lambda u, v: 200 if is_wall(u, v) or is_handle(u, v) else 60)
write_png(folder / "mug_0001_label.png", lambda u, v: 255 if is_handle(u, v) else 0)
