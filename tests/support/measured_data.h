// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/number_text.h"

#include <Eigen/Core>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

/// The one way in which a test may be skipped: `what` it misses lies in that folder. ./test knows
/// the words and fails for every other QSKIP (.ci/lib.sh, check_skips).
#define DYNCAL_SKIP_WITHOUT_DATA(what) QSKIP("NO DATA: " what)

/// Files with measured data that are not part of the source tree. They are looked for in the folder
/// DYNCAL_DATA, else in "../shared/data" beside the source tree; tests skip loudly without them.
namespace dyncal::testing {

inline std::filesystem::path dataFolder()
{
    if (const char *folder = std::getenv("DYNCAL_DATA"))
        return folder;
    const char *source = std::getenv("DYNCAL_SOURCE_DIR");
    return std::filesystem::path(source != nullptr ? source : ".") / ".." / "shared" / "data";
}

/// Numbers of one column of a text file with columns split by comma, blank or tab, independent of
/// the importers under test elsewhere. Rows without a number there are passed over; with
/// `behind`, so is everything up to the last line that holds that text and the line after it.
inline std::optional<Eigen::VectorXd> textColumn(
    const std::filesystem::path &file, std::size_t column, const std::string &behind = {})
{
    std::ifstream stream(file);
    if (!stream)
        return std::nullopt;
    std::vector<double> values;
    bool skipNext = false;
    for (std::string line; std::getline(stream, line);) {
        if (!behind.empty() && line.find(behind) != std::string::npos) {
            values.clear();
            skipNext = true;
            continue;
        }
        if (skipNext || line.starts_with('#')) {
            skipNext = false;
            continue;
        }
        std::vector<std::string> cells(1);
        for (const char c : line) {
            if (c == ',' || c == '\t' || c == ' ')
                cells.emplace_back();
            else if (c != '\r')
                cells.back() += c;
        }
        if (column < cells.size()) {
            if (const auto number = parseNumber(cells[column]))
                values.push_back(*number);
        }
    }
    return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace dyncal::testing
