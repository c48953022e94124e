# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests scripts/install_packages.sh against stand-ins for dpkg-query, apt-get and sudo, so that
nothing is installed."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/install_packages.sh"


class InstallPackagesTest(unittest.TestCase):

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.log = self.folder / "log"
        self.log.touch()
        self.stand_in("dpkg-query", 'grep -qx "${@: -1}" "$(dirname "$0")/installed" && echo installed')
        self.stand_in("sudo", 'exec "$@"')
        self.stand_in("apt-get", 'echo "$*" >> "$(dirname "$0")/log"')
        self.install()

    def tearDown(self):
        self.temporary.cleanup()

    def stand_in(self, name, text):
        path = self.folder / name
        path.write_text(f"#!/usr/bin/env bash\n{text}\n", encoding="ascii")
        path.chmod(0o755)

    def install(self, *packages):
        (self.folder / "installed").write_text("\n".join(packages) + "\n", encoding="ascii")

    def run_script(self, *args):
        environment = dict(os.environ, PATH=f"{self.folder}:{os.environ['PATH']}")
        return subprocess.run([SCRIPT, *args], env=environment, text=True, capture_output=True,
                              check=False)

    def packages(self, *groups):
        lines = self.run_script("--list", *groups).stdout.splitlines()
        return [line.split(" | ")[0] for line in lines]

    def test_lists_each_package_once_with_its_reason(self):
        listed = self.packages("build", "test", "check", "peers")
        self.assertEqual(len(listed), len(set(listed)))
        self.assertIn("cmake", listed)
        self.assertNotIn("clang-tidy", self.packages("build"))
        self.assertIn("cmake | build configuration", self.run_script("--list", "build").stdout)

    def test_does_nothing_when_all_are_there(self):
        self.install(*self.packages("build"))
        process = self.run_script("build")
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertEqual(process.stdout, "Packages (build): all there.\n")
        self.assertEqual(self.log.read_text(), "")

    def test_installs_what_is_missing_and_says_why(self):
        self.install(*(set(self.packages("build")) - {"ccache", "libfmt-dev"}))
        process = self.run_script("build")
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertRegex(process.stdout, r"ccache +compiles only what changed")
        update, install = self.log.read_text().splitlines()
        self.assertIn("update", update)
        self.assertTrue(install.endswith(" ccache libfmt-dev"), install)

    def test_says_what_to_do_when_apt_get_fails(self):
        self.stand_in("apt-get", "exit 100")
        process = self.run_script("build")
        self.assertEqual(process.returncode, 1)
        self.assertIn("by hand: apt-get install g++ cmake", process.stderr)

    def test_refuses_wrong_groups(self):
        for args in ((), ("bulid",), ("build", "tset"), ("--list",)):
            process = self.run_script(*args)
            self.assertEqual(process.returncode, 2, args)
            self.assertIn("groups: build test check peers", process.stderr)
            self.assertEqual(self.log.read_text(), "")


if __name__ == "__main__":
    unittest.main()
