// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/model_values.h"

#include "core/model_analysis/marked_frequencies.h"
#include "core/model_analysis/stated_characteristics.h"
#include "core/uncertainty/front_effect.h"
#include "core/uncertainty/model_noise.h"
#include "core/uncertainty/weak_modes.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace dyncal {
namespace {

/// The values as numbers, NaN where one does not exist.
struct Values
{
    double f0_Hz = kUnknown;
    double zeta = kUnknown;
    double q = kUnknown;
    double resonance_Hz = kUnknown;
    double resonanceGain = kUnknown;
    double within5percent_Hz = kUnknown;
    double within10percent_Hz = kUnknown;
    double minus3dB_Hz = kUnknown;
    double riseTime_s = kUnknown;
    double overshoot_percent = kUnknown;
    double settlingTime_s = kUnknown;
};

enum class Kind { Number, Frequency, Time };

struct Row
{
    const char *of;
    const char *unit;
    double Values::*value;
    Kind kind;
    bool ofPoles = false; ///< does not depend on amplitudes
};

constexpr std::array<Row, 11> kRows{{
    {"f0_hz", "Hz", &Values::f0_Hz, Kind::Frequency, true},
    {"damping_ratio", "", &Values::zeta, Kind::Number, true},
    {"q", "", &Values::q, Kind::Number, true},
    {"resonance_hz", "Hz", &Values::resonance_Hz, Kind::Frequency},
    {"resonance_gain", "", &Values::resonanceGain, Kind::Number},
    {"within_5_percent_hz", "Hz", &Values::within5percent_Hz, Kind::Frequency},
    {"within_10_percent_hz", "Hz", &Values::within10percent_Hz, Kind::Frequency},
    {"minus_3_db_hz", "Hz", &Values::minus3dB_Hz, Kind::Frequency},
    {"rise_time_s", "s", &Values::riseTime_s, Kind::Time},
    {"overshoot_percent", "%", &Values::overshoot_percent, Kind::Number},
    {"settling_time_s", "s", &Values::settlingTime_s, Kind::Time},
}};

/// f0 and zeta of a pair, or of the sensor's two real poles.
void addResonance(std::complex<double> one, std::complex<double> other, Values &values)
{
    const double omega = std::sqrt(std::abs(one) * std::abs(other));
    values.f0_Hz = omega / kTwoPi;
    values.zeta = -0.5 * (one.real() + other.real()) / omega;
    values.q = 0.5 / values.zeta;
}

void addPeak(const SensorModel &model, ResponseTreatment treatment, Values &values)
{
    if (const auto peak = resonancePeak(model, treatment, values.f0_Hz, values.zeta)) {
        values.resonance_Hz = peak->frequency_Hz;
        values.resonanceGain = peak->gain;
    }
}

/// The two poles that f0 and zeta are of, as positions in the list; empty where there are none.
std::optional<std::pair<std::size_t, std::size_t>> mainPair(
    const SensorModel &model, const ModelAssessment &assessment)
{
    if (model.secondOrder)
        return std::pair(model.poles.size() - 2, model.poles.size() - 1);
    const Pole *main = mainPole(model, &assessment);
    if (!main)
        return std::nullopt;
    const auto at = static_cast<std::size_t>(main - assessment.poles.data());
    return std::pair(at, at + 1);
}

Values valuesOf(const SensorModel &model,
    const std::optional<std::pair<std::size_t, std::size_t>> &pair, ResponseTreatment treatment)
{
    Values values;
    if (pair) {
        addResonance(model.poles[pair->first].s_rad_s, model.poles[pair->second].s_rad_s, values);
        if (isStepTreatment(treatment))
            addPeak(model, treatment, values);
    }
    const StepCharacteristics step = stepCharacteristics(model, treatment);
    values.within5percent_Hz = step.within5percent_Hz.value_or(kUnknown);
    values.within10percent_Hz = step.within10percent_Hz.value_or(kUnknown);
    values.minus3dB_Hz = step.minus3dB_Hz.value_or(kUnknown);
    values.riseTime_s = step.riseTime_s.value_or(kUnknown);
    values.overshoot_percent = step.overshoot_percent.value_or(kUnknown);
    values.settlingTime_s = step.settlingTime_s.value_or(kUnknown);
    return values;
}

/// Those that records and band allow to state.
void keepStated(const ResponseResult &response, Values &values)
{
    const StatedCharacteristics stated = statedCharacteristics(response);
    values.within5percent_Hz = stated.within5percent_Hz.value.value_or(kUnknown);
    values.within10percent_Hz = stated.within10percent_Hz.value.value_or(kUnknown);
    values.minus3dB_Hz = stated.minus3dB_Hz.value.value_or(kUnknown);
    values.riseTime_s = stated.riseTime_s.value.value_or(kUnknown);
    values.overshoot_percent = stated.overshoot_percent.value.value_or(kUnknown);
    values.settlingTime_s = stated.settlingTime_s.value.value_or(kUnknown);
}

using Spread = std::array<double, kRows.size()>;

Spread spreadOf(const std::vector<std::pair<Values, Values>> &moved)
{
    Spread u{};
    if (moved.empty())
        u.fill(kUnknown);
    for (const auto &[up, down] : moved)
        for (std::size_t i = 0; i < kRows.size(); ++i)
            u[i] += std::pow((up.*kRows[i].value - down.*kRows[i].value) / (2.0 * kVariation), 2);
    for (double &one : u)
        one = std::sqrt(one);
    return u;
}

/// f0 and damping as assessed; everything else of the model is as uncertain in proportion. Of a
/// free decay nothing moves but these.
void takeAssessed(const SensorResonance &assessed, Spread &u)
{
    if (!std::isfinite(assessed.u_frequency_Hz))
        return;
    const double wider = widening(assessed.u_frequency_Hz, u[0], assessed.u_dampingRatio, u[1]);
    for (double &one : u)
        one *= wider;
    u[0] = assessed.u_frequency_Hz;
    u[1] = assessed.u_dampingRatio;
    u[2] = 0.5 * assessed.u_dampingRatio / std::pow(assessed.dampingRatio, 2);
}

/// What the front does to every value, as lines without an amount where it does nothing.
std::array<UncertaintyLine, kRows.size()> frontLines(const SensorModel &model,
    const std::optional<std::pair<std::size_t, std::size_t>> &pair, ResponseTreatment treatment,
    const FrontDuration &front)
{
    const auto [range, shorterModel, longerModel] = frontVariation(model, front);
    const Values shorter = valuesOf(shorterModel, pair, treatment);
    const Values longer = valuesOf(longerModel, pair, treatment);
    std::array<UncertaintyLine, kRows.size()> lines;
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        const double change = (longer.*kRows[i].value - shorter.*kRows[i].value) / range.divisor;
        lines[i] = directLine(
            range.quantity, kRows[i].ofPoles || !std::isfinite(change) ? 0.0 : std::abs(change));
    }
    return lines;
}

