#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes small HDF5 files of every kind that the readers tell apart into a folder, for fuzzing."""

import pathlib
import sys

import h5py
import numpy as np

SAMPLES = np.arange(64, dtype="i2")


def capture(file: h5py.File) -> None:
    file.attrs["format"] = "dyncal-capture"
    file.attrs["format_version"] = np.array([1, 0], "i4")
    file.create_group("setup/tube").attrs["driven_length_m"] = 5.0
    sensor = file.create_group("setup/sensors/s1")
    sensor.attrs.update({"sensitivity": 1e-6, "role": "dut"})
    shot = file.create_group("shots/001")
    shot.attrs.update({"label": "1", "level": "low", "valid": np.int8(1)})
    shot.create_group("environment").attrs.update({"p1_Pa": 1e5, "T1_K": 293.0})
    channel = shot.create_dataset("channels/DUT", data=SAMPLES)
    channel.attrs.update({"sample_rate_Hz": 1e8, "t0_s": -1e-6, "scale": 1e-3, "offset": 0.5, "unit": "V",
                          "role": "dut", "sensor": "/setup/sensors/s1", "adc_bits": 14, "adc_min": -8192,
                          "adc_max": 8191})


def foreign(file: h5py.File) -> None:
    data = file.create_dataset("entry/detector/data", data=SAMPLES, chunks=(16,))
    data.attrs.update({"sample_rate": "1 MHz", "scale_factor": 0.5, "units": "V"})
    file["entry/detector/time"] = np.arange(64) * 1e-6
    file["entry/fs"] = 1e6
    file["other"] = file["entry"]


def table(file: h5py.File) -> None:
    file.create_dataset("table", data=np.ones((40, 3), "f4"), chunks=(8, 3), compression="gzip").attrs["dt"] = 1e-6


def matlab(file: h5py.File) -> None:
    for name, value in {"p": np.ones((1, 64)), "x": np.ones((2, 64), "f4"), "fs": np.array([[1e6]])}.items():
        file.create_dataset(name, data=value).attrs["MATLAB_class"] = np.bytes_("single" if value.dtype == "f4" else "double")


def main() -> None:
    folder = pathlib.Path(sys.argv[1])
    for make in capture, foreign, table, matlab:
        path = folder / f"seed-{make.__name__}"
        with h5py.File(path, "w", libver="earliest", userblock_size=512 if make is matlab else 0) as file:
            make(file)
        bytes_ = bytearray(path.read_bytes())
        if make is matlab:
            bytes_[:128] = b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM"
        reader = {"capture": 0, "matlab": 2}.get(make.__name__, 1)  # see fuzz_hdf5.cpp
        path.write_bytes(bytes_ + bytes([reader]))


if __name__ == "__main__":
    main()
