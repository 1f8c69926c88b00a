// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_words.h"

#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/base/rounding.h"
#include "core/realization/model/sensor_model.h"
#include "core/uncertainty/reported_value.h"

#include <cmath>

namespace dyncal {

bool isBlank(std::string_view text)
{
    return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

Message verbatim(std::string text)
{
    return {"%1", {std::move(text)}};
}

Message inNumbers(std::string text)
{
    return {"%L1", {std::move(text)}};
}

double valueAt(const Eigen::VectorXd &values, Index row)
{
    return row < values.size() ? values[row] : kUnknown;
}

Message dash()
{
    return verbatim("\xE2\x80\x93");
}

Message setting(double value, std::string_view unit)
{
    return inNumbers(settingText(value, unit));
}

Message printed(const std::optional<double> &value, std::string_view unit, Message otherwise)
{
    if (!value || !std::isfinite(*value))
        return otherwise;
    return inNumbers(roundedText(*value, kUnknown, unit));
}

double printedCoverage(double k)
{
    return statedFactor(k);
}

double printableU(double u, double k, double leastExpanded)
{
    return neverBelow(k * u, leastExpanded) / k;
}

std::string factorText(double k)
{
    constexpr double kMostOfUse = 1e4; // reached with a fraction of a degree of freedom
    return k < kMostOfUse ? fixedText(k, 2) : numberText(k, 3);
}

std::string printedFactor(double k)
{
    const double stated = printedCoverage(k);
    return stated == kCoverageFactor ? fixedText(stated, 0) : factorText(stated);
}

std::string coverageText(double k)
{
    return " (k = " + (k == kCoverageFactor ? fixedText(k, 0) : factorText(k)) + ")";
}

Message printedWithUncertainty(double value, double u, std::string_view unit, double k)
{
    if (!std::isfinite(value))
        return dash();
    const RoundedValue rounded = roundedValue(value, k * u, unit);
    const std::string tail = rounded.unit.empty() ? "" : " " + rounded.unit;
    if (rounded.u.empty())
        return inNumbers(rounded.value + tail);
    return inNumbers(rounded.value + tail + " \xC2\xB1 " + rounded.u + tail + coverageText(k));
}

Message expandedCell(double value, double u, std::string_view unit, double k)
{
    const RoundedValue rounded = roundedValue(value, k * u, unit);
    if (rounded.u.empty())
        return dash();
    return inNumbers(rounded.u + (rounded.unit.empty() ? "" : " " + rounded.unit)
        + (k == kCoverageFactor ? "" : coverageText(k)));
}

Message valueCell(double value, double u, std::string_view unit, double k)
{
    return inNumbers(roundedText(value, k * u, unit));
}

Message levelWord(ShotLevel level)
{
    switch (level) {
    case ShotLevel::Low:
        return {DYNCAL_TEXT("core", "low"), {}};
    case ShotLevel::Medium:
        return {DYNCAL_TEXT("core", "medium"), {}};
    case ShotLevel::High:
        return {DYNCAL_TEXT("core", "high"), {}};
    case ShotLevel::None:
        break;
    }
    return dash();
}

} // namespace dyncal
