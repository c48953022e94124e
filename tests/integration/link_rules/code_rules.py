# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the sources to the link table and to the rules of docs/conventions.md that a text search
can see.

    python3 code_rules.py ROOT

The link table is read from lib/cmake/handcraft_add_library.cmake by CMake itself. Prints one line a
violation, `path:line: what is wrong`, and exits 1 when there is any; exits 2 when there was nothing
to look at, so that a wrong path cannot pass.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
from typing import Dict, Iterator, List, NamedTuple, Set, Tuple

SOURCE_ROOTS = ("lib", "trainers", "datasets", "experiments", "tools")
LIBRARY_ROOTS = ("lib", "trainers", "datasets", "experiments")
CPP_SUFFIXES = (".h", ".cc", ".c")

# Where a third-party header comes from: pattern of the path in <...> -> CMake target.
THIRD_PARTY_HEADERS = {
    r"(unsupported/)?Eigen/": "Eigen3::Eigen",
    r"hwy/": "hwy_headers",
    r"kdl/": "orocos_kdl",
    r"embree3/": "embree",
    r"opencv2/core[/.]": "opencv_core",
    r"opencv2/imgproc[/.]": "opencv_imgproc",
    r"opencv2/imgcodecs[/.]": "opencv_imgcodecs",
    r"opencv2/calib3d[/.]": "opencv_calib3d",
    r"opencv2/ml[/.]": "opencv_ml",
    r"pcl/(segmentation/|point_|ModelCoefficients)": "pcl_segmentation",
    r"pcl/filters/": "pcl_filters",
    r"nlohmann/": "nlohmann_json::nlohmann_json",
    r"zlib\.h$": "ZLIB::ZLIB",
    r"tinyxml2\.h$": "tinyxml2::tinyxml2",
    r"toml\+\+/": "tomlplusplus::tomlplusplus",
    r"fmt/": "fmt::fmt",
    r"CLI/": "CLI11::CLI11",
    r"benchmark/": "benchmark::benchmark",
    r"cblas\.h$": "BLAS::BLAS",
    r"lapacke\.h$": "LAPACK::LAPACK",
}
# Targets that bring no header of their own: the standard library's threads.
HEADERLESS_TARGETS = {"Threads::Threads"}

STANDARD_HEADER = re.compile(r"[a-z_]+$")
C_AND_POSIX_HEADER = re.compile(
    r"(assert|ctype|errno|fcntl|float|inttypes|limits|locale|malloc|math|signal|stdbool|stddef|stdint"
    r"|stdio|stdlib|string|time|unistd|dlfcn|sys/[a-z_]+)\.h$")
INTRINSICS_HEADER = re.compile(r"([a-z]*mmintrin|immintrin|arm_[a-z]+|cpuid)\.h$")
INTRINSICS_LAYERS = {"features", "runtime", "experiments"}  # the last measures the peak

INCLUDE = re.compile(r'\s*#\s*include\s*(?:<(?P<angle>[^>]+)>|"(?P<quote>[^"]+)"|(?P<macro>\w+))')


class Rule(NamedTuple):
    """Text that must not occur in the C++ files below these roots."""

    pattern: "re.Pattern[str]"
    roots: Tuple[str, ...]
    message: str


