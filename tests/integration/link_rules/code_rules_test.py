# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows that code_rules.py finds what it looks for: each rule is broken once in a planted tree."""

import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import code_rules  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
HEADER = ("// SPDX-FileCopyrightText: 2026 the Handcraft authors\n"
          "// SPDX-License-Identifier: BSD-3-Clause\n")
ADD_LIBRARY = "lib/cmake/handcraft_add_library.cmake"


class PlantedTree(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        (self.root / "lib/cmake").mkdir(parents=True)
        shutil.copy(ROOT / ADD_LIBRARY, self.root / ADD_LIBRARY)

    def tearDown(self):
        self.folder.cleanup()

    def violations(self, path, text, header=HEADER):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(header + text, encoding="utf-8")
        violations, _ = code_rules.find_violations(self.root)
        file.unlink()
        return violations

    def assert_refused(self, path, text, message):
        found = self.violations(path, text)
        self.assertEqual(len(found), 1, found)
        self.assertIn(message, found[0])
        self.assertIn(path, found[0])

    def assert_allowed(self, path, text):
        self.assertEqual(self.violations(path, text), [])


class OwnIncludes(PlantedTree):
    def test_lower_layers_never_use_higher_ones(self):
        self.assert_refused("lib/core/a.h", '#include "lib/features/b.h"\n',
                            "layer core may not use layer features")
        self.assert_refused("lib/runtime/a.cc", '  #  include "lib/model_io/b.h"\n',
                            "layer runtime may not use layer model_io")
        self.assert_refused("lib/features/a.h", '#include "tools/b.h"\n',
                            "layer features may not use layer tools")
        self.assert_refused("datasets/a.h", '#include "trainers/lda/b.h"\n',
                            "layer datasets may not use layer trainer")

    def test_one_trainer_never_uses_another(self):
        self.assert_refused("trainers/lda/a.h", '#include "trainers/pca/b.h"\n',
                            "one trainer never uses another")

    def test_the_line_is_named(self):
        found = self.violations("lib/core/a.h", '\n\n#include "lib/runtime/b.h"\n')
        self.assertTrue(found[0].startswith("lib/core/a.h:5: "), found)

    def test_paths_start_at_the_root(self):
        self.assert_refused("lib/core/a.cc", '#include "a.h"\n', "by their path from the root")
        self.assert_refused("lib/core/a.cc", '#include "../features/a.h"\n', "from the root")
        self.assert_refused("lib/core/a.cc", '#include "lib/core/../features/a.h"\n', "from the root")
        self.assert_refused("lib/core/a.cc", '#include "tests/support/a.h"\n', "no test is")

    def test_macros_cannot_hide_an_include(self):
        self.assert_refused("lib/core/a.cc", "#include HEADER\n", "cannot be checked")

    def test_folders_outside_the_table(self):
        self.assert_refused("lib/utils/a.h", "", "layer utils has no row")

    def test_what_the_table_allows(self):
        self.assert_allowed("lib/core/a.cc", '#include "lib/core/a.h"\n#include <vector>\n')
        self.assert_allowed("trainers/lda/a.cc", '#include "trainers/lda/a.h"\n'
                            '#include "lib/model_io/b.h"\n')
        self.assert_allowed("tools/a.cc", '#include "experiments/metrics/b.h"\n')


class OutsideIncludes(PlantedTree):
    def test_third_parties_stay_in_their_layers(self):
        for path, header, target in (
                ("lib/features/a.h", "opencv2/core.hpp", "opencv_core"),
                ("lib/runtime/a.cc", "Eigen/Core", "Eigen3::Eigen"),
                ("lib/core/a.cc", "nlohmann/json.hpp", "nlohmann_json::nlohmann_json"),
                ("datasets/a.cc", "CLI/CLI.hpp", "CLI11::CLI11"),
                ("lib/core/a.cc", "cblas.h", "BLAS::BLAS")):
            self.assert_refused(path, f"#include <{header}>\n", f"may not use {target}")

    def test_unknown_headers(self):
        self.assert_refused("tools/a.cc", "#include <boost/any.hpp>\n", "no target of the link table")
        self.assert_refused("lib/core/a.cc", "#include <cuda.h>\n", "no target of the link table")

    def test_intrinsics_stay_in_features(self):
        self.assert_refused("lib/core/a.cc", "#include <immintrin.h>\n", "layer core may not use intrinsics")
        self.assert_allowed("lib/features/a.cc", "#include <immintrin.h>\n")

    def test_what_the_table_allows(self):
        self.assert_allowed("lib/features/a.cc", "#include <hwy/highway.h>\n#include <sys/mman.h>\n")
        self.assert_allowed("lib/perception/a.cc", "#include <opencv2/imgproc.hpp>\n")

    def test_a_third_party_nobody_can_check(self):
        table = self.root / ADD_LIBRARY
        table.write_text(table.read_text() + "set(HANDCRAFT_THIRD_PARTY_core foo::foo)\n")
        found, _ = code_rules.find_violations(self.root)
        self.assertEqual(len(found), 1, found)
        self.assertIn("no header pattern for foo::foo", found[0])


class Text(PlantedTree):
    def test_libraries_do_not_print(self):
        for statement in ("std::cout << 1;", "std::cerr << 1;", 'printf("x");',
                          'fprintf(stderr, "x");', 'fmt::print("x");', 'puts("x");'):
            self.assert_refused("lib/core/a.cc", statement + "\n", "a library does not print")
        self.assert_allowed("tools/a.cc", "std::cout << 1;\n")
        self.assert_allowed("lib/core/a.cc", "// never std::cout\n/* nor\n printf( */\n")
        self.assert_allowed("lib/core/a.cc", "snprintf(buffer, 8, text);\n")

    def test_only_our_generator_draws(self):
        for statement in ("auto m = Eigen::MatrixXd::Random(3, 3);", "m.setRandom();",
                          "int i = rand();", "std::srand(1);", "std::random_device device;",
                          "std::normal_distribution<double> n;", "std::mt19937 engine;"):
            self.assert_refused("tests/lib/core/a_test.cc", statement + "\n", "only handcraft::Rng")

    def test_no_time_seeds_and_whole_namespaces(self):
        self.assert_refused("lib/core/a.cc", "Seed(time(nullptr));\n", "no time seeds")
        self.assert_refused("lib/core/a.cc", "using namespace std;\n", "name what you use")

    def test_size_header_and_unfinished_business(self):
        self.assert_refused("lib/core/a.h", "\n" * 200, "split it (200 at most)")
        self.assert_refused("lib/core/a.cc", "// TO" "DO: later\n", "unfinished business")
        found = self.violations("lib/core/a.h", "#pragma once\n", header="")
        self.assertIn("SPDX header is missing", found[0])

    def test_flags_that_change_results(self):
        for flag in ("-march=" "native", "-f" "fast-math", "-O" "fast"):
            found = self.violations("lib/core/CMakeLists.txt",
                                    f"target_compile_options(a PRIVATE {flag})\n")
            self.assertEqual(len(found), 1, found)
            self.assertIn(f"{flag} makes results depend", found[0])


class TheProject(unittest.TestCase):
    def test_has_no_violation_and_was_really_read(self):
        violations, num_includes = code_rules.find_violations(ROOT)
        self.assertEqual(violations, [])
        self.assertGreater(num_includes, 100)


if __name__ == "__main__":
    unittest.main()
