# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import run_doc_commands  # noqa: E402


class FakeInstall:
    """An install tree whose runtime has one function, `answer`, and no code."""

    def __init__(self, folder):
        self.folder = folder
        (folder / "include").mkdir()
        (folder / "lib").mkdir()
        (folder / "include/answer.h").write_text("static inline int answer(void) { return 42; }\n")
        (folder / "lib/libhandcraft_runtime.a").write_text("!<arch>\n")

    def prefix(self):
        return str(self.folder)


class RunDocCommands(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "bin").mkdir()
        self.handcraft = self.folder / "bin/handcraft"
        self.handcraft.write_text("#!/bin/sh\necho \"ran $*\"; test \"$1\" != bad\n")
        self.handcraft.chmod(0o755)
        (self.folder / "root/datasets/samples").mkdir(parents=True)
        (self.folder / "root/datasets/samples/a.csv").write_text("1\n")
        run_doc_commands.ROOT = self.folder / "root"

    def tearDown(self):
        self.temporary.cleanup()

    def run_page(self, text):
        """(number of blocks, number of failures, what was printed)"""
        page = self.folder / "page.md"
        page.write_text(text, encoding="utf-8")
        install = self.folder / "install"
        install.mkdir(exist_ok=True)
        installed = FakeInstall(install) if not any(install.iterdir()) else None
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            counts = run_doc_commands.run_page(page, self.handcraft, installed)
        return (*counts, out.getvalue())

    def assert_runs(self, text):
        blocks, failures, out = self.run_page(text)
        self.assertEqual(failures, 0, out)
        self.assertGreater(blocks, 0)

    def assert_fails(self, text, message):
        _, failures, out = self.run_page(text)
        self.assertEqual(failures, 1, out)
        self.assertIn(message, out)

    def test_commands_run_in_order_in_one_folder(self):
        self.assert_runs("```sh\nhandcraft data > made\n```\n\n```sh\ntest -s made\n```\n")

    def test_samples_are_a_copy(self):
        self.assert_runs("```sh\nrm datasets/samples/a.csv\n```\n")
        self.assertTrue((self.folder / "root/datasets/samples/a.csv").exists())

    def test_the_first_failing_command_fails_the_block(self):
        self.assert_fails("```sh\nhandcraft bad\ntrue\n```\n", "exit code 1\nran bad")
        self.assert_fails("```sh\nfalse | true\n```\n", "exit code 1")
        self.assert_fails("```sh\necho $not_set\n```\n", "not_set")

    def test_standard_input_is_closed(self):
        self.assert_fails("```sh\nread answer\n```\n", "exit code 1")

    def test_python(self):
        self.assert_runs("```python\nprint(1)\n```\n")
        self.assert_fails("```python\n1 / 0\n```\n", "ZeroDivisionError")

    def test_programs_are_compiled_and_linked(self):
        program = "#include <answer.h>\nint main(void) { return answer(); }\n"
        self.assert_runs(f"```c\n{program}```\n")

    def test_programs_that_do_not_compile(self):
        self.assert_fails("```c\nint main(void) { return unknown(); }\n```\n", "unknown")

    def test_fragments_of_programs_are_refused(self):
        self.assert_fails("```cpp\nf();\n```\n", "not a complete program")

    def test_code_on_own_headers_is_compiled_alone(self):
        header = self.folder / "root/lib/core/a.h"
        header.parent.mkdir(parents=True)
        header.write_text("int F(int);\n")
        self.assert_runs('```cpp\n#include "lib/core/a.h"\nint G() { return F(1); }\n```\n')
        self.assert_fails('```cpp\n#include "lib/core/a.h"\nint G() { return F(); }\n```\n',
                          "too few arguments")

    def test_only_what_cannot_run_is_merely_shown(self):
        self.assert_runs("```console\n$ ./demo\n$ cmake --preset dev\n```\n")
        self.assert_runs("```console\nhandcraft data import cornell SOURCE \\\n  --out x\n```\n")
        self.assert_fails("```console\nhandcraft train\n```\n", "can be run: mark the block `sh`")

    def test_json(self):
        self.assert_runs('```json\n{"a": 1}\n```\n')
        self.assert_fails('```json\n{"a": 1,}\n```\n', "not JSON")


if __name__ == "__main__":
    unittest.main()
