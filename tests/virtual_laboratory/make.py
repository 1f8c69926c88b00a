# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One calibration by name and seed. Run as a program: writes it into a folder.

python3 -m virtual_laboratory.make CONDITION SEED FOLDER
"""
import sys
import zlib

import numpy as np

from . import capture_file, laboratory, switches
from . import conditions_operator, conditions_record, studies_conditions  # noqa: F401 (they register)
from .conditions_laboratory import CONDITIONS


def generator(name, seed):
    """The only source of chance: PCG64 of the condition's name and the seed."""
    return np.random.Generator(np.random.PCG64([zlib.crc32(name.encode()), seed]))


def make(name, seed, folder):
    """Writes capture.h5, recipe.json and truth.json; the same bytes of samples for the same name and seed."""
    rng = generator(name, seed)
    lab = CONDITIONS[name](switches.default(rng), rng)
    records = laboratory.perform(lab, rng)
    capture_file.write(folder, lab, records, name, seed)
    return lab


if __name__ == "__main__":
    make(sys.argv[1], int(sys.argv[2]), sys.argv[3])