/// What the values would be if the weak modes were none of the sensor's; empty without such.
std::optional<Values> valuesWithoutWeak(const SensorModel &model,
    const std::optional<std::pair<std::size_t, std::size_t>> &pair, ResponseTreatment treatment)
{
    const auto reduced = pair ? withoutWeakModes(model, *pair) : std::nullopt;
    return reduced ? std::optional(valuesOf(*reduced, pair, treatment)) : std::nullopt;
}

/// Either of two values, evenly likely, about the one that is stated.
UncertaintyLine weakModeLine(double value, double without)
{
    return directLine("weak_mode", std::abs(value - without) / std::numbers::sqrt2);
}

/// Empty where u can be stated. `other`: the value without the weak modes.
Message whyIncomplete(double u, double other)
{
    if (!std::isfinite(u))
        return {DYNCAL_TEXT("core", "the model was not refined"), {}};
    if (!std::isfinite(other))
        return {DYNCAL_TEXT("core",
                    "an oscillation below 1 % of the step decides it, which may be the mount's"),
            {}};
    return {};
}

} // namespace

std::vector<ReportedValue> modelValues(const SensorModel &model, const ModelAssessment &assessment,
    const ResponseResult &response, const std::vector<ModelVariation> &variations,
    ResponseTreatment treatment, const UncertaintyLine &clock)
{
    const auto pair = mainPair(model, assessment);
    Values values = valuesOf(model, pair, treatment);
    keepStated(response, values);
    std::vector<std::pair<Values, Values>> moved;
    moved.reserve(variations.size());
    for (const ModelVariation &one : variations)
        moved.emplace_back(valuesOf(one.up, pair, treatment), valuesOf(one.down, pair, treatment));
    Spread u = spreadOf(moved);
    const auto assessed = sensorResonance(&model, &assessment);
    if (assessed)
        takeAssessed(*assessed, u);
    const auto ofFront = frontLines(model, pair, treatment, response.front);
    const auto withoutWeak = valuesWithoutWeak(model, pair, treatment);
    std::vector<ReportedValue> reported;
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        ReportedValue one{kRows[i].of, values.*kRows[i].value, kRows[i].unit, {}, {}};
        if (!std::isfinite(one.value))
            continue;
        const bool isShaped = !kRows[i].ofPoles && isStepTreatment(treatment);
        const double other = isShaped && withoutWeak ? *withoutWeak.*kRows[i].value : one.value;
        one.missing = whyIncomplete(u[i], other);
        if (*one.missing.text == '\0') {
            one.lines = {modelNoiseLine(u[i], model, assessment)};
            if (kRows[i].kind != Kind::Number)
                one.lines.push_back(scaled({clock}, one.value).front());
            if (isShaped)
                one.lines.push_back(ofFront[i]);
            if (isShaped && withoutWeak)
                one.lines.push_back(weakModeLine(one.value, other));
            combineLines(one);
        }
        reported.push_back(std::move(one));
    }
    return reported;
}

} // namespace dyncal
