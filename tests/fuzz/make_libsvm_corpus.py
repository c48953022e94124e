# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files for libsvm_fuzz, each named after what it is.

    python3 tests/fuzz/make_libsvm_corpus.py tests/fuzz/corpus/libsvm
"""

import pathlib
import sys

MODEL = ("svm_type c_svc\nkernel_type {kernel}nr_class 3\ntotal_sv 3\nrho 0.5 -0.25 1\n"
         "label 1 -1 7\nnr_sv 1 1 1\nSV\n1 0.5 1:1 3:-2 \n-1 0.25 2:0.5 \n-0.5 -0.25 1:-1 2:3 \n")
LINEAR = MODEL.format(kernel="linear\n")


def files():
    yield "linear", LINEAR
    yield "polynomial", MODEL.format(kernel="polynomial\ndegree 3\ngamma 0.5\ncoef0 1\n")
    yield "rbf", MODEL.format(kernel="rbf\ngamma 0.5\n")
    yield "probabilities", LINEAR.replace("nr_sv", "probA 1 2 3\nprobB 1 2 3\nnr_sv")
    yield "empty", ""
    yield "header_alone", LINEAR[:LINEAR.index("SV\n")]
    yield "more_vectors_than_counted", LINEAR + "1 1 1:1 \n"
    yield "fewer_vectors_than_counted", LINEAR[:LINEAR.rindex("-0.5")]
    yield "huge_counts", LINEAR.replace("total_sv 3", "total_sv 4294967297")
    yield "huge_class_count", LINEAR.replace("nr_class 3", "nr_class 2000000000")
    yield "one_class", LINEAR.replace("nr_class 3", "nr_class 1")
    yield "huge_index", LINEAR.replace("3:-2", "2147483647:-2")
    yield "index_zero", LINEAR.replace("1:1", "0:1")
    yield "indices_fall", LINEAR.replace("1:1 3:-2", "3:-2 1:1")
    yield "not_a_number", LINEAR.replace("0.25 2", "nan 2")
    yield "overflows", LINEAR.replace("1:1", "1:1e400")
    yield "no_gamma", MODEL.format(kernel="rbf\n")
    yield "one_class_svm", LINEAR.replace("c_svc", "one_class")
    yield "line_ends_of_windows", LINEAR.replace("\n", "\r\n")
    yield "no_line_end", LINEAR.rstrip()
    yield "zero_byte", LINEAR.replace("label 1", "label \0")
    yield "same_label_twice", LINEAR.replace("label 1 -1", "label 1 1")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files():
        (folder / name).write_bytes(text.encode())
    print(f"{len(list(files()))} files written to {folder}")


if __name__ == "__main__":
    main()
