#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the commands and compiles the programs of the documentation as they are printed.

    scripts/run_doc_commands.py --build BUILD --handcraft EXECUTABLE [PAGE.md...]

Without pages: README.md and everything below docs/. What is run is written down in
docs/contributing.md. Each page gets a fresh folder that looks like the project's root (a copy of
datasets/samples and models), with the built `handcraft` on the PATH; its blocks run there in order,
so that one can use what an earlier one made. C and C++ programs are linked against what
`cmake --install BUILD` installs. Exit code 1 when a block fails, 2 when there was none.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
import markdown  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
COPIED_FOLDERS = ("datasets/samples", "models")
TIMEOUT_S = 300
# A `console` block is shown, not run: what ./check and ./demo do themselves, or a command with a
# PLACEHOLDER for the reader's own data.
SHOWN_COMMANDS = ("./demo", "./check", "cmake ", "ctest ", "git ", "sudo ", "scripts/", "clang-",
                  "cd ")
PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b")
EIGEN = "/usr/include/eigen3"  # public headers include it
OWN_INCLUDE = re.compile(r'^#include "(lib|trainers|datasets|experiments)/', flags=re.M)


class BlockFailed(Exception):
    """Says what went wrong, for the person who wrote the page."""


class Runner:
    """Runs the blocks of one page in one folder."""

    def __init__(self, folder: pathlib.Path, handcraft: pathlib.Path,
                 installed: "InstalledRuntime"):
        self.folder = folder
        self.installed = installed
        self.environment = dict(os.environ, HOME=str(folder), LC_ALL="C.UTF-8",
                                PATH=f"{handcraft.parent}:{os.environ['PATH']}")
        for name in COPIED_FOLDERS:
            if (ROOT / name).is_dir():
                shutil.copytree(ROOT / name, folder / name)

    def run(self, block: markdown.Block) -> None:
        actions = {"sh": self.run_shell, "python": self.run_python, "c": self.compile_program,
                   "cpp": self.compile_program, "console": check_shown, "json": check_json}
        if block.language in actions:
            actions[block.language](block)

    def run_shell(self, block):
        self.execute(["bash", "-eu", "-o", "pipefail", "-c", block.text])

    def run_python(self, block):
        self.execute([sys.executable, "-c", block.text])

    def compile_program(self, block):
        """Compiles and links a complete program against the installed runtime; code that uses the
        project's own headers is compiled alone."""
        source = self.folder / f"line_{block.line}.{block.language}"
        source.write_text(block.text, encoding="utf-8")
        command = ["cc", "-std=c11"] if block.language == "c" else ["c++", "-std=c++20"]
        command += ["-Wall", "-Wextra", "-Werror", str(source)]
        if OWN_INCLUDE.search(block.text):
            command += [f"-I{ROOT}", "-isystem", EIGEN, "-fsyntax-only"]
        elif "int main(" in block.text:
            prefix = self.installed.prefix()
            command += [f"-I{prefix}/include", f"-L{prefix}/lib", "-lhandcraft_runtime",
                        "-o", str(source.with_suffix(""))]
        else:
            raise BlockFailed("not a complete program: give it a main, or mark the block `text`")
        self.execute(command)

    def execute(self, command):
        try:
            process = subprocess.run(command, cwd=self.folder, env=self.environment, text=True,
                                     stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, timeout=TIMEOUT_S)
        except subprocess.TimeoutExpired:
            raise BlockFailed(f"took more than {TIMEOUT_S} s")
        if process.returncode != 0:
            raise BlockFailed(f"exit code {process.returncode}\n{process.stdout}")


def check_shown(block):
    continued = False
    for line in block.text.splitlines():
        command = line.removeprefix("$ ")
        is_shown = command.startswith(("#",) + SHOWN_COMMANDS) or PLACEHOLDER.search(command)
        if command.strip() and not is_shown and not continued:
            raise BlockFailed(f"'{command}' can be run: mark the block `sh`")
        continued = line.endswith("\\")


def check_json(block):
    try:
        json.loads(block.text)
    except ValueError as error:
        raise BlockFailed(f"not JSON: {error}")


class InstalledRuntime:
    """Installs the build into a temporary prefix when the first program asks for it."""

    def __init__(self, build: pathlib.Path):
        self.build = build
        self.folder = None

    def prefix(self) -> str:
        if self.folder is None:
            self.folder = tempfile.TemporaryDirectory()
            subprocess.run(["cmake", "--install", self.build, "--prefix", self.folder.name],
                           check=True, stdout=subprocess.DEVNULL)
        return self.folder.name


def run_page(page: pathlib.Path, handcraft: pathlib.Path, installed: InstalledRuntime):
    """(number of blocks, number of failures)"""
    blocks = markdown.fenced_blocks(page)
    num_failures = 0
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(pathlib.Path(folder), handcraft, installed)
        for block in blocks:
            start = time.monotonic()
            try:
                runner.run(block)
                outcome = "ok"
            except BlockFailed as failure:
                outcome = f"FAILED: {failure}\n--- the block:\n{block.text}---"
                num_failures += 1
            elapsed_s = time.monotonic() - start
            print(f"{page}:{block.line}: {block.language} {outcome} ({elapsed_s:.1f} s)", flush=True)
    return len(blocks), num_failures


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--handcraft", type=pathlib.Path, required=True)
    parser.add_argument("pages", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    pages = arguments.pages or [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    installed = InstalledRuntime(arguments.build.resolve())
    counts = [run_page(page, arguments.handcraft.resolve(), installed) for page in pages]
    num_blocks, num_failures = (sum(column) for column in zip(*counts))
    print(f"{len(pages)} pages, {num_blocks} blocks, {num_failures} failures")
    return 2 if num_blocks == 0 else min(num_failures, 1)


if __name__ == "__main__":
    sys.exit(main())
