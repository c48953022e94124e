# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes files for importer_fuzz, each named after what it is; the first byte chooses the reader.

    python3 tests/fuzz/make_importer_corpus.py tests/fuzz/corpus/importer
"""

import json
import pathlib
import struct
import sys
import zlib

(COCO, LABELME, CVAT_SHAPES, CVAT_MASKS, MAT, PCD, RECTANGLES, GRASPS, NPY, TABLE, MANIFEST, VIEWS,
 DEMONSTRATIONS, HOLDS, PICTURES, TREE, TEXT) = range(17)
NOTHING, EMPTY, FOLDER, LINK, FILE = range(5)
(CORNELL, JACQUARD, WASHINGTON, ETH80, UMD, FOLDERS, COIL, LABELME_TREE, BOP) = range(9)


def coco(segmentation, **other):
    return json.dumps({"images": [{"id": 1, "file_name": "a.png", "width": 6, "height": 4}],
                       "categories": [{"id": 1, "name": "good"}],
                       "annotations": [{"image_id": 1, "category_id": 1,
                                        "segmentation": segmentation, **other}]}).encode()


def labelme(shape_type, points, **other):
    return json.dumps({"shapes": [{"label": "good", "shape_type": shape_type, "points": points}],
                       "imagePath": "a.png", "imageData": None, **other}).encode()


def cvat(shape):
    return (f'<annotations><meta><task><labels><label><name>good</name></label></labels></task>'
            f'</meta><image name="a.png" width="6" height="4">{shape}</image></annotations>').encode()


def mat_element(kind, data):
    return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)


def mat_matrix(dimensions, data, array_class=9):
    return mat_element(14, mat_element(6, struct.pack("<II", array_class, 0)) +
                       mat_element(5, struct.pack(f"<{len(dimensions)}i", *dimensions)) +
                       mat_element(1, b"gt_label") + mat_element(2, data))


def mat(*elements):
    return b"MATLAB 5.0 MAT-file".ljust(124) + b"\0\1IM" + b"".join(elements)


def pcd(kind, data, points=2):
    return (f"VERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
            f"WIDTH {points}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {points}\n"
            f"DATA {kind}\n").encode() + data


def npy(shape, data, kind="<f4"):
    header = str({"descr": kind, "fortran_order": False, "shape": shape}).encode()
    header += b" " * (-(len(header) + 11) % 64) + b"\n"
    return b"\x93NUMPY\x01\0" + struct.pack("<H", len(header)) + header + data


def labelled():
    yield "coco_polygon", COCO, coco([[1, 0, 3, 0, 3, 4]])
    yield "coco_runs", COCO, coco({"size": [4, 6], "counts": [5, 6, 13]}, iscrowd=1)
    yield "coco_compressed_runs", COCO, coco({"size": [4, 6], "counts": "56="})
    yield "coco_huge_numbers", COCO, coco([[1e308, -1e308, 1e999, 0, 3, 4]])
    yield "coco_deep", COCO, b"[" * 2000
    yield "labelme_rectangle", LABELME, labelme("rectangle", [[1, 0], [2, 4]])
    yield "labelme_circle", LABELME, labelme("circle", [[1, 0], [2, 4]], imageWidth=6,
                                             imageHeight=4)
    yield "labelme_embedded", LABELME, labelme("polygon", [[0, 0], [1, 1], [2, 0]],
                                               imageData="iVBORw0KGgo=")
    yield "cvat_polygon", CVAT_SHAPES, cvat('<polygon label="good" points="1,0;3,0;3,2"/>')
    yield "cvat_box", CVAT_SHAPES, cvat('<box label="good" xtl="0" ytl="0" xbr="2" ybr="2" '
                                        'rotation="1e300"/>')
    yield "cvat_mask", CVAT_SHAPES, cvat('<mask label="good" rle="1, 4, 1" left="2" top="1" '
                                         'width="3" height="2"/>')
    yield "cvat_deep", CVAT_SHAPES, b"<a>" * 500
    yield "cvat_entities", CVAT_SHAPES, b'<!DOCTYPE a [<!ENTITY l "ha">]><annotations>&l;'
    yield "cvat_labelmap", CVAT_MASKS, b"good:1,2,3::\n# note\nbackground:0,0,0::\n"
    yield "rectangles", RECTANGLES, b"4 4\n10 4\n10 8\n4 8\nNaN NaN\nNaN 1\n2 3\n4 5\n"
    yield "rectangles_far", RECTANGLES, b"-1e6 -1e6\n1e6 -1e6\n1e6 1e6\n-1e6 1e6\n"
    yield "rectangles_inverted", RECTANGLES, b"0 0\n9 9\n9 0\n0 9\n"
    yield "grasps", GRASPS, b"20;15;0;18;4\n1;2;3;0;5\n"
    yield "grasps_far", GRASPS, b"1e6;1e6;1e6;1e6;1e6\n-5;-5;45;1e6;1\n"
    yield "text_runs", TEXT, b"56=0P`o"
    yield "text_base64", TEXT, b"Zm9v\nYg=="


def tree(importer, *states, content=b"x"):
    """Five states at most: what stands at each name of the importer's tree."""
    return bytes([importer, *states, *[NOTHING] * (5 - len(states))]) + content


