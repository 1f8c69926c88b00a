# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes small files that claim or unpack to far more than they may: expansion_bombs.py FOLDER."""

import os
import struct
import sys
import zlib

import h5py
import numpy as np
from h5py import h5d, h5p, h5s, h5t, h5z

folder = sys.argv[1]
MIB = 1 << 20


def new(name, latest=False, **more):
    return h5py.File(os.path.join(folder, name), "w", libver="latest" if latest else None, **more)


def chunked(file, name, dtype, samples, chunk, filters, blocks):
    """A dataset whose chunks all hold `blocks`, as they lie in the file."""
    plan = h5p.create(h5p.DATASET_CREATE)
    plan.set_chunk((chunk,))
    for add in filters:
        add(plan)
    space = h5s.create_simple((samples,), (h5s.UNLIMITED,))
    dataset = h5d.create(file.id, name.encode(), h5t.py_create(np.dtype(dtype)), space, plan)
    for begin in range(0, samples, chunk):
        dataset.write_direct_chunk((begin,), blocks)
    return dataset


def deflate(plan):
    plan.set_deflate(9)


def deflated(head, mebibytes):
    """A zlib stream of bytes and so many MiB of zeros behind them, which are packed once."""
    def packed(data):
        packer = zlib.compressobj(9, zlib.DEFLATED, -15)
        return packer.compress(data) + packer.flush(zlib.Z_FULL_FLUSH)

    zero = bytes(MIB)
    check = zlib.adler32(head)
    for _ in range(mebibytes):
        check = zlib.adler32(zero, check)
    last_block = b"\x03\x00"
    return b"\x78\xda" + packed(head) + packed(zero) * mebibytes + last_block + struct.pack(">I", check)


def zeros(size):
    return deflated(b"", size // MIB)


def gzip_bombs():
    with new("gzip_4GiB.h5") as f:
        chunked(f, "a", "i1", 4096 * MIB, 4 * MIB, [deflate], zeros(4 * MIB))
    with new("gzip_datasets.h5") as f:
        block = zeros(4 * MIB)
        for i in range(600):
            chunked(f, "a%03d" % i, "f4", MIB, MIB, [deflate], block)
    with new("gzip_chunk_60MiB.h5") as f:
        chunked(f, "a", "i2", 30 * MIB, 30 * MIB, [deflate], zeros(60 * MIB))
    with new("gzip_chunk_512MiB.h5") as f:
        chunked(f, "a", "f8", 64 * MIB, 64 * MIB, [deflate], zeros(512 * MIB))
    with new("gzip_short_in_large_chunks.h5") as f:
        block = zeros(60 * MIB)
        for i in range(40):
            chunked(f, "a%02d" % i, "i2", 128, 30 * MIB, [deflate], block)
    with new("gzip_sparse.h5") as f:
        f.create_dataset("a", (1 << 46,), "i2", chunks=(1 << 20,), compression="gzip")
    with new("gzip_capture.h5") as f:
        f.attrs["format"] = "dyncal-capture"
        f.attrs["format_version"] = np.array([1, 0], "i4")
        channels = f.create_group("shots/001/channels")
        chunked(channels, "DUT", "i2", 1024 * MIB, 2 * MIB, [deflate], zeros(4 * MIB))


def lying_bombs():
    """The chunk says 1 MiB, its stream unpacks to 512 MiB."""
    stream = zeros(512 * MIB)
    with new("gzip_lie.h5") as f:
        chunked(f, "a", "i1", MIB, MIB, [deflate], stream)
    with new("gzip_nested_lie.h5") as f:
        chunked(f, "a", "i1", MIB, MIB, [deflate, deflate], zlib.compress(stream, 9))


def nested_bombs():
    block = zlib.compress(zeros(16 * MIB), 9)
    with new("gzip_nested.h5") as f:
        chunked(f, "a", "i1", 4096 * MIB, 16 * MIB, [deflate, deflate], block)
    with new("gzip_shuffled.h5") as f:
        chunked(f, "a", "f8", 256 * MIB, 2 * MIB, [lambda p: p.set_shuffle(), deflate],
                zeros(16 * MIB))


def szip_bombs():
    def szip(plan):
        plan.set_szip(h5z.SZIP_NN_OPTION_MASK, 32)

    with new("probe.h5") as f:
        plan = h5p.create(h5p.DATASET_CREATE)
        plan.set_chunk((4 * MIB,))
        szip(plan)
        d = h5d.create(f.id, b"a", h5t.STD_U8LE, h5s.create_simple((4 * MIB,)), plan)
        d.write(h5s.ALL, h5s.ALL, np.zeros(4 * MIB, "u1"))
        block = d.read_direct_chunk((0,))[1]
    os.remove(os.path.join(folder, "probe.h5"))
    with new("szip_2GiB.h5") as f:
        chunked(f, "a", "u1", 2048 * MIB, 4 * MIB, [szip], block)
    with new("szip_lie.h5") as f:
        chunked(f, "a", "u1", 4 * MIB, 4 * MIB, [szip], struct.pack("<I", 0xF0000000) + block[4:])


def element(kind, data):
    return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)


