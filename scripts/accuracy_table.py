#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Held-out accuracy of the four presets with the three energies, as a Markdown table.

Trains on the set's "train" split and evaluates on its "test" split with the handcraft command:

    scripts/accuracy_table.py --handcraft build/release/tools/handcraft datasets/samples/cornell_mini
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

PRESETS = ["all500", "edges150", "window180", "edges54"]
ENERGIES = ["square", "abs", "log"]


def run(command):
    """Runs a command, or ends with what it said."""
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{result.stderr}")


def estimate(figures, key):
    """'0.957 (0.940–0.968)': the value and its 95 % interval over images; null where there is none."""
    if figures[key] is None:
        return "–"
    low, high = figures[key + "_interval"]
    return f"{figures[key]:.3f} ({low:.3f}–{high:.3f})"


def table_row(options, spec, folder):
    model = folder / (spec.replace(",", "_").replace("=", "_") + ".safetensors")
    report = model.with_suffix(".json")
    run([options.handcraft, "train", "grasp-points", options.dataset, "--out", model,
         "--features", spec, "--samples", str(options.samples), "--threads", str(options.threads)])
    run([options.handcraft, "evaluate", model, options.dataset, "--split", "test",
         "--json", report, "--threads", str(options.threads)])
    figures = json.loads(report.read_text())
    counted = f"{figures['best_pixels_good']}/{figures['best_pixels_counted']}"
    return [spec, estimate(figures, "auc"), estimate(figures, "accuracy"),
            estimate(figures, "best_pixel_accuracy"), counted, f"{figures['log_loss']:.3f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("dataset", help="labelled image set with a train and a test split")
    parser.add_argument("--handcraft", default="handcraft", help="the command")
    parser.add_argument("--samples", type=int, default=40000)
    parser.add_argument("--threads", type=int, default=2)
    options = parser.parse_args()
    print("| features | AUC | accuracy at 0.5 | best 15 above 0.9 | good/counted | log-loss |")
    print("|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for preset in PRESETS:
            for energy in ENERGIES:
                row = table_row(options, f"{preset},energy={energy}", pathlib.Path(folder))
                print("| " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()
