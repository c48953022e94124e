#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs clang-tidy on the sources that a change touches.

    scripts/run_clang_tidy.py [--build build/dev] [--jobs 2] [--all | --base COMMIT]

Looks at every source that differs from COMMIT, and at every header that does through one source that
includes it. Without --base: where HEAD left origin/main, else twenty commits back, else everything.
Who changes .clang-tidy runs it with --all, which also asks for the checks that are slow. A source that passed before with the
same text, headers, compile command and checks is not looked at again, in any clone: what passed is
remembered beside ccache's files, in ~/.cache/handcraft. Exit code 1 when there is a finding.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys
import time
from typing import Dict, List, Optional, Set

ROOT = pathlib.Path(__file__).resolve().parents[1]
CONFIGURATION = ".clang-tidy"
# Half the time of a source that includes CLI11, and seldom a finding: asked for by --all alone.
SLOW_CHECKS = "performance-unnecessary-value-param"
FORGOTTEN_AFTER_S = 30 * 24 * 3600
OWN_INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', flags=re.M)


def git(*arguments: str) -> Optional[List[str]]:
    """Lines of git's answer, or None when git cannot give one (no repository, no such commit)."""
    command = ["git", "-c", f"safe.directory={ROOT}", "-C", str(ROOT), *arguments]
    try:
        process = subprocess.run(command, capture_output=True, text=True)
    except FileNotFoundError:
        return None
    return process.stdout.splitlines() if process.returncode == 0 else None


def default_base() -> Optional[str]:
    head = git("rev-parse", "HEAD")
    branched = git("merge-base", "HEAD", "origin/main")
    if head and branched and branched != head:
        return branched[0]
    twenty_back = git("rev-parse", "--verify", "HEAD~20")
    return twenty_back[0] if twenty_back else None


def changed_files(base: Optional[str]) -> Optional[Set[str]]:
    """Paths that differ from the base or are new; None: take everything."""
    differing = git("diff", "--name-only", base) if base else None
    untracked = git("ls-files", "--others", "--exclude-standard")
    if differing is None or untracked is None:
        return None
    return set(differing) | set(untracked)


def compile_commands(build: pathlib.Path) -> Dict[str, str]:
    """Source below the root -> the command that compiles it."""
    commands = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        source = pathlib.Path(entry["directory"], entry["file"]).resolve()
        if ROOT in source.parents and build not in source.parents:
            commands.setdefault(source.relative_to(ROOT).as_posix(), entry["command"])
    return commands


def with_own_headers(source: str) -> List[str]:
    """The source and every header of the project that it includes, directly or not."""
    seen, waiting = {source}, [source]
    while waiting:
        text = (ROOT / waiting.pop()).read_text(encoding="utf-8", errors="replace")
        for header in OWN_INCLUDE.findall(text):
            if header not in seen and (ROOT / header).is_file():
                seen.add(header)
                waiting.append(header)
    return sorted(seen)


def touched_by(changed: Set[str], files_of: Dict[str, List[str]]) -> Set[str]:
    """The changed sources; for each changed header that none of them includes one that does: the
    source of its name, else the one that includes the fewest."""
    chosen = changed & set(files_of)
    for header in sorted(name for name in changed if name.endswith(".h")):
        users = [source for source, files in files_of.items() if header in files]
        if users and not chosen & set(users):
            chosen.add(min(users, key=lambda source: (source[:-3] != header[:-2],
                                                      len(files_of[source]), source)))
    return chosen


def key_of(files: List[str], command: str, tidy: str) -> str:
    """Changes whenever the answer of clang-tidy could; the same in every clone.

    tidy: the version of clang-tidy and the checks asked for on its command line.
    """
    digest = hashlib.sha256(f"{tidy}\n{command.replace(str(ROOT), '.')}\n".encode())
    for name in [CONFIGURATION, *files]:
        digest.update(name.encode() + b"\0" + (ROOT / name).read_bytes())
    return digest.hexdigest()


def open_cache(build: pathlib.Path) -> pathlib.Path:
    """The folder of what passed: an empty file a key. Drops what no run asked for in a month."""
    user_cache = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or "~/.cache").expanduser()
    for cache in (user_cache / "handcraft/clang_tidy", build / "clang_tidy"):
        try:
            cache.mkdir(parents=True, exist_ok=True)
        except OSError:
            continue
        if os.access(cache, os.W_OK):
            break
    for stamp in cache.iterdir():
        if time.time() - stamp.stat().st_mtime > FORGOTTEN_AFTER_S:
            stamp.unlink(missing_ok=True)
    return cache


def look_at(source: str, build: pathlib.Path, checks: str) -> str:
    """clang-tidy's findings, or nothing."""
    process = subprocess.run(
        ["clang-tidy", "-p", str(build), "--quiet", f"--checks={checks}", str(ROOT / source)],
        capture_output=True, text=True, cwd=ROOT)
    return process.stdout + process.stderr if process.returncode != 0 else ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/dev")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--all", action="store_true", help="every source")
    parser.add_argument("--base", default=None, help="commit to compare with")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    changed = None if arguments.all else changed_files(arguments.base or default_base())
    checks = SLOW_CHECKS if arguments.all else ""
    version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True, text=True)

    cache = open_cache(build)
    commands = compile_commands(build)
    files_of = {source: with_own_headers(source) for source in commands}
    wanted = set(commands) if changed is None else touched_by(changed, files_of)
    stamps, waiting = {}, []
    for source, command in sorted(commands.items()):
        stamps[source] = cache / key_of(files_of[source], command, version.stdout + checks)
        if stamps[source].exists():
            stamps[source].touch()
        elif source in wanted:
            waiting.append(source)
    print(f"clang-tidy: {len(waiting)} of {len(stamps)} sources to look at", flush=True)

    num_findings = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for source, findings in zip(waiting, pool.map(lambda s: look_at(s, build, checks), waiting)):
            if findings:
                num_findings += 1
                print(findings, flush=True)
            else:
                stamps[source].touch()
    print(f"clang-tidy: {num_findings} of {len(waiting)} sources with findings")
    return 1 if num_findings else 0


if __name__ == "__main__":
    sys.exit(main())
