// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/certificate/certificate_sensitivity.h"

#include "core/base/number_text.h"
#include "core/certificate/certificate_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

ResultQuantity sensitivityQuantity(
    Message label, double value, const ReportedValue *reported, const ResponseResult &response)
{
    if (!reported || !reported->u)
        return {std::move(label), value, kUnknown, kUnknown, response.sensitivityUnit,
            whyNoResult(reported)};
    return {std::move(label), value, *reported->u, reported->k, response.sensitivityUnit,
        whyNoResult(reported), reported->leastExpanded};
}

std::vector<ResultQuantity> levelQuantities(const CalibrationResults &results)
{
    std::vector<ResultQuantity> quantities;
    const std::vector<SensitivityMean> &levels = results.response->summary.perLevel;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        quantities.push_back(sensitivityQuantity(levelLabel(levels[i].level), levels[i].value,
            levelOf(results.uncertainty.get(), i), *results.response));
        quantities.back().drawnAs = "sensitivity.per_level[" + std::to_string(i) + "]";
    }
    return quantities;
}

Message meanLabel(const ResponseResult *response)
{
    if (response && response->shots.size() == 1)
        return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step"), {}};
    if (!response || response->summary.shotsAgree)
        return {DYNCAL_TEXT("core", "Sensitivity at the onset of the step, mean of the shots"), {}};
    return {DYNCAL_TEXT("core",
                "Sensitivity at the onset of the step, mean of the shots, which do not agree"),
        {}};
}

ResultQuantity meanQuantity(const CalibrationResults &results)
{
    const ResponseResult *response = results.response.get();
    if (!response || !response->sensitivity || !std::isfinite(*response->sensitivity)) {
        ResultQuantity none;
        none.label = meanLabel(response);
        none.otherwise = notDetermined(response);
        return none;
    }
    const bool isReported = results.uncertainty && results.uncertainty->sensitivity;
    return sensitivityQuantity(meanLabel(response), *response->sensitivity,
        isReported ? &*results.uncertainty->sensitivity : nullptr, *response);
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

std::vector<ResultQuantity> sensitivityQuantities(const CalibrationResults &results)
{
    std::vector<ResultQuantity> quantities = isByLevel(results.response.get())
        ? levelQuantities(results)
        : std::vector{meanQuantity(results)};
    for (ResultQuantity &quantity : quantities)
        quantity.of = "sensitivity";
    return quantities;
}

void addSensitivityDetails(const CalibrationResults &results, CertificateSection &section)
{
    const ResponseResult *response = results.response.get();
    if (!response)
        return;
    if (isByLevel(response))
        section.paragraphs.push_back(
            {DYNCAL_TEXT("core",
                 "The shots do not agree: the sensitivity is stated for each level, and no mean of all shots."),
                {}});
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
    if (!std::isfinite(u))
        return printed(entry->sensitivity, entry->unit, none);
    const double k = printedCoverage(kOfShot(results.uncertainty.get(), at));
    const double least = results.uncertainty->ofShots[at].leastExpanded;
    return printedWithUncertainty(*entry->sensitivity, printableU(u, k, least), entry->unit, k);
}

} // namespace dyncal
