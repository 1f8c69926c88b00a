// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/correction/correction_filter.h"

#include <string>
#include <vector>

namespace dyncal {

/// A filter in a format for use elsewhere.
struct FilterFile
{
    std::string name;
    std::string bytes;
};

/// filter.json (schema "dyncal-filter/1": the taps with u, and what they are), filter.csv (`tap`,
/// `u_tap`), filter_errors.csv (a column for each error of the response: the taps' covariance is
/// this matrix times its transpose), filter.mat (`h`, `E`, `fs`, `delay`, `band`) and filter.py,
/// which applies filter.mat to a record, with the u from the response.
std::vector<FilterFile> filterFiles(const CorrectionFilter &filter);

/// The names of these files.
const std::vector<std::string> &filterFileNames();

} // namespace dyncal
