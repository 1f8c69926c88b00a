// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/uncertainty/model_values.h"

#include "core/model_analysis/stated_characteristics.h"
#include "core/uncertainty/characteristic_values.h"
#include "core/uncertainty/front_effect.h"
#include "core/uncertainty/model_noise.h"
#include "core/uncertainty/model_shape.h"
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

using LineOfEach = std::array<UncertaintyLine, kCharacteristics.size()>;

/// What the front does to every value, as lines without an amount where it does nothing.
LineOfEach frontLines(const SensorModel &model, const MainPair &pair, ResponseTreatment treatment,
    const FrontDuration &front)
{
    const auto [range, shorterModel, longerModel] = frontVariation(model, front);
    const CharacteristicValues shorter = characteristicValues(shorterModel, pair, treatment);
    const CharacteristicValues longer = characteristicValues(longerModel, pair, treatment);
    LineOfEach lines;
    for (std::size_t i = 0; i < kCharacteristics.size(); ++i) {
        const double change
            = (longer.*kCharacteristics[i].value - shorter.*kCharacteristics[i].value)
            / range.divisor;
        lines[i] = directLine(range.quantity,
            kCharacteristics[i].ofPoles || !std::isfinite(change) ? 0.0 : std::abs(change));
    }
    return lines;
}

/// What a level that the mounting takes part in does to every value; without a number where the
/// value does not exist at both ends of u.
LineOfEach mountingLines(const SensorModel &model, const MainPair &pair,
    ResponseTreatment treatment, const UncertaintyLine &mounting)
{
    constexpr double kWhereExact = 1e-4; // to tell what a u would do that is stated as 0
    const double end = mounting.u > 0.0 ? mounting.u : kWhereExact;
    const auto more = characteristicValues(withMounting(model, end), pair, treatment);
    const auto less = characteristicValues(withMounting(model, -end), pair, treatment);
    LineOfEach lines;
    for (std::size_t i = 0; i < kCharacteristics.size(); ++i) {
        const auto value = kCharacteristics[i].value;
        lines[i] = mounting;
        lines[i].correlated = {}; // with lines of the step and the chain, which shapes have not
        lines[i].sensitivity = (more.*value - less.*value) / (2.0 * end);
        if (mounting.u == 0.0 && !std::isfinite(lines[i].sensitivity))
            lines[i].sensitivity = 0.0;
        lines[i].contribution = lines[i].sensitivity * mounting.u;
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

/// What a value depends on that is not the noise's and not the clock's; of one without amplitudes
/// nothing.
struct ShapeLines
{
    LineOfEach ofFront;
    LineOfEach ofMounting;
    std::optional<CharacteristicValues> withoutWeak;
};

/// Empty where u can be stated.
Message whyIncomplete(double u, const ShapeLines *shape, std::size_t i)
{
    if (!std::isfinite(u))
        return {DYNCAL_TEXT("core", "the model was not refined"), {}};
    if (shape && shape->withoutWeak
        && !std::isfinite(*shape->withoutWeak.*kCharacteristics[i].value))
        return {DYNCAL_TEXT("core",
                    "an oscillation below 1 % of the step decides it, which may be the mount's"),
            {}};
    if (shape && !std::isfinite(shape->ofMounting[i].contribution))
        return {DYNCAL_TEXT("core", "what the mounting may add to the level decides it"), {}};
    return {};
}

void addShape(const ShapeLines &shape, std::size_t i, ReportedValue &value)
{
    value.lines.push_back(shape.ofFront[i]);
    value.lines.push_back(shape.ofMounting[i]);
    if (shape.withoutWeak)
        value.lines.push_back(
            weakModeLine(value.value, *shape.withoutWeak.*kCharacteristics[i].value));
}

} // namespace

std::vector<ReportedValue> modelValues(const SensorModel &model, const ModelAssessment &assessment,
    const ResponseResult &response, const std::vector<ModelVariation> &variations,
    ResponseTreatment treatment, const ChainEffects &chain)
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
    const ShapeLines shape{frontLines(model, pair, treatment, response.front),
        mountingLines(model, pair, treatment, mountingOf(chain)),
        valuesWithoutWeak(model, pair, treatment)};
    std::vector<ReportedValue> reported;
    for (std::size_t i = 0; i < kCharacteristics.size(); ++i) {
        ReportedValue one{kCharacteristics[i].of, values.*kCharacteristics[i].value,
            kCharacteristics[i].unit, {}, {}};
        if (!std::isfinite(one.value))
            continue;
        const bool isShaped = !kCharacteristics[i].ofPoles && isStepTreatment(treatment);
        one.missing = whyIncomplete(u[i], isShaped ? &shape : nullptr, i);
        if (*one.missing.text == '\0') {
            one.lines = {modelNoiseLine(u[i], model, assessment)};
            if (kCharacteristics[i].kind != CharacteristicKind::Number)
                one.lines.push_back(scaled({chain.clock}, one.value).front());
            if (isShaped)
                addShape(shape, i, one);
            combineLines(one);
        }
        reported.push_back(std::move(one));
    }
    return reported;
}

} // namespace dyncal
