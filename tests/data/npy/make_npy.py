# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files beside it, which tests/datasets/formats/npy_test.cc reads:

    python3 make_npy.py

Every file holds the matrix ((0, 1, 2), (10, 11, 12)), but for the refused ones.
"""

import pathlib

import numpy

folder = pathlib.Path(__file__).parent
matrix = numpy.array([[0, 1, 2], [10, 11, 12]])

for kind in ("<f4", "<f8", ">f4", ">f8", "|i1", "|u1", "<i2", "<i4", "<i8", ">u2", "<u4", "<u8"):
    name = kind.replace("<", "le_").replace(">", "be_").replace("|", "")
    numpy.save(folder / f"good_{name}.npy", matrix.astype(kind))
numpy.save(folder / "good_fortran.npy", numpy.asfortranarray(matrix.astype("<f4")))
with open(folder / "good_version_2.npy", "wb") as file:
    numpy.lib.format.write_array(file, matrix.astype("<f4"), version=(2, 0))

numpy.save(folder / "half.npy", matrix.astype("<f2"))
numpy.save(folder / "complex.npy", matrix.astype("<c16"))
numpy.save(folder / "rank_1.npy", matrix.astype("<f4").ravel())
numpy.save(folder / "rank_3.npy", matrix.astype("<f4").reshape(1, 2, 3))
numpy.save(folder / "records.npy", numpy.zeros(3, dtype=[("a", "<f4"), ("b", "<f4")]))
numpy.save(folder / "nan.npy", numpy.array([[0.0, 1.0], [numpy.nan, 2.0]]))