CPP_RULES = (
    Rule(re.compile(r"std::(cout|cerr|clog)\b|\b[fv]?printf?\s*\(|\bf?puts\s*\("),
         LIBRARY_ROOTS,
         "a library does not print: progress goes to a callback, faults to handcraft::Error"),
    Rule(re.compile(r"\b(set)?Random\s*\(|(?<![\w:.])s?rand\s*\(|std::s?rand\b|random_device"),
         SOURCE_ROOTS + ("tests",),
         "only handcraft::Rng draws: the same seed must give the same numbers everywhere"),
    Rule(re.compile(r"std::\w+_distribution\b|\bmt19937|default_random_engine"),
         SOURCE_ROOTS + ("tests",),
         "only handcraft::Rng draws: the standard leaves distributions to each library"),
    Rule(re.compile(r"\btime\s*\(\s*(NULL|nullptr|0)\s*\)"),
         SOURCE_ROOTS + ("tests",), "no time seeds, no time stamps"),
    Rule(re.compile(r"\busing\s+namespace\b"),
         SOURCE_ROOTS + ("tests",), "name what you use: `using` whole namespaces is not done here"),
)
# Written with a bracket so that this file does not trip over itself.
FORBIDDEN_FLAG = re.compile(r"-m(arch|cpu)=[n]ative|-O[f]ast|-f[f]ast-math|-f[u]nsafe-math")
UNFINISHED = re.compile(r"\b(TO[D]O|FIX[M]E)\b")
SPDX_HEADER = re.compile(r"(//|/\*) SPDX-FileCopyrightText: 2026 the Handcraft authors\n"
                         r"(//| \*) SPDX-License-Identifier: BSD-3-Clause\n")
MAX_HEADER_LINES = 200
INTERFACE = "lib/runtime/handcraft_runtime.h"  # all that the robot gets: one header, long or not
MAX_SOURCE_LINES = 400  # also of -inl.h: code that is compiled once for each instruction set
MAX_TEST_LINES = 450


def read_link_table(root: pathlib.Path) -> Dict[str, Set[str]]:
    """HANDCRAFT_MAY_LINK_<layer> and HANDCRAFT_THIRD_PARTY_<layer> -> set of names."""
    script = pathlib.Path(__file__).with_name("print_link_table.cmake")
    with tempfile.NamedTemporaryFile("r", suffix=".txt") as out:
        subprocess.run(["cmake", f"-DROOT={root}", f"-DOUT={out.name}", "-P", script], check=True)
        rows = out.read().splitlines()
    table = {}
    for line in rows:
        name, _, value = line.partition("=")
        table[name] = set(filter(None, value.split(";")))
    return table


def layer_and_module(path: str):
    """lib/core/x.h -> (core, core); trainers/lda/x.h -> (trainer, lda); tools/x.cc -> (tools, tools)."""
    parts = path.split("/")
    if parts[0] == "lib":
        return parts[1], parts[1]
    if parts[0] == "trainers":
        return "trainer", parts[1]
    return parts[0], parts[0]


def check_own_include(layer: str, module: str, header: str, table) -> str:
    """What is wrong with #include "header" in this layer, or nothing."""
    if header.split("/")[0] not in SOURCE_ROOTS or "/../" in header:
        return f'"{header}": own headers are included by their path from the root, and no test is'
    other_layer, other_module = layer_and_module(header)
    if other_module == module:
        return ""
    if layer == "trainer" and other_layer == "trainer":
        return f'"{header}": one trainer never uses another'
    if other_layer not in table[f"HANDCRAFT_MAY_LINK_{layer}"]:
        return f'"{header}": layer {layer} may not use layer {other_layer}'
    return ""


def check_outside_include(layer: str, header: str, table) -> str:
    """What is wrong with #include <header> in this layer, or nothing."""
    for pattern, target in THIRD_PARTY_HEADERS.items():
        if re.match(pattern, header):
            if target in table[f"HANDCRAFT_THIRD_PARTY_{layer}"]:
                return ""
            return f"<{header}>: layer {layer} may not use {target}"
    if STANDARD_HEADER.match(header) or C_AND_POSIX_HEADER.match(header):
        return ""
    if INTRINSICS_HEADER.match(header):
        fault = f"<{header}>: layer {layer} may not use intrinsics"
        return "" if layer in INTRINSICS_LAYERS else fault
    return f"<{header}>: no target of the link table is known to bring this header"