def trees():
    rectangle = b"4 4\n10 4\n10 8\n4 8\n"
    bad_rectangle = b"NaN NaN\nNaN 1\n2 3\n4 5\n"
    yield "tree_cornell", TREE, tree(CORNELL, FILE, FILE, FILE, FILE, content=rectangle)
    yield "tree_cornell_no_labels", TREE, tree(CORNELL, FILE)
    yield "tree_cornell_bad_labels", TREE, tree(CORNELL, FILE, FILE, content=bad_rectangle)
    yield "tree_cornell_no_picture", TREE, tree(CORNELL, NOTHING, NOTHING, NOTHING, FILE)
    yield "tree_cornell_empty_labels", TREE, tree(CORNELL, FILE, EMPTY)
    yield "tree_jacquard_no_labels", TREE, tree(JACQUARD, FILE, FILE, FILE, NOTHING,
                                                content=b"20;15;0;18;4\n")
    yield "tree_jacquard_folder", TREE, tree(JACQUARD, FILE, FOLDER)
    yield "tree_washington", TREE, tree(WASHINGTON, FILE, FILE, FILE, NOTHING)
    yield "tree_washington_no_picture", TREE, tree(WASHINGTON, NOTHING, FILE, FILE, FILE, FILE)
    yield "tree_eth80_lone_map", TREE, tree(ETH80, FILE, FILE, NOTHING, FILE)
    yield "tree_eth80_link", TREE, tree(ETH80, FILE, LINK)
    yield "tree_umd_lone_labels", TREE, tree(UMD, NOTHING, FILE, FILE, FILE)
    yield "tree_folders_lone_mask", TREE, tree(FOLDERS, FILE, FILE, NOTHING, FILE)
    yield "tree_folders_folder", TREE, tree(FOLDERS, FOLDER, FILE)
    yield "tree_coil_empty", TREE, tree(COIL, FILE, EMPTY)
    yield "tree_labelme", TREE, tree(LABELME_TREE, FILE, FILE, NOTHING, FILE,
                                     content=labelme("rectangle", [[1, 0], [2, 4]]))
    yield "tree_labelme_no_picture", TREE, tree(LABELME_TREE, FILE, content=labelme(
        "rectangle", [[1, 0], [2, 4]]))
    yield "tree_bop_no_camera", TREE, tree(BOP, FILE, NOTHING, FILE, FILE, content=b"{}")
    bop = json.dumps({"0": [{"cam_R_m2c": [1, 0, 0, 0, 1, 0, 0, 0, 1], "cam_t_m2c": [0, 0, 1],
                             "obj_id": 1}]}).encode()
    yield "tree_bop_no_mask", TREE, tree(BOP, FILE, FILE, FILE, content=bop)


