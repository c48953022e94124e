# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""The peer of the training benchmark: scikit-learn's newton-cholesky without penalty.

    python3 newton_cholesky.py FEATURES.npy LABELS.npy

Standardises the features in double precision (not timed), fits to a largest gradient of 1e-9 a
sample, as the trainer does, and prints one line of JSON: seconds of the fit alone (wall and
processor time), mean log-loss, iterations, version.
"""
import json
import sys
import time
import warnings

import numpy
import sklearn
from sklearn.linear_model import LogisticRegression

features = numpy.load(sys.argv[1]).astype(numpy.float64)
labels = numpy.load(sys.argv[2]).ravel() > 0.5
features -= features.mean(axis=0)
scale = features.std(axis=0)
features /= numpy.where(scale > 0.0, scale, 1.0)

warnings.simplefilter("ignore")  # penalty="none" is deprecated since 1.2, None unknown before
model = LogisticRegression(penalty="none", solver="newton-cholesky", tol=1e-9, max_iter=100)
if tuple(int(part) for part in sklearn.__version__.split(".")[:2]) >= (1, 2):
    model.penalty = None
wall = time.perf_counter()
processor = time.process_time()
model.fit(features, labels)
processor = time.process_time() - processor
wall = time.perf_counter() - wall

scores = model.decision_function(features)
log_loss = numpy.mean(numpy.logaddexp(0.0, scores) - labels * scores)
print(json.dumps({"seconds": wall,
                  "processor_seconds": processor,
                  "log_loss": log_loss,
                  "iterations": int(model.n_iter_[0]),
                  "version": sklearn.__version__}))
