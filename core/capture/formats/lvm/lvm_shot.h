// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/capture_set.h"
#include "core/capture/formats/lvm/lvm_header.h"
#include "core/capture/formats/lvm/lvm_rows.h"

#include <string>

namespace dyncal {

/// Makes a shot of one segment. Channels without samples are left out. Doubts are added to
/// `findings` under the shot's number: CAP-003 the rate is known to few digits, CAP-016 the X cells
/// contradict Delta_X, CAP-018 samples or columns that the header does not declare.
Shot lvmShot(const std::string &path, Index number, const LvmSegment &segment,
    const LvmFileHeader &file, LvmRows rows, Findings &findings);

} // namespace dyncal