def numbers():
    labels = mat_matrix((2, 3), bytes(range(6)))
    yield "mat_plain", MAT, mat(labels)
    compressed = zlib.compress(labels)
    yield "mat_compressed", MAT, mat(struct.pack("<II", 15, len(compressed)) + compressed)
    bomb = zlib.compress(bytes(2**20), 9)
    yield "mat_bomb", MAT, mat(struct.pack("<II", 15, len(bomb)) + bomb)
    yield "mat_huge_dimensions", MAT, mat(mat_matrix((2**31 - 1, 2**31 - 1), b""))
    yield "mat_zero_by_huge", MAT, mat(mat_matrix((0, 2**31 - 1), b""))
    yield "mat_text", MAT, mat(mat_matrix((1, 2), b"ab", array_class=4))
    yield "pcd_ascii", PCD, pcd("ascii", b"1 2 3 0\nnan nan nan 0\n")
    yield "pcd_binary", PCD, pcd("binary", struct.pack("<8f", *range(8)))
    yield "pcd_indexed", PCD, pcd("ascii", b"1 2 3 5\nnan nan nan 0\n").replace(b"rgb", b"index")
    data = struct.pack("<8f", *range(8))  # as literal runs of LZF: 31 and the bytes
    packed = b"\x1f" + data
    yield "pcd_compressed", PCD, pcd("binary_compressed",
                                     struct.pack("<II", len(packed), len(data)) + packed)
    yield "pcd_huge", PCD, pcd("binary", b"", points=2**31 - 1)
    yield "npy_float", NPY, npy((2, 3), struct.pack("<6f", *range(6)))
    yield "npy_huge_shape", NPY, npy((2**62, 8), b"")
    yield "npy_bool", NPY, npy((1, 2), b"\0\1", "|b1")
    yield "npy_pictures", PICTURES, npy((2, 2, 3), bytes(range(12)), "|u1")
    yield "npy_pictures_huge", PICTURES, npy((2**62, 4, 1), b"", "|u1")
    yield "table", TABLE, b"x,y,label\r\n1,2.5e3,\"a,\"\"b\"\n-1,0,c\n"
    yield "table_quote_without_end", TABLE, b'x,label\n"1,2'
    yield "table_of_npy", TABLE, npy((2, 3), struct.pack("<6f", *range(6)))
    yield "manifest", MANIFEST, (b"image,mask,class,instance,split,licence\n"
                                 b"a.png,b.png,mug,m1,train,CC0\n../a.png,c.png,mug,m2,test,\n")
    yield "views", VIEWS, (b"image,object_mask,cloud,class,instance,angle_deg,split,licence,symmetry"
                           b"\na.png,b.png,c.pcd,mug,m1,22.5,train,CC0,round\n"
                           b"d.png,e.png,,mug,m2,,test,,\n")
    pose = b"0.1,-0.2,0.3,0,0.6,0,0.8"
    row = b"mug,m1,a.png,30,base,grasp_centre," + pose + b"\n"
    yield "demonstrations", DEMONSTRATIONS, (
        b"class,instance,view,angle_deg,frame,end_effector,x_m,y_m,z_m,qx,qy,qz,qw\n" + row + row)
    hands = b",".join(hand + b"_" + part for hand in (b"right", b"left")
                      for part in (b"x_m", b"y_m", b"z_m", b"qx", b"qy", b"qz", b"qw"))
    yield "holds", HOLDS, (b"class,instance,view,frame,end_effector," + hands +
                           b"\nmug,m1,a.png,base,grasp_centre," + pose + b"," + pose + b"\n")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    files = [*labelled(), *trees(), *numbers()]
    assert len({name for name, _, _ in files}) == len(files)
    for name, reader, data in files:
        (folder / name).write_bytes(bytes([reader]) + data)
    print(f"{len(files)} files written to {folder}")


if __name__ == "__main__":
    main()
