# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ridge references for tests/trainers/logistic_irls, beside make_logistic_references.R:

    python3 make_logistic_references.py

reads logistic_NAME.csv of this folder and writes logistic_NAME_ridge.csv: scikit-learn's
newton-cholesky with C = 1 / ridge on standardised features (divisor n), weights and intercept of
those. Made with scikit-learn 1.2.1.
"""
import pathlib

import numpy as np
from sklearn.linear_model import LogisticRegression

FOLDER = pathlib.Path(__file__).parent
RIDGE = 2.0

for name in ("iris", "heart", "collinear"):
    table = np.loadtxt(FOLDER / f"logistic_{name}.csv", delimiter=",", skiprows=1)
    features, labels = table[:, :-1], table[:, -1]
    features = (features - features.mean(axis=0)) / features.std(axis=0)
    model = LogisticRegression(C=1 / RIDGE, solver="newton-cholesky", tol=1e-14, max_iter=100)
    model.fit(features, labels)
    with open(FOLDER / f"logistic_{name}_ridge.csv", "w", encoding="ascii") as out:
        out.write("term,estimate,standard_error\n")
        out.write(f"(Intercept),{model.intercept_[0]:.17g},NA\n")
        for index, weight in enumerate(model.coef_[0]):
            out.write(f"x{index},{weight:.17g},NA\n")
