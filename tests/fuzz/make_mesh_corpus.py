# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files for mesh_fuzz, each named after what it is; the first byte chooses the reader.

    python3 tests/fuzz/make_mesh_corpus.py tests/fuzz/corpus/mesh
"""

import pathlib
import struct
import sys

OBJ, STL, PLY, MTL = range(4)

TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def obj(faces):
    return ("mtllib a.mtl\no body\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in TETRAHEDRON) +
            "vt 0 0\nvt 1 0\nvt 0 1\ng side\nusemtl red\n" + faces).encode()


def stl_text(faces):
    lines = ["solid body"]
    for face in faces:
        lines += ["facet normal 0 0 1", " outer loop"]
        lines += ["  vertex {} {} {}".format(*TETRAHEDRON[i]) for i in face]
        lines += [" endloop", "endfacet"]
    return "\n".join([*lines, "endsolid body", ""]).encode()


def stl_binary(faces, count=None):
    data = bytes(80) + struct.pack("<I", len(faces) if count is None else count)
    for face in faces:
        numbers = [0, 0, 1] + [x for i in face for x in TETRAHEDRON[i]]
        data += struct.pack("<12fH", *numbers, 0)
    return data


def ply(kind, body, vertices=4, faces=4, extra="", index="list uchar int vertex_indices"):
    return (f"ply\nformat {kind} 1.0\ncomment made\nelement vertex {vertices}\nproperty float x\n"
            f"property float y\nproperty float z\n{extra}element face {faces}\nproperty {index}\n"
            "end_header\n").encode() + body


def ply_binary(order):
    body = b"".join(struct.pack(order + "3f", *vertex) for vertex in TETRAHEDRON)
    return body + b"".join(struct.pack(order + "B3i", 3, *face) for face in FACES)


def ply_text(last="3 1 2 3"):
    rows = ["{} {} {}".format(*vertex) for vertex in TETRAHEDRON]
    rows += ["3 {} {} {}".format(*face) for face in FACES[:3]]
    return "\n".join([*rows, last, ""]).encode()


def files():
    yield "obj_plain", OBJ, obj("f 1 3 2\nf 1 2 4\n")
    yield "obj_texture", OBJ, obj("f 1/1 3/2 2/3\nf 1/1/1 2/2/1 4/3/1\nf 1//1 2//1 3//1\n")
    yield "obj_negative", OBJ, obj("f -4 -3 -2 -1\n")
    yield "obj_far_index", OBJ, obj("f 1 2 4294967297\n")
    yield "obj_two_corners", OBJ, obj("f 1 2\n")
    yield "obj_huge_number", OBJ, b"v 1e39 0 0\n"
    yield "obj_joined_lines", OBJ, obj("f 1 2 \\\n3\n")
    yield "stl_text", STL, stl_text(FACES)
    yield "stl_text_without_end", STL, stl_text(FACES)[:-14]
    yield "stl_binary", STL, stl_binary(FACES)
    yield "stl_binary_solid", STL, b"solid" + stl_binary(FACES)[5:]
    yield "stl_huge_count", STL, stl_binary(FACES, 2**32 - 1)
    yield "stl_nan", STL, stl_binary(FACES)[:96] + b"\xff" * 20 + stl_binary(FACES)[116:]
    yield "ply_text", PLY, ply("ascii", ply_text())
    yield "ply_text_far_index", PLY, ply("ascii", ply_text("3 1 2 4"))
    yield "ply_text_negative_index", PLY, ply("ascii", ply_text("3 1 2 -1"))
    yield "ply_little", PLY, ply("binary_little_endian", ply_binary("<"))
    yield "ply_big", PLY, ply("binary_big_endian", ply_binary(">"))
    yield "ply_huge_vertices", PLY, ply("binary_little_endian", b"", vertices=2**63)
    yield "ply_huge_list", PLY, ply("binary_little_endian", struct.pack("<3fI", 0, 0, 0, 2**32 - 1),
                                    vertices=1, faces=1, index="list uint int vertex_indices")
    yield "ply_skipped_list", PLY, ply("ascii", b"0 0 0 2 7 8\n1 0 0 0\n0 1 0 1 9\n3 0 1 2\n",
                                       vertices=3, faces=1, extra="property list uchar int more\n")
    yield "ply_empty_elements", PLY, ply("ascii", b"", vertices=0, faces=0)
    yield "mtl_colours", MTL, b"newmtl m\nKd 1 0.5 0\nnewmtl n\nKd 2 -1 nan\n"
    yield "mtl_colour_of_nothing", MTL, b"Kd 1 1 1\n"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    made = list(files())
    assert len({name for name, _, _ in made}) == len(made)
    for name, reader, data in made:
        (folder / name).write_bytes(bytes([reader]) + data)
    print(f"{len(made)} files written to {folder}")


if __name__ == "__main__":
    main()
