// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/model_values.h"

#include "core/model_analysis/stated_characteristics.h"
#include "core/uncertainty/characteristic_values.h"
#include "core/uncertainty/front_effect.h"
#include "core/uncertainty/model_noise.h"
#include "core/uncertainty/settling_spread.h"
#include "core/uncertainty/weak_modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// Those that records and band allow to state.
void keepStated(const ResponseResult &response, CharacteristicValues &values)
{
    const StatedCharacteristics stated = statedCharacteristics(response);
    values.within5percent_Hz = stated.within5percent_Hz.value.value_or(kUnknown);
    values.within10percent_Hz = stated.within10percent_Hz.value.value_or(kUnknown);
    values.minus3dB_Hz = stated.minus3dB_Hz.value.value_or(kUnknown);
    values.riseTime_s = stated.riseTime_s.value.value_or(kUnknown);
    values.overshoot_percent = stated.overshoot_percent.value.value_or(kUnknown);
    values.settlingTime_s = stated.settlingTime_s.value.value_or(kUnknown);
}

using Spread = std::array<double, kCharacteristics.size()>;

Spread spreadOf(const std::vector<std::pair<CharacteristicValues, CharacteristicValues>> &moved)
{
    Spread u{};
    if (moved.empty())
        u.fill(kUnknown);
    for (const auto &[up, down] : moved)
        for (std::size_t i = 0; i < kCharacteristics.size(); ++i)
            u[i] += std::pow((up.*kCharacteristics[i].value - down.*kCharacteristics[i].value)
                    / (2.0 * kVariation),
                2);
    for (double &one : u)
        one = std::sqrt(one);
    return u;
}

/// f0 and damping as assessed; everything else of the model is as uncertain in proportion, which is
/// returned. Of a free decay nothing moves but these.
double takeAssessed(const SensorResonance &assessed, Spread &u)
{
    if (!std::isfinite(assessed.u_frequency_Hz))
        return 1.0;
    const double wider = widening(assessed.u_frequency_Hz, u[0], assessed.u_dampingRatio, u[1]);
    for (double &one : u)
        one *= wider;
    u[0] = assessed.u_frequency_Hz;
    u[1] = assessed.u_dampingRatio;
    u[2] = 0.5 * assessed.u_dampingRatio / std::pow(assessed.dampingRatio, 2);
    return wider;
}

double *memberOf(Spread &u, double CharacteristicValues::*value)
{
    const auto found = std::ranges::find(kCharacteristics, value, &Characteristic::value);
    return &u[static_cast<std::size_t>(found - kCharacteristics.begin())];
}

/// What the front does to every value, as lines without an amount where it does nothing.
std::array<UncertaintyLine, kCharacteristics.size()> frontLines(const SensorModel &model,
    const MainPair &pair, ResponseTreatment treatment, const FrontDuration &front)
{
    const auto [range, shorterModel, longerModel] = frontVariation(model, front);
    const CharacteristicValues shorter = characteristicValues(shorterModel, pair, treatment);
    const CharacteristicValues longer = characteristicValues(longerModel, pair, treatment);
    std::array<UncertaintyLine, kCharacteristics.size()> lines;
    for (std::size_t i = 0; i < kCharacteristics.size(); ++i) {
        const double change
            = (longer.*kCharacteristics[i].value - shorter.*kCharacteristics[i].value)
            / range.divisor;
        lines[i] = directLine(range.quantity,
            kCharacteristics[i].ofPoles || !std::isfinite(change) ? 0.0 : std::abs(change));
    }
    return lines;
}

/// What the values would be if the weak modes were none of the sensor's; empty without such.
std::optional<CharacteristicValues> valuesWithoutWeak(
    const SensorModel &model, const MainPair &pair, ResponseTreatment treatment)
{
    const auto reduced = pair ? withoutWeakModes(model, *pair) : std::nullopt;
    return reduced ? std::optional(characteristicValues(*reduced, pair, treatment)) : std::nullopt;
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
    CharacteristicValues values = characteristicValues(model, pair, treatment);
    keepStated(response, values);
    std::vector<std::pair<CharacteristicValues, CharacteristicValues>> moved;
    moved.reserve(variations.size());
    for (const ModelVariation &one : variations)
        moved.emplace_back(characteristicValues(one.up, pair, treatment),
            characteristicValues(one.down, pair, treatment));
    Spread u = spreadOf(moved);
    const auto assessed = sensorResonance(&model, &assessment);
    const double wider = assessed ? takeAssessed(*assessed, u) : 1.0;
    if (std::isfinite(values.settlingTime_s)) {
        double &ofSettling_s = *memberOf(u, &CharacteristicValues::settlingTime_s);
        ofSettling_s = settlingSpread_s(model, variations, treatment, ofSettling_s, wider);
    }
    const auto ofFront = frontLines(model, pair, treatment, response.front);
    const auto withoutWeak = valuesWithoutWeak(model, pair, treatment);
    std::vector<ReportedValue> reported;
    for (std::size_t i = 0; i < kCharacteristics.size(); ++i) {
        ReportedValue one{kCharacteristics[i].of, values.*kCharacteristics[i].value,
            kCharacteristics[i].unit, {}, {}};
        if (!std::isfinite(one.value))
            continue;
        const bool isShaped = !kCharacteristics[i].ofPoles && isStepTreatment(treatment);
        const double other
            = isShaped && withoutWeak ? *withoutWeak.*kCharacteristics[i].value : one.value;
        one.missing = whyIncomplete(u[i], other);
        if (*one.missing.text == '\0') {
            one.lines = {modelNoiseLine(u[i], model, assessment)};
            if (kCharacteristics[i].kind != CharacteristicKind::Number)
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
