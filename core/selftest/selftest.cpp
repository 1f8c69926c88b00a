// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/selftest.h"

#include "core/base/number_text.h"
#include "core/selftest/checks_in_noise.h"
#include "core/selftest/checks_of_correction.h"
#include "core/selftest/checks_of_division.h"
#include "core/selftest/checks_of_draws.h"
#include "core/selftest/checks_of_realization.h"
#include "core/selftest/checks_of_records.h"
#include "core/selftest/checks_of_response.h"
#include "core/selftest/checks_of_shock.h"
#include "core/selftest/checks_of_signals.h"
#include "core/selftest/checks_of_uncertainty.h"
#include "core/selftest/checks_of_ways.h"
#include "core/selftest/coverage_study.h"
#include "core/selftest/step_words.h"

#include "core/pipeline/stage_table.h"

#include <algorithm>
#include <string_view>

namespace dyncal {
namespace {

constexpr Index kMostCalibrations = 10000;
constexpr double kShareOfChecks = 0.2; ///< of the time, where there is a coverage study

/// Place of a step in the method; what is checked beside its stages comes last.
Index placeOf(std::string_view step)
{
    const std::optional<StageId> stage = stageOfMethod(step);
    return stage ? static_cast<Index>(*stage) : kStageCount;
}

Result<std::vector<SelfCheck>> checksCarriedOut(const JobControl &control)
{
    const std::vector<CheckSpec> specs = allChecks();
    std::vector<SelfCheck> checks;
    for (const CheckSpec &spec : specs) {
        if (control.stopRequested())
            return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
        checks.push_back(carriedOut(spec));
        control.report(static_cast<double>(checks.size()) / static_cast<double>(specs.size()));
    }
    return checks;
}

Result<void> checkSettings(const SelfTestSettings &settings)
{
    if (settings.calibrations < 0 || settings.calibrations > kMostCalibrations)
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT(
                 "core", "The coverage study is to have %1 calibrations; it takes 0 to %2."),
                {std::to_string(settings.calibrations), std::to_string(kMostCalibrations)}});
    if (settings.calibrations == 0 || settings.calibrations >= leastCalibrations())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The coverage study is to have %1 calibrations, but with less than %2 it cannot fail: even errors of 0 would be no sign of a wrong u; take 0 (no study) or %2 to %3."),
            {std::to_string(settings.calibrations), std::to_string(leastCalibrations()),
                std::to_string(kMostCalibrations)}});
}

} // namespace

Index SelfTestReport::deviations() const
{
    return std::ranges::count_if(checks, [](const SelfCheck &check) { return !check.holds(); });
}

const SelfCheck *SelfTestReport::firstDeviation() const
{
    const auto found
        = std::ranges::find_if(checks, [](const SelfCheck &check) { return !check.holds(); });
    return found == checks.end() ? nullptr : &*found;
}

Message SelfTestReport::verdict() const
{
    const std::string all = std::to_string(checks.size());
    const SelfCheck *first = firstDeviation();
    if (!first)
        return {
            DYNCAL_TEXT("core", "All %1 checks hold: this installation computes what is known."),
            {all}};
    return {
        DYNCAL_TEXT("core",
            "%1 of %2 checks deviate, the first in the step \"%M1\" (%M2: expected %3, found %4); do not calibrate with this installation before it is explained."),
        {std::to_string(deviations()), all, numberText(first->expected, 10),
            numberText(first->found, 10)},
        {stepWords(first->step), first->name}};
}

std::vector<CheckSpec> allChecks()
{
    std::vector<CheckSpec> all;
    for (const auto make : {checksOfRecords, checksOfSignals, checksOfRealization, checksInNoise,
             checksOfShock, checksOfResponse, checksOfDivision, checksOfUncertainty, checksOfWays,
             checksOfDraws, checksOfCorrection})
        for (CheckSpec &spec : make())
            all.push_back(std::move(spec));
    std::ranges::stable_sort(all, {}, [](const CheckSpec &spec) { return placeOf(spec.step); });
    return all;
}

Result<SelfTestReport> runSelfTest(const SelfTestSettings &settings, const JobControl &control)
{
    if (const Result<void> checked = checkSettings(settings); !checked)
        return tl::unexpected<Error>(checked.error());
    const double share = settings.calibrations > 0 ? kShareOfChecks : 1.0;
    auto checks = checksCarriedOut(control.between(0.0, share));
    if (!checks)
        return tl::unexpected<Error>(checks.error());
    SelfTestReport report{std::move(*checks), methodVersions(),
        thisInstallation(settings.libraries), settings.calibrations};
    if (settings.calibrations == 0)
        return report;
    const auto study = coverageStudy(settings.calibrations, control.between(share, 1.0));
    if (study.empty())
        return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
    report.checks.insert(report.checks.end(), study.begin(), study.end());
    return report;
}

} // namespace dyncal
