# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""The peers of the PCA benchmark: NumPy's covariance and eigenvectors, and scikit-learn's PCA.

    python3 principal_components.py FEATURES.npy

Both work in double precision, the conversion is not timed. Prints one line of JSON: seconds of each
(wall and processor time), the largest eigenvalues of NumPy's, versions.
"""
import json
import sys
import time

import numpy
import sklearn
from sklearn.decomposition import PCA


def timed(work):
    """Result, wall seconds and processor seconds of work()."""
    wall, processor = time.perf_counter(), time.process_time()
    result = work()
    return result, time.perf_counter() - wall, time.process_time() - processor


features = numpy.load(sys.argv[1]).astype(numpy.float64)
(eigenvalues, _), wall, processor = timed(
    lambda: numpy.linalg.eigh(numpy.cov(features, rowvar=False)))
# From 1.5 on there is a solver that goes through the covariance, as ours and NumPy's.
version = tuple(int(part) for part in sklearn.__version__.split(".")[:2])
solver = "covariance_eigh" if version >= (1, 5) else "full"
_, sklearn_wall, sklearn_processor = timed(
    lambda: PCA(svd_solver=solver, copy=False).fit(features))
print(json.dumps({"seconds": wall,
                  "processor_seconds": processor,
                  "largest_eigenvalues": eigenvalues[::-1][:10].tolist(),
                  "version": numpy.__version__,
                  "sklearn_seconds": sklearn_wall,
                  "sklearn_processor_seconds": sklearn_processor}))