def matrix_head(name, numbers, kind, size):
    return (element(6, struct.pack("<II", 6, 0)) + element(5, struct.pack("<ii", numbers, 1))
            + element(1, name) + struct.pack("<II", kind, size))


def mat_file(name, elements):
    with open(os.path.join(folder, name), "wb") as f:
        f.write(b"MATLAB 5.0 MAT-file".ljust(124) + b"\x00\x01IM" + b"".join(elements))


def compressed(data):
    return struct.pack("<II", 15, len(data)) + data


def deflated_matrix(name, mebibytes):
    head = matrix_head(name, mebibytes * MIB // 8, 9, mebibytes * MIB)
    return deflated(struct.pack("<II", 14, len(head) + mebibytes * MIB) + head, mebibytes)


def mat_bombs():
    stream = deflated_matrix(b"y", 512)
    mat_file("mat_512MiB.mat", [compressed(stream)])
    mat_file("mat_variables.mat",
             [compressed(deflated_matrix(b"v%02d" % i, 60)) for i in range(12)])
    mat_file("mat_nested.mat", [compressed(zlib.compress(compressed(stream), 9))])
    # Says 1 MiB, goes on for 512.
    head = matrix_head(b"y", MIB // 8, 9, MIB)
    lie = deflated(struct.pack("<II", 14, len(head) + MIB) + head, 512)
    mat_file("mat_lie.mat", [compressed(lie)])
    path = os.path.join(folder, "mat73.mat")
    with h5py.File(path, "w", userblock_size=512) as f:
        d = chunked(f, "x", "f8", 512 * MIB, 2 * MIB, [deflate], zeros(16 * MIB))
        attribute = h5py.Dataset(d).attrs
        attribute["MATLAB_class"] = np.bytes_("double")
    with open(path, "r+b") as f:
        f.write(b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM")


def text_bombs():
    with open(os.path.join(folder, "blank_lines.csv"), "w") as f:
        row = ",".join(["1.5"] * 1000) + "\n"
        f.write(row * 3)
        for _ in range(300):
            f.write("\n" * 1200 + row)
    columns = 1000
    with open(os.path.join(folder, "empty_cells.lvm"), "w") as f:
        f.write("LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\n"
                "Decimal_Separator\t.\nMulti_Headings\tNo\nX_Columns\tOne\n***End_of_Header***\t\n\n"
                "Channels\t%d\nDelta_X" % columns + "\t0.001" * columns
                + "\n***End_of_Header***" + "\t" * columns + "\nX_Value"
                + "".join("\tc%d" % i for i in range(columns)) + "\tComment\n")
        segment = "0\n" * 1000 + "0" + "\t1" * columns + "\n\n"
        f.write(segment * 400)


def tdms_bomb():
    """Pieces of one sample that do not lie evenly."""
    def text(value):
        return struct.pack("<I", len(value)) + value

    channels = 1000
    meta = struct.pack("<I", channels)
    for i in range(channels):
        meta += text(b"/'g'/'c%d'" % i) + struct.pack("<IIIQI", 20, 5, 1, 1, 0)
    with open(os.path.join(folder, "pieces.tdms"), "wb") as f:
        f.write(b"TDSm" + struct.pack("<IIQQ", 0x0E, 4713, len(meta) + channels, len(meta)) + meta
                + bytes(channels))
        for i in range(4000):
            pad = bytes(i * i % 97)
            f.write(b"TDSm" + struct.pack("<IIQQ", 0x08, 4713, channels + len(pad), len(pad)) + pad
                    + bytes(channels))


for make in (gzip_bombs, lying_bombs, nested_bombs, szip_bombs, mat_bombs, text_bombs, tdms_bomb):
    make()
