// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/stated_characteristics.h"

#include "core/base/constants.h"
#include "core/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kFewestSamples = 2.0; ///< of a rise: in fewer its shape is a guess

StatedValue stated(double value, std::string_view unit)
{
    StatedValue result;
    result.value = value;
    result.words = {"%L1", {roundedText(value, kUnknown, unit)}};
    return result;
}

StatedValue atLeast(double bound, std::string_view unit, const char *words)
{
    StatedValue result;
    result.above = bound;
    result.words = {words, {boundText(bound, BoundSide::Lower, unit)}};
    return result;
}

StatedValue atMost(double bound, std::string_view unit, const char *words)
{
    StatedValue result;
    result.below = bound;
    result.words = {words, {boundText(bound, BoundSide::Upper, unit)}};
    return result;
}

StatedValue notDetermined(CharacteristicsGap gap)
{
    StatedValue result;
    switch (gap) {
    case CharacteristicsGap::FreeDecay:
        result.words = {DYNCAL_TEXT("core", "not determined (a free decay has no step)"), {}};
        break;
    case CharacteristicsGap::Diverges:
        result.words = {DYNCAL_TEXT("core", "not determined (the model diverges)"), {}};
        break;
    case CharacteristicsGap::LevelUnknown:
        result.words
            = {DYNCAL_TEXT("core", "not determined (the level of the step is not known)"), {}};
        break;
    case CharacteristicsGap::None:
        result.words = {DYNCAL_TEXT("core", "not determined (outside the range of the model)"), {}};
        break;
    }
    return result;
}

StatedValue riseWithin(double rise_s, double resolution_s)
{
    const double shortest_s = kFewestSamples * resolution_s;
    return rise_s < shortest_s
        ? atMost(shortest_s, "s", DYNCAL_TEXT("core", "below %1 (two samples)"))
        : stated(rise_s, "s");
}

bool isNumber(const std::optional<double> &value)
{
    return value && std::isfinite(*value);
}

/// What lies behind the end of the records is the model's guess.
StatedValue withinWindow(
    const std::optional<double> &time_s, const ResponseResult &response, double resolution_s)
{
    if (!isNumber(time_s))
        return notDetermined(response.gap);
    if (*time_s > response.window_s)
        return atLeast(
            response.window_s, "s", DYNCAL_TEXT("core", "above %1 (the window ends there)"));
    return riseWithin(*time_s, resolution_s);
}

StatedValue overshoot(const ResponseResult &response)
{
    const StepCharacteristics &found = response.characteristics;
    if (!isNumber(found.overshoot_percent))
        return notDetermined(response.gap);
    if (found.top_s && *found.top_s > response.window_s) {
        StatedValue result;
        result.words = {DYNCAL_TEXT("core", "not determined (the window ends before the top)"), {}};
        return result;
    }
    return stated(*found.overshoot_percent, "%");
}

/// A model of poles and a plateau always leaves the two bands about its plateau, but not always
/// downwards (-3 dB): then what is known is that it does not inside the band.
StatedValue bandEdge(
    const ResponseResult &response, const std::optional<double> &edge_Hz, bool isKnown)
{
    const double end_Hz = answersEnd_Hz(response);
    if (!isKnown || std::isnan(end_Hz) || (edge_Hz && !std::isfinite(*edge_Hz)))
        return notDetermined(response.gap);
    if (!edge_Hz || *edge_Hz > end_Hz)
        return std::isfinite(end_Hz) ? atLeast(end_Hz, "Hz",
                   DYNCAL_TEXT("core", "above %1 (the band of the response ends there)"))
                                     : notDetermined(response.gap);
    if (*edge_Hz < response.fLow_Hz)
        return atMost(response.fLow_Hz, "Hz",
            DYNCAL_TEXT("core", "below %1 (the band of the response begins there)"));
    return stated(*edge_Hz, "Hz");
}

} // namespace

double answersEnd_Hz(const ResponseResult &response)
{
    return std::min(response.fHigh_Hz, response.modelLimit_Hz);
}

StatedCharacteristics statedCharacteristics(const ResponseResult &response)
{
    const StepCharacteristics &found = response.characteristics;
    StatedCharacteristics result;
    result.riseTime_s = withinWindow(found.riseTime_s, response, response.resolution_s);
    result.overshoot_percent = overshoot(response);
    result.settlingTime_s = withinWindow(found.settlingTime_s, response, 0.0);
    const bool isKnown = found.riseTime_s || found.within5percent_Hz || found.minus3dB_Hz;
    result.within5percent_Hz = bandEdge(response, found.within5percent_Hz, isKnown);
    result.within10percent_Hz = bandEdge(response, found.within10percent_Hz, isKnown);
    result.minus3dB_Hz = bandEdge(response, found.minus3dB_Hz, isKnown);
    return result;
}

StatedValue statedRise(const WindowedResponse &response)
{
    if (!isNumber(response.riseTime_s))
        return {};
    return riseWithin(
        *response.riseTime_s, response.sampleRate_Hz > 0.0 ? 1.0 / response.sampleRate_Hz : 0.0);
}

std::optional<double> statedOvershoot_percent(const WindowedResponse &response)
{
    return statedRise(response).below ? std::nullopt : response.overshoot_percent;
}

} // namespace dyncal
