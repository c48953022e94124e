# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the labels of the picture beside it with SciPy: a mug's handle (1) and wall (7).

    python3 make_umd.py
"""

import pathlib

import numpy
import scipy.io

folder = pathlib.Path(__file__).parent / "mug_01"
labels = numpy.zeros((120, 160), "uint8")
labels[15:75, 44:56] = 7
labels[30:60, 56:62] = 1
path = folder / "mug_01_00000001_label.mat"
scipy.io.savemat(path, {"gt_label": labels}, do_compression=True)
data = path.read_bytes()
path.write_bytes(b"MATLAB 5.0 MAT-file".ljust(116) + data[116:])  # without the time stamp
