# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause

import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import check_docs  # noqa: E402


class CheckDocs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        (self.root / "docs/methods").mkdir(parents=True)
        self.write("CHANGELOG.md", "# Changes\n\n## 0.2.0\n\n## 0.1.0\n")
        self.write("docs/README.md", "# Pages\n[a](methods/a.md)\n")
        self.write("docs/methods/a.md", "# The a\n[up](../README.md#pages)\n")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, name, text):
        (self.root / name).write_text(text, encoding="utf-8")

    def assert_fault(self, expected, version="0.2.0"):
        self.assertEqual(check_docs.find_faults(self.root, version), [expected])

    def test_sound_pages_have_no_fault(self):
        self.write("docs/methods/a.md",
                   "[web](https://example.org/x.md) `[code](no.md)`\n"
                   "```text\n[fenced](no.md)\n```\n![picture](b.png)\n[self](#the-b)\n# The *b*\n")
        self.write("docs/methods/b.png", "")
        self.assertEqual(check_docs.find_faults(self.root, "0.2.0"), [])

    def test_links_lead_somewhere(self):
        self.write("README.md", "fine\nsee [x](docs/none.md)\n")
        self.assert_fault("README.md:2: docs/none.md does not exist")
        self.write("README.md", "![x](docs/none.png \"title\")\n")
        self.assert_fault("README.md:1: docs/none.png does not exist")
        self.write("README.md", "[x]: docs/none.md\n")
        self.assert_fault("README.md:1: docs/none.md does not exist")

    def test_anchors_are_headings(self):
        self.write("README.md", "[x](docs/README.md#pages) [y](docs/README.md#leaves)\n")
        self.assert_fault("README.md:1: docs/README.md#leaves: no heading of that name")

    def test_pages_can_be_found(self):
        self.write("docs/methods/b.md", "# b\n")
        self.assert_fault(
            "docs/methods/b.md:1: no page reachable from docs/README.md links here")

    def test_fences_say_what_they_hold(self):
        self.write("README.md", "\n```bash\nls\n```\n")
        self.assert_fault("README.md:2: fence 'bash' is not one of c console cpp json python sh"
                          " text (docs/contributing.md)")

    def test_a_block_within_a_block_is_text(self):
        self.write("README.md", "````text\n```bash\n```\n````\n")
        self.assertEqual(check_docs.find_faults(self.root, "0.2.0"), [])

    def test_newest_version_is_the_projects(self):
        self.assert_fault("CHANGELOG.md:3: newest version is 0.2.0,"
                          " the project's (CMakeLists.txt) is 0.1.0", version="0.1.0")
        self.write("CHANGELOG.md", "# Changes\n")
        self.assert_fault("CHANGELOG.md:1: no heading '## MAJOR.MINOR.PATCH'")


if __name__ == "__main__":
    unittest.main()
