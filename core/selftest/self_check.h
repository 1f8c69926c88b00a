// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace dyncal {

/// Changes the numbers that a check computes from, each by at most a given share and up or down as
/// a fixed sequence says: how far the result then moves is the sensitivity to what rounding does.
class DataChange
{
public:
    explicit DataChange(double relative = 0.0, std::uint64_t sequence = 1);

    double operator()(double value);
    Eigen::VectorXd operator()(Eigen::VectorXd values);

private:
    double m_relative;
    std::uint64_t m_state;
};

/// The change that the sensitivity of a check is stated for.
inline constexpr double kDataChange = 1e-12;

/// A quantity whose true value is known from outside the program.
struct CheckSpec
{
    const char *step = ""; ///< of the method, as in software.method; or one of kOtherSteps
    Message name;
    Message source; ///< where the expected value comes from
    double expected = 0.0;
    double tolerance = 0.0; ///< absolute, above 0
    double (*find)(DataChange &change) = nullptr; ///< NaN where it cannot be computed
};

/// The same as it came out.
struct SelfCheck
{
    std::string step;
    Message name;
    Message source;
    double expected = 0.0;
    double found = 0.0; ///< not finite where nothing could be computed
    double tolerance = 0.0;
    double sensitivity = 0.0; ///< change of `found` for changes of the data by kDataChange; NaN
                              ///< where nothing was found, and of random draws

    bool holds() const; ///< |found - expected| <= tolerance
};

/// Computes it as it is, and twice with changed data. An exception of the method is a result that
/// is not a number.
SelfCheck carriedOut(const CheckSpec &spec);

/// What is checked beside the stages of the method.
inline constexpr const char *kReadingStep = "reading";
inline constexpr const char *kCorrectionStep = "correction";
inline constexpr const char *kCertificateStep = "certificate";
inline constexpr const char *kCoverageStep = "coverage";

} // namespace dyncal
