# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes small trees in the formats of turntable and pose data beside it: a bright mug on black,
half a metre away.

    python3 make_views.py
"""

import json
import pathlib
import struct
import zlib

WIDTH, HEIGHT = 32, 24
FOLDER = pathlib.Path(__file__).parent


def chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data +
            struct.pack(">I", zlib.crc32(kind + data)))


def write_png(path, value_at, bits=8):
    """A gray picture of 8 or 16 bits."""
    path = FOLDER / path
    path.parent.mkdir(parents=True, exist_ok=True)
    code = ">B" if bits == 8 else ">H"
    rows = b"".join(b"\0" + b"".join(struct.pack(code, value_at(u, v)) for u in range(WIDTH))
                    for v in range(HEIGHT))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, bits, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def is_mug(view):
    def at(u, v):
        return (8 <= u < 18 and 6 <= v < 20) or (18 <= u < 22 - view and 9 <= v < 17)
    return at


def picture(view):
    return lambda u, v: 180 + u + v if is_mug(view)(u, v) else 0


def mask(view):
    return lambda u, v: 255 if is_mug(view)(u, v) else 0


def depth(view):
    return lambda u, v: 500 if is_mug(view)(u, v) else 0


for view, angle in enumerate(("000", "022")):
    for mug in (1, 2):
        write_png(f"eth80/mug{mug}/mug{mug}-090-{angle}.png", picture(view + 2 * (mug - 1)))
        write_png(f"eth80/mug{mug}/maps/mug{mug}-090-{angle}-map.png",
                  mask(view + 2 * (mug - 1)))
    for mug in (1, 2):
        write_png(f"coil/obj{mug}__{view}.png", picture(view + 2 * (mug - 1)))
    stem = f"washington/mug/mug_1/mug_1_1_{view + 1}"
    write_png(stem + "_crop.png", picture(view))
    write_png(stem + "_maskcrop.png", mask(view))
    write_png(stem + "_depthcrop.png", depth(view), bits=16)
    (FOLDER / (stem + "_loc.txt")).write_text("305,229\n")
    (FOLDER / (stem + "_pose.txt")).write_text(f"{7.5 * view}\n")
    write_png(f"bop/000001/rgb/{view:06}.png", picture(view))
    write_png(f"bop/000001/mask_visib/{view:06}_000000.png", mask(view))
    write_png(f"bop/000001/depth/{view:06}.png", depth(view), bits=16)

camera = {"cam_K": [40, 0, 15.5, 0, 40, 11.5, 0, 0, 1], "depth_scale": 1.0}
upright = {"cam_R_m2c": [0, -1, 0, 0, 0, -1, 1, 0, 0], "cam_t_m2c": [0, 0, 500], "obj_id": 1}
turned = {"cam_R_m2c": [-1, 0, 0, 0, 0, -1, 0, -1, 0], "cam_t_m2c": [0, 0, 500], "obj_id": 1}
scene = FOLDER / "bop/000001"
(scene / "scene_camera.json").write_text(json.dumps({"0": camera, "1": camera}) + "\n")
(scene / "scene_gt.json").write_text(json.dumps({"0": [upright], "1": [turned]}) + "\n")
