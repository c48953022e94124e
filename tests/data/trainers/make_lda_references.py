# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""References for tests/trainers/lda:

    python3 make_lda_references.py

reads logistic_NAME.csv of this folder and writes
- lda_NAME.csv: weights and intercept of scikit-learn's LinearDiscriminantAnalysis (solver svd,
  which divides the pooled covariance by n - 2), priors from the data;
- lda_NAME_ledoit_wolf.csv: the same with the pooled correlation shrunk towards the identity by
  scikit-learn's Ledoit-Wolf share of the standardised rows about their class means, which the line
  `shrinkage` states.
Made with scikit-learn 1.2.1.
"""
import pathlib

import numpy as np
from sklearn.covariance import ledoit_wolf
from sklearn.discriminant_analysis import LinearDiscriminantAnalysis

FOLDER = pathlib.Path(__file__).parent


def write(name, intercept, weights, more=()):
    with open(FOLDER / f"lda_{name}.csv", "w", encoding="ascii") as out:
        out.write("term,estimate\n")
        out.write(f"(Intercept),{intercept:.17g}\n")
        for index, weight in enumerate(weights):
            out.write(f"x{index},{weight:.17g}\n")
        for key, value in more:
            out.write(f"{key},{value:.17g}\n")


for name in ("iris", "heart", "breast_w"):
    table = np.loadtxt(FOLDER / f"logistic_{name}.csv", delimiter=",", skiprows=1)
    x, labels = table[:, :-1], table[:, -1] > 0.5
    model = LinearDiscriminantAnalysis(solver="svd", tol=1e-12).fit(x, labels)
    write(name, model.intercept_[0], model.coef_[0])

    means = np.array([x[~labels].mean(axis=0), x[labels].mean(axis=0)])
    centred = x - means[labels.astype(int)]
    scale = centred.std(axis=0)
    shrunk, share = ledoit_wolf(centred / scale, assume_centered=True)
    covariance = shrunk * np.outer(scale, scale) * len(x) / (len(x) - 2)
    weights = np.linalg.solve(covariance, means[1] - means[0])
    prior = labels.mean()
    intercept = -weights @ means.mean(axis=0) + np.log(prior / (1 - prior))
    write(name + "_ledoit_wolf", intercept, weights, [("shrinkage", share)])
