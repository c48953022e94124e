# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the `handcraft` program as a shell does, for what only a process of its own can show: exit
codes, which stream is used, terminals, full disks, signals.

    command_test.py HANDCRAFT SOURCE_FOLDER
"""

import json
import os
import pathlib
import pty
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

HANDCRAFT = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
TABLE = SOURCE / "datasets/samples/tables/breast_w.csv"
IMAGES = SOURCE / "datasets/samples/cornell_mini"


def full_disk(max_bytes):
    """Makes every write beyond max_bytes fail, as a full disk does."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (max_bytes, max_bytes))
    return limit


class CommandTest(unittest.TestCase):

    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def run_handcraft(self, *args, **options):
        return subprocess.run([str(HANDCRAFT), *map(str, args)], cwd=self.folder, text=True,
                              stdin=subprocess.DEVNULL, stdout=options.pop("stdout", -1),
                              stderr=subprocess.PIPE, timeout=120, check=False, **options)

    def train_logistic(self, **options):
        return self.run_handcraft("train", "logistic", TABLE, "--label", "class", "--out",
                                  "model", **options)

    def left_behind(self):
        return sorted(path.name for path in self.folder.iterdir())

    def assert_fails(self, process, code, message):
        self.assertEqual(process.returncode, code, process.stderr)
        self.assertTrue(process.stderr.startswith("handcraft: error: "), process.stderr)
        self.assertIn(message, process.stderr)

    def test_results_go_to_stdout_and_errors_to_stderr(self):
        process = self.train_logistic()
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertIn("clump_thickness", process.stdout)
        process = self.run_handcraft("inspect", "no_such_model")
        self.assertEqual(process.stdout, "")
        self.assert_fails(process, 3, "no_such_model")

    def test_exit_codes(self):
        (self.folder / "separated.csv").write_text("x,y\n1,a\n2,a\n3,b\n4,b\n", encoding="ascii")
        for code, args in ((0, ("--version",)),
                           (2, ("train", "logistic", TABLE)),
                           (3, ("check-model", TABLE)),
                           (4, ("train", "logistic", "separated.csv", "--label", "y"))):
            self.assertEqual(self.run_handcraft(*args).returncode, code, args)

    def test_a_full_disk_leaves_nothing(self):
        self.assert_fails(self.train_logistic(preexec_fn=full_disk(100)), 3, "cannot write")
        self.assertEqual(self.left_behind(), [])

    def test_a_full_disk_keeps_the_old_model(self):
        (self.folder / "model").write_text("old", encoding="ascii")
        self.assert_fails(self.train_logistic(preexec_fn=full_disk(100)), 3, "cannot write")
        self.assertEqual(self.left_behind(), ["model"])
        self.assertEqual((self.folder / "model").read_text(encoding="ascii"), "old")

    def test_a_full_disk_leaves_no_prediction_and_no_data_set(self):
        process = self.run_handcraft("train", "grasp-points", IMAGES, "--out", "model",
                                     "--features", "edges54", "--samples", "4000")
        self.assertEqual(process.returncode, 0, process.stderr)
        images = sorted((IMAGES / "images").glob("*.png"))[:2]
        # The JSON fits, the picture does not.
        process = self.run_handcraft("predict", "model", *images, "--min-probability", "0.1",
                                     "--out", "out", preexec_fn=full_disk(20000))
        self.assert_fails(process, 3, "cannot write")
        process = self.run_handcraft("data", "import", "cornell", SOURCE / "tests/data/cornell",
                                     "--out", "set", preexec_fn=full_disk(2000))
        self.assert_fails(process, 3, "")
        process = self.run_handcraft("evaluate", "model", IMAGES, "--html", "report.html",
                                     "--resamples", "10", preexec_fn=full_disk(20000))
        self.assert_fails(process, 3, "cannot write")
        self.assertEqual(self.left_behind(), ["model"])

    def import_samples(self, out, **options):
        return self.run_handcraft("data", "import", "folders", IMAGES, "--image-suffix", "r",
                                  "--good", "255", "--dont-care", "128", "--max-images", "8",
                                  "--threads", "1", "--out", out, **options)

    def bytes_of(self, folder):
        root = self.folder / folder
        return {path.relative_to(root): path.read_bytes()
                for path in sorted(root.rglob("*")) if path.is_file()}

    def num_begun(self):
        """Pictures and masks that the import which is running has written."""
        try:
            return len(list(self.folder.glob("again.*/again/*/*.png")))
        except FileNotFoundError:  # it has moved its folder to its place meanwhile
            return 0

    def assert_starts_again(self, whole):
        """Nothing of a stopped import is where its set was to be; another makes all of it."""
        self.assertFalse((self.folder / "again").exists())
        process = self.import_samples("again")
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertEqual(self.bytes_of("again"), whole)
        shutil.rmtree(self.folder / "again")

    def test_a_killed_import_leaves_no_part_of_a_set(self):
        self.assertEqual(self.import_samples("set").returncode, 0)
        whole = self.bytes_of("set")
        # The system ends the program at its first write beyond a size that some pictures have.
        sizes = sorted(len(data) for name, data in whole.items() if name.parts[0] == "images")
        for max_bytes in (100, sizes[len(sizes) // 2], sizes[-1] - 1):
            process = self.import_samples("again", preexec_fn=lambda limit=max_bytes: (
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0)),
                signal.signal(signal.SIGXFSZ, signal.SIG_DFL),
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))))
            self.assertEqual(process.returncode, -signal.SIGXFSZ, process.stderr)
            self.assertTrue(list(self.folder.glob("again.*")), "what it had begun lies beside")
            self.assert_starts_again(whole)

    def test_an_import_killed_at_any_time_starts_again(self):
        self.assertEqual(self.import_samples("set").returncode, 0)
        whole = self.bytes_of("set")
        for num_files in (1, 3, 10):
            process = subprocess.Popen(
                [str(HANDCRAFT), "data", "import", "folders", str(IMAGES), "--image-suffix", "r",
                 "--good", "255", "--dont-care", "128", "--max-images", "8", "--out", "again"],
                cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL)
            while process.poll() is None and self.num_begun() < num_files:
                pass
            process.kill()
            process.wait(timeout=120)
            if (self.folder / "again").exists():  # it was done before: whole, then
                self.assertEqual(self.bytes_of("again"), whole)
                shutil.rmtree(self.folder / "again")
            self.assert_starts_again(whole)
            for left in self.folder.glob("again.*"):
                shutil.rmtree(left)

    def test_a_full_standard_output_is_an_error(self):
        for args in (("train", "logistic", TABLE, "--label", "class"), ("--help",)):
            with open(self.folder / "out", "w", encoding="ascii") as out:
                process = self.run_handcraft(*args, stdout=out, preexec_fn=full_disk(100))
            self.assert_fails(process, 3, "standard output: cannot write")

    def test_standard_output_holds_nothing_but_json(self):
        self.train_logistic()
        for args in (("train", "logistic", TABLE, "--label", "class", "--json"),
                     ("evaluate", "model", TABLE, "--json"),
                     ("predict", "model", TABLE, "--json"),
                     ("inspect", "model", "--json"),
                     ("check-model", "model", "--json"),
                     ("data", "info", IMAGES, "--json"),
                     ("data", "check", IMAGES, "--json")):
            process = self.run_handcraft(*args)
            self.assertEqual(process.stderr, "", args)
            json.loads(process.stdout)

    def test_progress_is_drawn_on_a_terminal_alone(self):
        terminal, program_side = pty.openpty()
        process = subprocess.Popen([HANDCRAFT, "data", "info", IMAGES], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=program_side)
        os.close(program_side)
        drawn = b""
        try:
            while block := os.read(terminal, 65536):
                drawn += block
        except OSError:  # the other side is closed
            pass
        os.close(terminal)
        self.assertEqual(process.wait(), 0)
        self.assertIn(b"reading masks  [####", drawn)
        self.assertTrue(drawn.endswith(b"\r\x1b[K"), drawn[-40:])
        self.assertEqual(self.run_handcraft("data", "info", IMAGES).stderr, "")

    def test_numbers_do_not_depend_on_the_locale(self):
        plain = self.run_handcraft("train", "logistic", TABLE, "--label", "class", "--json").stdout
        german = dict(os.environ, LC_ALL="de_DE.UTF-8", LANG="de_DE.UTF-8")
        self.assertEqual(self.run_handcraft("train", "logistic", TABLE, "--label", "class",
                                            "--json", env=german).stdout, plain)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
