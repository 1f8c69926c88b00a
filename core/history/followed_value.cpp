// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/followed_value.h"

#include "core/base/number_text.h"
#include "core/results/results_reading.h"
#include "core/uncertainty/reported_value.h"

#include <cmath>

namespace dyncal {
namespace {

constexpr const char *kNotDetermined = "Not determined in this calibration.";
constexpr const char *kNoU = "These results state no uncertainty of it.";
constexpr const char *kNoCompleteU
    = "The uncertainty in these results is that of the noise alone, because they are from before the budget was complete.";
constexpr int kDigitsOfFrequency = 6;

std::string frequencyText(double f_Hz)
{
    return numberWithUnit(f_Hz, "Hz", kDigitsOfFrequency);
}

FollowedValue notStated(std::string why)
{
    FollowedValue none;
    none.missing = std::move(why);
    return none;
}

FollowedValue stated(double value, double u, double k, std::string unit)
{
    if (!std::isfinite(value))
        return notStated(kNotDetermined);
    if (!(u >= 0.0 && std::isfinite(u)))
        return {value, kUnknown, kUnknown, std::move(unit), kNoU};
    return {value, u, statedFactor(k), std::move(unit), {}};
}

FollowedValue statedIn(const nlohmann::json &object)
{
    return stated(numberAt(object, "value"), numberAt(object, "u"), numberAt(object, "k"),
        textAt(object, "unit"));
}

FollowedValue characteristicOf(const nlohmann::json &results, const std::string &name)
{
    const nlohmann::json &list = valueAt(results, "characteristics");
    if (!list.is_array())
        return notStated(kNoCompleteU);
    for (const nlohmann::json &one : list)
        if (textAt(one, "quantity") == name)
            return statedIn(one);
    return notStated(kNotDetermined);
}

/// The number in a list of a section; NaN where it ends before.
double inList(const nlohmann::json &section, const std::string &key, Index i)
{
    const Eigen::VectorXd list = numbersAt(section, key);
    return i < list.size() ? list[i] : kUnknown;
}

/// Why the row has no value.
std::string whyWithheld(const nlohmann::json &response, Index i)
{
    const nlohmann::json &reasons = valueAt(response, "withheld_reason");
    const auto at = static_cast<std::size_t>(i);
    const bool isSaid = reasons.is_array() && at < reasons.size() && reasons[at].is_string();
    return isSaid ? reasons[at].get<std::string>() : kNotDetermined;
}

FollowedValue statedRow(const nlohmann::json &response, FollowedKind kind, Index i)
{
    if (kind == FollowedKind::Phase)
        return stated(inList(response, "phase_rad", i), inList(response, "u_phase_rad", i),
            inList(response, "k_phase", i), "rad");
    FollowedValue row = stated(inList(response, "magnitude", i), inList(response, "u_magnitude", i),
        inList(response, "k_magnitude", i), textAt(response, "unit"));
    const bool isOfNoise
        = valueAt(response, "u_contains_step") == false && row.unit.ends_with("/Pa");
    if (isOfNoise && std::isfinite(row.value))
        return {row.value, kUnknown, kUnknown, row.unit, kNoCompleteU};
    return row;
}

FollowedValue rowAt(const nlohmann::json &response, FollowedKind kind, Index i)
{
    const FollowedValue row = statedRow(response, kind, i);
    return std::isfinite(row.value) ? row : notStated(whyWithheld(response, i));
}

FollowedValue rowOf(const nlohmann::json &results, const FollowedQuantity &quantity)
{
    if (!std::isfinite(quantity.row_Hz))
        return notStated("No results have a row within 3 % of " + frequencyText(quantity.asked_Hz)
            + ", and nothing is interpolated.");
    const nlohmann::json &response = valueAt(results, "response");
    const Eigen::VectorXd f_Hz = numbersAt(response, "frequency_hz");
    for (Index i = 0; i < f_Hz.size(); ++i)
        if (std::abs(f_Hz[i] - quantity.row_Hz) <= kSameRow * quantity.row_Hz)
            return rowAt(response, quantity.kind, i);
    return notStated("These results have no row at " + frequencyText(quantity.row_Hz)
        + ", and nothing is interpolated.");
}

} // namespace

bool FollowedQuantity::isOverFrequency() const
{
    return kind == FollowedKind::Magnitude || kind == FollowedKind::Phase;
}

const char *FollowedQuantity::name() const
{
    switch (kind) {
    case FollowedKind::NaturalFrequency:
        break;
    case FollowedKind::DampingRatio:
        return "damping_ratio";
    case FollowedKind::Sensitivity:
        return "sensitivity";
    case FollowedKind::Magnitude:
        return "magnitude";
    case FollowedKind::Phase:
        return "phase_rad";
    }
    return "f0_hz";
}

FollowedValue followedValue(const nlohmann::json &results, const FollowedQuantity &quantity)
{
    if (quantity.isOverFrequency())
        return rowOf(results, quantity);
    return quantity.kind == FollowedKind::Sensitivity ? statedIn(valueAt(results, "sensitivity"))
                                                      : characteristicOf(results, quantity.name());
}

double servingRow_Hz(const std::vector<const nlohmann::json *> &results, double asked_Hz)
{
    double serving_Hz = kUnknown;
    double least = kServingRow * asked_Hz;
    for (const nlohmann::json *one : results) {
        const nlohmann::json &response = valueAt(*one, "response");
        const Eigen::VectorXd f_Hz = numbersAt(response, "frequency_hz");
        const Eigen::VectorXd magnitude = numbersAt(response, "magnitude");
        for (Index i = 0; i < std::min(f_Hz.size(), magnitude.size()); ++i) {
            if (!std::isfinite(magnitude[i]) || !(std::abs(f_Hz[i] - asked_Hz) <= least))
                continue;
            least = std::abs(f_Hz[i] - asked_Hz);
            serving_Hz = f_Hz[i];
        }
    }
    return serving_Hz;
}

} // namespace dyncal
