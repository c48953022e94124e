# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files for robot_fuzz, each named after what it is.

    python3 tests/fuzz/make_robot_corpus.py tests/fuzz/corpus/robot
"""

import pathlib
import sys

LIMIT = '<limit lower="-1" upper="2"/>'


def robot(joints, links="abcd"):
    declared = "".join(f'<link name="{link}"/>\n' for link in links)
    return f'<?xml version="1.0"?>\n<robot name="r">\n{declared}{joints}</robot>\n'


def joint(name, between, kind="revolute", rest=LIMIT):
    return (f'<joint name="{name}" type="{kind}"><parent link="{between[0]}"/><child link="{between[1]}"/>'
            f"{rest}</joint>\n")


def spherical_arm():
    origins = ["0 0 0", "0 0 0", "0 0 0", "0.045 0 0.55", "-0.045 0 0", "0 0 0.3", "0 0 0"]
    joints = ""
    for i, origin in enumerate(origins):
        turn = 0 if i == 0 else 1.5707963267948966 * (-1) ** i
        rest = f'<origin xyz="{origin}" rpy="{turn} 0 0"/><axis xyz="0 0 1"/>{LIMIT}'
        joints += joint(f"j{i}", "abcdefgh"[i:i + 2], rest=rest)
    return robot(joints, "abcdefgh")


def files():
    yield "chain", robot(joint("j", "ab") + joint("f", "bc", "fixed", "") + joint("k", "cd", "prismatic"))
    yield "spherical_arm", spherical_arm()
    yield "loop", robot(joint("j", "ab") + joint("k", "ba"))
    yield "two_parents", robot(joint("j", "ac") + joint("k", "bc"))
    yield "mimic", robot(joint("j", "ad", rest=LIMIT + '<mimic joint="x"/>'))
    yield "limits_exchanged", robot(joint("j", "ad", rest='<limit lower="2" upper="-1"/>'))
    yield "huge_numbers", robot(joint("j", "ad", rest='<origin xyz="1e308 1e308 1e308" rpy="1e300 0 0"/>' + LIMIT))
    yield "zero_axis", robot(joint("j", "ad", rest='<axis xyz="0 0 0"/>' + LIMIT))
    yield "truncated", robot(joint("j", "ad"))[:120]
    yield "no_urdf", "<sdf/>"


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files():
        (folder / name).write_text(text)


if __name__ == "__main__":
    main()
