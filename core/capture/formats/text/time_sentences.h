// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/base/index.h"
#include "core/base/result.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/text/header_rate.h"
#include "core/capture/formats/text/time_words.h"

#include <string>
#include <vector>

namespace dyncal {

/// Errors and findings about the times of one table; each names file, place and both values.
struct TimeSentences
{
    const std::string &path;
    const std::vector<ColumnTitle> &titles;
    Index headerLines = 0;

    using Failure = tl::unexpected<Error>;

    Failure frequencies(const ColumnTitle &title) const; ///< CAP-001
    Failure headerContradictsItself(const HeaderRate &a, const HeaderRate &b) const; ///< CAP-003
    Failure headerAgainstTimes(const HeaderRate &header, double times_Hz) const; ///< CAP-003
    Failure recipeAgainstTimes(double recipe_Hz, double times_Hz) const; ///< CAP-003
    /// The column holds times, too, but others than the column of times.
    Failure otherTimes(const std::string &name, const std::string &timeName) const; ///< CAP-003
    Failure noUnitAgrees(double step, double known_Hz) const; ///< CAP-003
    Failure irregular(const std::vector<double> &times, const TimeAxis &axis) const; ///< CAP-016
    Failure unknownUnit(const std::string &unit) const; ///< CAP-016

    Finding headerOverruled(const HeaderRate &header, double times_Hz) const; ///< CAP-003
    Finding headerUnitAssumed(const HeaderRate &header) const; ///< CAP-003
    Finding ratePassedOver(double recipe_Hz, double times_Hz) const; ///< CAP-003
    Finding unitUnknown(const std::string &name, double step, bool counter) const; ///< CAP-003
    Finding secondsAssumed(const std::string &name, double rate_Hz, Severity severity) const;
    Finding irregularPassedOver(const TimeAxis &axis) const; ///< CAP-016
    Finding looksLikeTimes(const ColumnTitle &title) const; ///< CAP-016
};

} // namespace dyncal
