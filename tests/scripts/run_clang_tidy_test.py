# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/run_clang_tidy.py"
# Stands for clang-tidy: finds fault with every file that says "fault" itself or in lib/a.h.
FAKE_CLANG_TIDY = """#!/bin/sh
[ "$1" = --version ] && { echo "fake 1"; exit 0; }
for file; do :; done
echo "$file" >> "$LOG"
if cat "$file" "$(dirname "$file")/a.h" | grep -q fault; then echo "$file: a fault"; exit 1; fi
"""


class RunClangTidy(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.temporary.name).resolve()
        for folder in ("bin", "scripts", "lib", "build/dev"):
            (self.root / folder).mkdir(parents=True)
        shutil.copy(SCRIPT, self.root / "scripts")
        (self.root / "bin/clang-tidy").write_text(FAKE_CLANG_TIDY)
        (self.root / "bin/clang-tidy").chmod(0o755)
        (self.root / ".clang-tidy").write_text("Checks: '*'\n")
        (self.root / ".gitignore").write_text("/build/\n/bin/\n/log\n/cache/\n")
        self.cache = self.root / "cache"
        self.write("a.h", "")
        self.write("uses_a.cc", '#include "lib/a.h"\n')
        self.write("alone.cc", "\n")
        self.compiles("uses_a.cc", "alone.cc")
        self.git("init", "--quiet")
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "-m", "Begin")

    def tearDown(self):
        self.temporary.cleanup()

    def compiles(self, *names):
        (self.root / "build/dev/compile_commands.json").write_text(json.dumps(
            [{"directory": str(self.root / "build/dev"), "file": str(self.root / "lib" / name),
              "command": "c++"} for name in names]))

    def git(self, *arguments):
        subprocess.run(["git", "-C", self.root, *arguments], check=True)

    def write(self, name, text):
        (self.root / "lib" / name).write_text(text)

    def run_script(self, *arguments):
        """(exit code, names of the files looked at)"""
        log = self.root / "log"
        log.write_text("")
        environment = dict(os.environ, PATH=f"{self.root / 'bin'}:{os.environ['PATH']}",
                           LOG=str(log), XDG_CACHE_HOME=str(self.cache))
        process = subprocess.run(
            [sys.executable, self.root / "scripts/run_clang_tidy.py", *arguments],
            env=environment, capture_output=True, text=True)
        self.assertEqual(process.stderr, "")
        self.output = process.stdout
        return process.returncode, sorted(pathlib.Path(line).name
                                          for line in log.read_text().splitlines())

    def test_without_a_base_every_source_is_looked_at_once(self):
        self.assertEqual(self.run_script(), (0, ["alone.cc", "uses_a.cc"]))
        self.assertEqual(self.run_script(), (0, []))

    def test_another_clone_knows_what_passed(self):
        self.run_script()
        with tempfile.TemporaryDirectory() as other:
            moved = pathlib.Path(other).resolve() / "clone"
            shutil.copytree(self.root, moved)
            commands = moved / "build/dev/compile_commands.json"
            commands.write_text(commands.read_text().replace(str(self.root), str(moved)))
            self.root = moved
            self.assertEqual(self.run_script(), (0, []))

    def test_what_nobody_asked_for_in_a_month_is_forgotten(self):
        self.run_script()
        for stamp in (self.cache / "handcraft/clang_tidy").iterdir():
            os.utime(stamp, (0, 0))
        self.assertEqual(self.run_script(), (0, ["alone.cc", "uses_a.cc"]))

    def test_without_a_cache_folder_the_build_remembers(self):
        self.cache.write_text("a file, no folder\n")
        self.assertEqual(self.run_script(), (0, ["alone.cc", "uses_a.cc"]))
        self.assertEqual(self.run_script(), (0, []))

    def test_a_finding_fails_until_it_is_mended(self):
        self.write("alone.cc", "fault\n")
        self.assertEqual(self.run_script(), (1, ["alone.cc", "uses_a.cc"]))
        self.assertIn("alone.cc: a fault", self.output)
        self.assertEqual(self.run_script(), (1, ["alone.cc"]))
        self.write("alone.cc", "mended\n")
        self.assertEqual(self.run_script(), (0, ["alone.cc"]))

    def test_a_changed_header_takes_its_users_with_it(self):
        self.run_script()
        self.write("a.h", "fault\n")
        self.assertEqual(self.run_script(), (1, ["uses_a.cc"]))

    def test_a_changed_header_is_looked_at_through_one_source(self):
        for name in ("a.cc", "also_uses_a.cc"):
            self.write(name, '#include "lib/a.h"\n')
        self.compiles("also_uses_a.cc", "uses_a.cc", "a.cc")
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@b", "commit", "--quiet", "-m", "More")
        self.write("a.h", "// changed\n")
        self.assertEqual(self.run_script("--base", "HEAD"), (0, ["a.cc"]))
        self.write("uses_a.cc", '#include "lib/a.h"\n\n')
        self.assertEqual(self.run_script("--base", "HEAD"), (0, ["uses_a.cc"]))

    def test_only_what_differs_from_the_base(self):
        self.assertEqual(self.run_script("--base", "HEAD"), (0, []))
        self.write("a.h", "// changed\n")
        self.assertEqual(self.run_script("--base", "HEAD"), (0, ["uses_a.cc"]))

    def test_all_asks_for_more_than_what_passed(self):
        self.run_script()
        self.assertEqual(self.run_script("--all"), (0, ["alone.cc", "uses_a.cc"]))
        self.assertEqual(self.run_script("--all"), (0, []))

    def test_what_passed_another_configuration_did_not_pass_this_one(self):
        self.run_script()
        (self.root / ".clang-tidy").write_text("Checks: 'a'\n")
        self.assertEqual(self.run_script(), (0, ["alone.cc", "uses_a.cc"]))


if __name__ == "__main__":
    unittest.main()
