# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the robot gets: a small shared library that needs only the C and C++ run-time libraries and
shows only the C interface.

    shared_library_test.py LIBRARY HEADER
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

MAX_BYTES = 262_144
ALLOWED_LIBRARIES = {"libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1",
                     "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}


def output_of(*command):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout


class SharedLibrary(unittest.TestCase):
    library = header = None

    def test_is_small_when_stripped(self):
        with tempfile.TemporaryDirectory() as folder:
            stripped = pathlib.Path(folder) / "stripped.so"
            subprocess.run(["strip", "-o", stripped, self.library], check=True)
            self.assertLessEqual(stripped.stat().st_size, MAX_BYTES)

    def test_needs_only_the_run_time_libraries(self):
        needed = set(re.findall(r"\(NEEDED\).*\[(.+)\]", output_of("readelf", "-dW", self.library)))
        self.assertIn("libc.so.6", needed)
        self.assertEqual(needed - ALLOWED_LIBRARIES, set())

    def test_shows_exactly_the_functions_of_the_header(self):
        declared = set(re.findall(r"HC_API [^;(]*?\b(hc_\w+)\(", self.header.read_text()))
        shown = {line.split()[-1] for line in
                 output_of("nm", "--dynamic", "--defined-only", self.library).splitlines()}
        self.assertGreater(len(declared), 10)
        self.assertEqual(shown, declared)

    def test_does_not_ask_for_an_executable_stack(self):
        segments = output_of("readelf", "-lW", self.library)
        self.assertRegex(segments, r"GNU_STACK.*RW ")


if __name__ == "__main__":
    SharedLibrary.library = pathlib.Path(sys.argv.pop(1))
    SharedLibrary.header = pathlib.Path(sys.argv.pop(1))
    unittest.main()
