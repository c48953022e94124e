# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Uses the runtime as a robot's project does: installs it, moves the prefix, finds it by CMake and
by pkg-config, builds a C and a C++ program, and runs them on a model.

    consumer_test.py BUILD_FOLDER MODEL
"""

import pathlib
import re
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parent / "project"


def run(*command, **options):
    process = subprocess.run([str(part) for part in command], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, **options)
    if process.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\nexit code {process.returncode}\n{process.stdout}")
    return process.stdout


def install(build, folder):
    """The runtime in a prefix that has been moved since."""
    run("cmake", "--install", build, "--prefix", folder / "first", "--component", "runtime")
    moved = (folder / "first").rename(folder / "moved")
    for path in moved.rglob("*"):
        if path.suffix in (".cmake", ".pc") and str(folder) in path.read_text():
            sys.exit(f"{path.name} names the folder it was installed to")
    return moved


def build_by_cmake(prefix, folder):
    run("cmake", "-S", PROJECT, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}",
        "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", folder)
    return [folder / name for name in ("score_c", "score_c_static", "score_cc")]


def build_by_pkg_config(prefix, folder):
    pc = next(prefix.rglob("handcraft_runtime.pc"))
    flags = run("pkg-config", "--cflags", "--libs", "handcraft_runtime",
                env={"PKG_CONFIG_PATH": str(pc.parent), "PATH": "/usr/bin:/bin"}).split()
    program = folder / "score_pc"
    run("cc", "-std=c99", PROJECT / "score.c", *flags, f"-Wl,-rpath,{pc.parent.parent}",
        "-o", program)
    return [program]


def main():
    build, model = map(pathlib.Path, sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = install(build, folder)
        programs = build_by_cmake(prefix, folder / "build") + build_by_pkg_config(prefix, folder)
        outputs = {run(program, model) for program in programs}
    if len(outputs) != 1 or not re.fullmatch(r"(\d+ \d+ [01]\.\d{6}\n){5}", outputs.pop()):
        sys.exit(f"the programs do not agree on five points: {outputs}")


if __name__ == "__main__":
    main()
