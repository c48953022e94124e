# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws svm_classes.libsvm and writes what libsvm makes of it.

    python3 make_svm_references.py FOLDER

Run with Python 3.11 and libsvm 3.24 (Debian's libsvm-tools: svm-train, svm-predict). For each kernel
it writes svm_classes_KERNEL.model, libsvm's own model, and svm_classes_KERNEL.labels, what svm-predict
says of every row.
"""

import pathlib
import random
import subprocess
import sys

KERNELS = {
    "linear": ["-t", "0", "-c", "0.5"],
    "poly": ["-t", "1", "-d", "3", "-g", "0.25", "-r", "1", "-c", "1"],
    "rbf": ["-t", "2", "-g", "0.4", "-c", "2"],
}


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    draw = random.Random(5)
    labels = [7, -2, 3, 11]
    centres = {label: [draw.uniform(-1, 1) for _ in range(4)] for label in labels}
    lines = []
    for _ in range(80):
        label = draw.choice(labels)
        row = [round(c + draw.gauss(0, 0.7), 3) for c in centres[label]]
        # Zeros are left out, as libsvm's files have it.
        row[draw.randrange(4)] *= draw.random() < 0.8
        lines.append(f"{label} " + " ".join(f"{i}:{x:g}" for i, x in enumerate(row, 1) if x))
    table = folder / "svm_classes.libsvm"
    table.write_text("\n".join(lines) + "\n")
    for name, options in KERNELS.items():
        model = folder / f"svm_classes_{name}.model"
        said = folder / f"svm_classes_{name}.labels"
        subprocess.run(["svm-train", "-q", *options, table, model], check=True)
        subprocess.run(["svm-predict", "-q", table, model, said], check=True)


if __name__ == "__main__":
    main()