def check_includes(path: str, lines: List[str], table) -> Iterator[str]:
    layer, module = layer_and_module(path)
    if f"HANDCRAFT_MAY_LINK_{layer}" not in table:
        yield f"{path}:1: layer {layer} has no row in the link table"
        return
    for number, line in enumerate(lines, 1):
        include = INCLUDE.match(line)
        if not include:
            continue
        if include["macro"]:
            fault = f"{include['macro']}: an include that cannot be checked"
        elif include["quote"]:
            fault = check_own_include(layer, module, include["quote"], table)
        else:
            fault = check_outside_include(layer, include["angle"], table)
        if fault:
            yield f"{path}:{number}: {fault}"


def without_comments(text: str) -> str:
    """Comments blanked out, line numbers kept; a `//` within a string ends its line here too."""
    text = re.sub(r"/\*.*?\*/", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def max_lines(path: str) -> int:
    if path.startswith("tests/"):
        return MAX_TEST_LINES
    is_header = path.endswith(".h") and not path.endswith("-inl.h") and path != INTERFACE
    return MAX_HEADER_LINES if is_header else MAX_SOURCE_LINES


def check_text(path: str, text: str) -> Iterator[str]:
    root = path.split("/")[0]
    limit = max_lines(path)
    if text.count("\n") > limit:
        yield f"{path}:1: {text.count(chr(10))} lines: split it ({limit} at most)"
    if not SPDX_HEADER.match(text):
        yield f"{path}:1: the two-line SPDX header is missing"
    for number, line in enumerate(without_comments(text).splitlines(), 1):
        for rule in CPP_RULES:
            if root in rule.roots and rule.pattern.search(line):
                yield f"{path}:{number}: {rule.message}"
    for number, line in enumerate(text.splitlines(), 1):
        if UNFINISHED.search(line):
            yield f"{path}:{number}: unfinished business"


def check_cmake(path: str, text: str) -> Iterator[str]:
    for number, line in enumerate(text.splitlines(), 1):
        flag = FORBIDDEN_FLAG.search(line.split("#")[0])
        if flag:
            yield (f"{path}:{number}: {flag[0]} makes results depend on the machine"
                   " or breaks IEEE arithmetic")


def check_third_parties_are_known(table) -> Iterator[str]:
    """A target without a header pattern would be a row of the table that nothing checks."""
    known = set(THIRD_PARTY_HEADERS.values()) | HEADERLESS_TARGETS
    for name, targets in sorted(table.items()):
        if name.startswith("HANDCRAFT_THIRD_PARTY_"):
            for target in sorted(targets - known):
                yield f"{name}: no header pattern for {target} (tests/integration/link_rules)"


def find_violations(root: pathlib.Path):
    """(violations, number of include lines seen)"""
    table = read_link_table(root)
    violations = list(check_third_parties_are_known(table))
    num_includes = 0
    for folder in SOURCE_ROOTS + ("tests",):
        for file in sorted((root / folder).rglob("*")):
            path = file.relative_to(root).as_posix()
            if file.suffix in CPP_SUFFIXES:
                text = file.read_text(encoding="utf-8")
                violations += check_text(path, text)
                if folder != "tests":
                    violations += check_includes(path, text.splitlines(), table)
                    num_includes += sum(bool(INCLUDE.match(line)) for line in text.splitlines())
            elif file.suffix == ".cmake" or file.name == "CMakeLists.txt":
                violations += check_cmake(path, file.read_text(encoding="utf-8"))
    for name in ("CMakeLists.txt", "CMakePresets.json"):
        if (root / name).exists():
            violations += check_cmake(name, (root / name).read_text(encoding="utf-8"))
    return violations, num_includes


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    violations, num_includes = find_violations(pathlib.Path(sys.argv[1]).resolve())
    if num_includes == 0:
        print(f"{sys.argv[1]}: no #include line found: is this the project's root?", file=sys.stderr)
        return 2
    print("\n".join(violations + [f"{num_includes} includes read, {len(violations)} violations"]))
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
