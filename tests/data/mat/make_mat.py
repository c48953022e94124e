# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files beside it with SciPy, which tests/datasets/formats/mat_array_test.cc reads:

    python3 make_mat.py
"""

import pathlib

import numpy
import scipy.io

folder = pathlib.Path(__file__).parent
matrix = numpy.array([[0, 1, 2], [10, 11, 12]])
arrays = {
    "note": "text",
    "small": matrix.astype("uint8")[:1],
    "gt_label": matrix.astype("uint8"),
    "wide": matrix.astype("float64") / 4,
    "cube": numpy.arange(24, dtype="int16").reshape(2, 3, 4),
    "flags": matrix > 1,
    "complex": matrix * 1j,
    "cells": numpy.array([1, "a"], dtype=object),
    "big": matrix.astype("int64") * 2**40,
    "single": matrix.astype("float32"),
}
scipy.io.savemat(folder / "plain.mat", arrays)
scipy.io.savemat(folder / "compressed.mat", arrays, do_compression=True)
scipy.io.savemat(folder / "level_4.mat", {"gt_label": matrix.astype("float64")}, format="4")
for path in folder.glob("*.mat"):  # the time stamp of the header's text
    data = path.read_bytes()
    if data.startswith(b"MATLAB"):
        path.write_bytes(b"MATLAB 5.0 MAT-file".ljust(116) + data[116:])
