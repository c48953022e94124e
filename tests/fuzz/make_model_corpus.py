# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes hostile model files, each named after what is wrong with it.

    python3 tests/fuzz/make_model_corpus.py tests/fuzz/corpus/model
"""

import json
import pathlib
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from crc32c import crc32c  # noqa: E402

MODELS = pathlib.Path(__file__).resolve().parents[1] / "data/models"
GOLDEN = MODELS / "v1_logistic.safetensors"
HEADER = ('{"__metadata__":{"hc.format":"1.0","hc.kind":"none"},'
          '"a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]},'
          '"b":{"dtype":"U8","shape":[1,3],"data_offsets":[8,11]},'
          '"zz.crc":{"dtype":"U8","shape":[8],"data_offsets":[11,19]}}')
DATA = struct.pack("<ff", 1.0, 2.0) + bytes([7, 8, 9])


def sealed(data):
    return data + b"C32C" + struct.pack("<I", crc32c(data))


def file_of(header, data=DATA, length=None):
    text = header.encode("utf-8", "surrogateescape")
    text += b" " * (-(len(text) + 8) % 64)
    return sealed(struct.pack("<Q", len(text) if length is None else length) + text + data)


def changed(old, new, data=DATA):
    assert old in HEADER, old
    return file_of(HEADER.replace(old, new, 1), data)


def model_changed(name, old, new):
    data = (MODELS / f"{name}.safetensors").read_bytes()
    assert data.count(old) >= 1 and len(old) == len(new), old
    return sealed(data.replace(old, new, 1)[:-8])


def golden_changed(old, new):
    return model_changed("v1_logistic", old, new)


def changed_number(name, tensor, entry, value):
    """A golden model with one number changed."""
    data = bytearray((MODELS / f"{name}.safetensors").read_bytes())
    length = struct.unpack_from("<Q", data)[0]
    layout = json.loads(data[8:8 + length])[tensor]
    kind = {"F64": "<d", "F32": "<f", "I32": "<i"}[layout["dtype"]]
    struct.pack_into(kind, data, 8 + length + layout["data_offsets"][0] + entry * struct.calcsize(kind), value)
    return sealed(bytes(data[:-8]))


def svm_with(tensor, entry, value):
    return changed_number("v1_svm", tensor, entry, value)


def many_tensors(count):
    entries = "".join(f',"t{i:03}":{{"dtype":"U8","shape":[1],"data_offsets":[{i},{i + 1}]}}'
                      for i in range(count))
    crc = f',"zz.crc":{{"dtype":"U8","shape":[8],"data_offsets":[{count},{count + 8}]}}}}'
    return file_of('{"__metadata__":{"hc.format":"1.0"}' + entries + crc, bytes(count))


def container_files():
    """Files that break § 2 of docs/model_format.md."""
    small = file_of(HEADER)
    yield "valid_small", small
    yield "empty", b""
    yield "one_byte", b"{"
    yield "eight_bytes", small[:8]
    yield "truncated_in_header", small[:100]
    yield "truncated_in_tensors", small[:-12]
    yield "truncated_by_one_byte", small[:-1]
    yield "bytes_after_the_end", sealed(small)
    yield "flipped_bit", small[:40] + bytes([small[40] ^ 4]) + small[41:]
    yield "checksum_of_zeros", small[:-4] + bytes(4)
    yield "header_length_zero", file_of(HEADER, length=0)
    yield "header_length_all_ones", file_of(HEADER, length=2**64 - 1)
    yield "header_length_above_one_mebibyte", file_of(HEADER, length=2**20 + 56)
    yield "header_length_misaligned", file_of(HEADER, length=61)
    yield "header_padded_with_zeros", sealed(small[:-8].replace(b"}} ", b"}}\0"))
    yield "header_padded_twice", file_of(HEADER + " " * 64)
    yield "header_is_a_list", file_of("[" * 500)
    yield "nested_deeply", file_of('{"__metadata__":' + "{" * 5000)
    yield "metadata_missing", file_of("{" + HEADER[HEADER.index('"a"'):])
    yield "metadata_value_is_a_number", changed('"none"', "1")
    yield "duplicate_metadata_key", changed("hc.kind", "hc.format")
    yield "duplicate_tensor", changed('"b":', '"a":')
    yield "unsorted_tensors", changed('"a":', '"c":')
    yield "trailing_comma_in_metadata", changed('"none"', '"none",')
    yield "trailing_comma_in_shape", changed("[2]", "[2,]")
    yield "escape_unicode", changed("none", "\\u0000")
    yield "escape_at_the_end", changed('none"}', "none\\")
    yield "string_without_end", file_of(HEADER[:30])
    yield "not_utf8", changed("none", "\udcff\udcfe")
    yield "control_character", changed("none", "a\x1b[2J")
    yield "negative_size", changed("[2]", "[-2]")
    yield "fractional_size", changed("[2]", "[2.0]")
    yield "exponent_size", changed("[2]", "[2e0]")
    yield "leading_zero_size", changed("[2]", "[02]")
    yield "zero_size", changed("[2]", "[0]")
    yield "huge_size", changed("[2]", "[9007199254740992]")
    yield "sizes_that_overflow", changed("[2]", "[4294967296,4294967296,4294967296,4294967296]")
    yield "five_dimensions", changed("[2]", "[1,1,1,1,2]")
    yield "offsets_backwards", changed("[0,8]", "[8,0]")
    yield "offsets_that_overlap", changed("[8,11]", "[5,8]")
    yield "offsets_with_a_gap", changed("[8,11]", "[9,12]")
    yield "offsets_beyond_the_file", changed("[11,19]", "[9007199254740000,9007199254740008]")
    yield "unknown_dtype", changed("F32", "F16")
    yield "name_in_capitals", changed('"a"', '"A"')
    yield "name_after_the_checksum", changed('"zz.crc"', '"zzz"')
    yield "checksum_tensor_missing", changed('"zz.crc"', '"c"')
    yield "nan", file_of(HEADER, struct.pack("<ff", 1.0, float("nan")) + bytes(3))
    yield "infinity", file_of(HEADER, struct.pack("<ff", float("-inf"), 1.0) + bytes(3))
    yield "sixty_four_tensors", many_tensors(63)
    yield "sixty_five_tensors", many_tensors(64)


def content_files():
    """Files that break § 3 to § 6."""
    golden = GOLDEN.read_bytes()
    yield "format_of_the_future", changed("1.0", "2.0")
    yield "format_of_the_past", changed("1.0", "0.9")
    yield "format_without_minor", changed("1.0", "1")
    yield "format_missing", changed('"hc.format":"1.0",', "")
    yield "requires_magic", changed('"hc.kind":"none"', '"hc.requires":"magic"')
    yield "kind_unknown", golden_changed(b'"hc.kind":"logistic"', b'"hc.kind":"logistik"')
    yield "kind_version_two", golden_changed(b'"hc.kind_version":"1"', b'"hc.kind_version":"2"')
    yield "tensor_unknown", golden_changed(b'"weights"', b'"weighty"')
    yield "column_names_missing_one", golden_changed(b"length_m\n", b"length_m,")
    yield "tensor_extension", changed('"b":', '"x.b":')
    yield "weights_of_another_model", sealed(
        golden.replace(struct.pack("<d", -3.0), struct.pack("<d", 3.0))[:-8])
    yield "weights_that_overflow", sealed(
        golden.replace(struct.pack("<d", -3.0), struct.pack("<d", -1.7e308))[:-8])
    yield "object_class_without_a_descriptor", model_changed(
        "v1_object_class", b'"cloud_descriptor"', b'"cloud_descripton"')
    yield "object_class_mask_turned", model_changed(
        "v1_object_class", b'"selftest.mask":{"dtype":"U8","shape":[8,10]',
        b'"selftest.mask":{"dtype":"U8","shape":[10,8]')


def histogram_files():
    """Descriptors of § 10 whose machine has another number of features, or another grid."""
    for name in ("vfh", "esf"):
        model = f"v1_object_class_{name}"
        other = {"vfh": 4, "esf": 3}[name]
        yield f"object_class_{name}_as_the_other", changed_number(model, "cloud_descriptor", 0, other)
        yield f"object_class_{name}_grid_of_none", changed_number(model, "cloud_grid_size", 0, 0)
        yield f"object_class_{name}_grid_huge", changed_number(model, "cloud_grid_size", 0, 129)
        yield f"object_class_{name}_grid_of_one", changed_number(model, "cloud_grid_size", 0, 1)
        yield f"object_class_{name}_threshold_nan", changed_number(
            model, "rejection_threshold", 0, float("nan"))


def svm_files():
    """Files that break § 9."""
    yield "svm_kernel_unknown", svm_with("kernel", 0, 3)
    yield "svm_degree_huge", svm_with("kernel_degree", 0, 2**31 - 1)
    yield "svm_gamma_negative", svm_with("kernel_gamma", 0, -1.0)
    yield "svm_scheme_unknown", svm_with("scheme", 0, -1)
    yield "svm_classes_huge", svm_with("num_classes", 0, 2**31 - 1)
    yield "svm_class_of_support_beyond", svm_with("support_classes", 1, 3)
    yield "svm_support_negative", svm_with("machine_supports", 0, -1)
    yield "svm_support_beyond", svm_with("machine_supports", 5, 3)
    yield "svm_supports_fall", svm_with("machine_supports", 0, 2)
    yield "svm_machine_begins_late", svm_with("machine_begins", 0, 1)
    yield "svm_machine_ends_before_it_begins", svm_with("machine_begins", 2, 1)
    yield "svm_machine_ends_beyond", svm_with("machine_begins", 3, 2**31 - 1)
    yield "svm_coefficient_of_another_model", svm_with("dual_coefficients", 0, 1e300)
    yield "svm_vector_overflows", svm_with("support_vectors", 0, 3e38)


def library_files():
    """Grasp libraries that break § 11."""
    golden = (MODELS / "v1_grasp_library.safetensors").read_bytes()

    def with_begins(old, new):
        assert golden.count(struct.pack(f"<{len(old)}i", *old)) >= 1, old
        return sealed(golden.replace(struct.pack(f"<{len(old)}i", *old),
                                     struct.pack(f"<{len(new)}i", *new), 1)[:-8])

    yield "library_without_poses_at_an_angle", with_begins((0, 20, 40), (0, 40, 40))
    yield "library_begins_that_fall", with_begins((0, 20, 40), (0, 60, 40))
    yield "library_begins_beyond_the_end", with_begins((140, 160), (140, 2**31 - 1))
    yield "library_begins_below_zero", with_begins((0, 20, 40), (-20, 20, 40))
    yield "library_rejection_below_zero", sealed(
        golden.replace(struct.pack("<d", 0.05), struct.pack("<d", -0.05))[:-8])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    files = [*container_files(), *content_files(), *histogram_files(), *svm_files(), *library_files()]
    assert len({name for name, _ in files}) == len(files)
    for name, data in files:
        (folder / f"{name}.safetensors").write_bytes(data)
    print(f"{len(files)} files written to {folder}")


if __name__ == "__main__":
    main()
