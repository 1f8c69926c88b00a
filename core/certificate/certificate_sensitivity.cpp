// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_sensitivity.h"

#include "core/base/number_text.h"
#include "core/certificate/certificate_words.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

Message notDetermined(const ResponseResult *response)
{
    const bool hasStep = response
        && std::ranges::any_of(
            response->shots, [](const ShotSensitivity &shot) { return shot.step_Pa.has_value(); });
    return hasStep ? Message{DYNCAL_TEXT("core", "not determined (no level at the onset)"), {}}
                   : Message{DYNCAL_TEXT("core", "not determined (no pressure step)"), {}};
}

/// A mean with its complete uncertainty.
Message textOf(double value, const ReportedValue *reported, const ResponseResult &response)
{
    if (!reported || !reported->u)
        return printed(value, response.sensitivityUnit, notDetermined(&response));
    return printedWithUncertainty(
        value, *reported->u, response.sensitivityUnit, printedCoverage(reported->k));
}

Message meanText(const CalibrationResults &results)
{
    const ResponseResult *response = results.response.get();
    if (!response || !response->sensitivity)
        return notDetermined(response);
    const bool reported = results.uncertainty && results.uncertainty->sensitivity;
    return textOf(
        *response->sensitivity, reported ? &*results.uncertainty->sensitivity : nullptr, *response);
}

/// Where the shots disagree a mean over levels says nothing: each level stands for itself.
bool isByLevel(const ResponseResult *response)
{
    return response && !response->summary.shotsAgree && response->summary.perLevel.size() > 1;
}

Message levelLabel(ShotLevel level)
{
    if (level == ShotLevel::Low)
        return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step, low level"), {}};
    if (level == ShotLevel::Medium)
        return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step, medium level"), {}};
    return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step, high level"), {}};
}

void addLevels(const CalibrationResults &results, CertificateSection &section)
{
    const std::vector<SensitivityMean> &levels = results.response->summary.perLevel;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const ReportedValue *reported = levelOf(results.uncertainty.get(), i);
        section.fields.push_back({"sensitivity_level", levelLabel(levels[i].level),
            textOf(levels[i].value, reported, *results.response), false});
    }
}

Message meanLabel(const ResponseResult *response)
{
    if (response && response->shots.size() == 1)
        return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step"), {}};
    if (!response || response->summary.shotsAgree || isByLevel(response))
        return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step, mean of the shots"), {}};
    return {DYNCAL_TEXT("core",
                "Sensitivity at the onset of the step, mean of the shots, which do not agree"),
        {}};
}

void addMean(const CalibrationResults &results, CertificateSection &section)
{
    const ResponseResult *response = results.response.get();
    const Message value = isByLevel(response)
        ? Message{DYNCAL_TEXT("core", "one value per level (the shots do not agree)"), {}}
        : meanText(results);
    section.fields.push_back({"sensitivity", meanLabel(response), value, false});
}

void addTrend(const SensitivitySummary &summary, CertificateSection &section)
{
    constexpr double kPercentPerMegapascal = 1e8;
    if (!summary.linearity_per_Pa || !summary.uLinearity_per_Pa)
        return;
    section.fields.push_back(
        {"linearity", {DYNCAL_TEXT("core", "Change of the sensitivity with the step"), {}},
            printedWithUncertainty(kPercentPerMegapascal * *summary.linearity_per_Pa,
                kPercentPerMegapascal * *summary.uLinearity_per_Pa, "%/MPa"),
            false});
}

void addDrift(const ResponseResult &response, CertificateSection &section)
{
    for (const ShotDrift &drift : response.drift.shots)
        section.fields.push_back({"drift",
            {DYNCAL_TEXT("core",
                 "Drift of shot %1 behind the step, from the onset to %2 after it (no part of the sensitivity)"),
                {std::to_string(drift.shot), numberWithUnit(drift.at_s, "s", 3)}},
            printedWithUncertainty(100.0 * drift.relative, 100.0 * drift.u, "%"), false});
}

} // namespace

void addSensitivity(const CalibrationResults &results, CertificateSection &section)
{
    const ResponseResult *response = results.response.get();
    addMean(results, section);
    if (!response)
        return;
    if (isByLevel(response))
        addLevels(results, section);
    addTrend(response->summary, section);
    addDrift(*response, section);
}

Message shotSensitivityText(const CalibrationResults &results, Index shot)
{
    const Message none{DYNCAL_TEXT("core", "not determined"), {}};
    if (!results.response)
        return none;
    const auto entry = std::ranges::find(results.response->shots, shot, &ShotSensitivity::shot);
    if (entry == results.response->shots.end() || !entry->sensitivity)
        return none;
    const auto at = static_cast<std::size_t>(entry - results.response->shots.begin());
    const double u = uOfShot(results.uncertainty.get(), at);
    return std::isfinite(u)
        ? printedWithUncertainty(*entry->sensitivity, u, entry->unit, printedCoverage(entry->k))
        : printed(entry->sensitivity, entry->unit, none);
}

} // namespace dyncal
