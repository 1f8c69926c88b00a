// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/batch_tally.h"

#include <string>
#include <vector>

namespace dyncal {

/// A batch as CSV, one row for each sensor in the order given: `sensor`, `state`, for each key
/// result its value, U (`u_expanded_...`) and k (sensitivity, f0_hz and damping_ratio first, then
/// what else any sensor has, sorted), `sensitivity_unit`, the ids of what blocks, of cautions and
/// of notes ("WIN-001@2" is of shot 2), and the reason of what is blocked or failed. Numbers as the
/// shortest text that reads back the same; a cell is empty where there is none. No times and no
/// paths of the machine: the same results give the same bytes.
std::string batchSummaryCsv(const std::vector<SensorStanding> &standings);

} // namespace dyncal
