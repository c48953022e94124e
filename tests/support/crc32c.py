# SPDX-FileCopyrightText: 2026 the Handcraft authors
# SPDX-License-Identifier: BSD-3-Clause
"""The checksum of model files, bit by bit and apart from the C++ code."""


def crc32c(data):
    """CRC-32C (Castagnoli) of bytes: reflected, polynomial 0x1EDC6F41."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82F63B78 & -(crc & 1))
    return crc ^ 0xFFFFFFFF
