// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/model/homogeneity.h"

#include "core/base/constants.h"
#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/realization/model/second_order_shots.h"
#include "core/realization/model/shot_parts.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/draft_fit.h"
#include "core/realization/refinement/noise_basis.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/pole_uncertainty.h"
#include "core/realization/refinement/refinement.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

constexpr double kSmallestP = 1e-4; ///< smaller ones are printed with "<"

/// The poles of the model fitted to some of the shots alone: those that stand out there.
struct PartFit
{
    std::vector<std::size_t> series; ///< positions in the input
    std::vector<std::optional<Index>> place; ///< of every pole of the draft among those fitted
    std::optional<Refinement> refinement;
    NoiseBasis noise;

    bool has(Index pole) const
    {
        return refinement && place[static_cast<std::size_t>(pole)].has_value();
    }
    Index at(Index pole) const { return *place[static_cast<std::size_t>(pole)]; }
};

/// Energy over noise of a pole in one series, by the joint fit.
double energyOf(const ModelInput &input, const ModelDraft &draft, std::size_t r, Index pole)
{
    return energyOverNoise(input.series[r], draft.series[r], pole, sampleInterval_s(input));
}

/// Common input of the fits of all parts.
struct Source
{
    const ModelInput &input;
    const ModelDraft &draft;
    std::vector<RefinementRecord> records;
    std::optional<Index> main; ///< place of the main resonance in the draft
};

/// Poles that stand out in any of the series, or the main resonance alone.
std::vector<bool> wantedPoles(
    const Source &source, const std::vector<std::size_t> &series, bool mainOnly)
{
    std::vector<bool> wanted;
    for (Index i = 0; i < std::ssize(source.draft.poles_rad_s); ++i) {
        const bool isMain = source.main && (i == *source.main || i == *source.main + 1);
        const bool standsOut = std::any_of(series.begin(), series.end(),
            [&](std::size_t r) { return energyOf(source.input, source.draft, r, i) > kStandsOut; });
        wanted.push_back(mainOnly ? isMain : standsOut);
    }
    return wanted;
}

PartFit fitPoles(const Source &source, const std::vector<std::size_t> &series,
    const std::vector<bool> &wanted, const JobControl &control)
{
    PartFit part{series, {}, {}, {}};
    std::vector<std::complex<double>> startPoles_rad_s;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        part.place.emplace_back();
        if (wanted[i]) {
            part.place.back() = std::ssize(startPoles_rad_s);
            startPoles_rad_s.push_back(source.draft.poles_rad_s[i]);
        }
    }
    std::vector<RefinementRecord> records;
    std::vector<NoiseCovariance> noise;
    for (const std::size_t r : series) {
        records.push_back(source.records[r]);
        noise.push_back(source.input.series[r].fullRateNoise);
    }
    part.refinement
        = refinePoles(records, startPoles_rad_s, isStepTreatment(source.input.treatment), control);
    if (part.refinement)
        part.noise = allowForColour(records, noise, *part.refinement);
    return part;
}

/// Poles that only all shots together can separate cannot be fitted to one shot; then only the main
/// one is fitted, and the remaining residual is in its uncertainty.
PartFit fitPart(
    const Source &source, const std::vector<std::size_t> &series, const JobControl &control)
{
    PartFit part = fitPoles(source, series, wantedPoles(source, series, false), control);
    if (!part.refinement && source.main)
        part = fitPoles(source, series, wantedPoles(source, series, true), control);
    return part;
}

/// One fit for all shots of a level, from low to high.
std::vector<PartFit> fitLevels(
    const Source &source, const std::vector<PartFit> &shots, const JobControl &control)
{
    std::vector<PartFit> fits;
    for (const std::vector<std::size_t> &series : seriesByLevel(source.input))
        fits.push_back(
            series.size() == 1 ? shots[series.front()] : fitPart(source, series, control));
    return fits;
}

LevelPole describePart(const ModelInput &input, const PartFit &part, std::optional<Index> main)
{
    LevelPole result = partOfShots(input, part.series);
    if (!part.refinement)
        return result;
    if (main && part.has(*main)) {
        const PoleFigures figures = poleFigures(*part.refinement, part.at(*main));
        result.frequency_Hz = figures.frequency_Hz;
        result.u_frequency_Hz = figures.u_frequency_Hz;
        result.dampingRatio = figures.dampingRatio;
        result.u_dampingRatio = figures.u_dampingRatio;
    }
    result.coverageFactor = coverageFactor95(part.noise.dof);
    addPlateau(input, part.series, *part.refinement, result);
    return result;
}

std::optional<Index> mainPlace(const SensorModel &model)
{
    const Pole *main = mainPole(model.poles, model.series);
    if (!main)
        return std::nullopt;
    return static_cast<Index>(main - model.poles.data());
}

/// Sum of (theta_j - mean)^T V_j^-1 (theta_j - mean) over the shots, theta the real parameters of
/// one pole in each shot, V_j their covariance, the mean weighted with V_j^-1.
double disagreement(const std::vector<PartFit> &fits, Index pole, Index size, Index *dof)
{
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd weighted = Eigen::VectorXd::Zero(size);
    double squares = 0.0;
    Index shots = 0;
    std::complex<double> first; // differences from it: with the poles themselves
                                // all digits would cancel where noise is small
    for (const PartFit &fit : fits) {
        if (!fit.has(pole))
            continue;
        const Index at = fit.at(pole);
        const std::complex<double> fitted
            = fit.refinement->poles_rad_s[static_cast<std::size_t>(at)];
        first = shots == 0 ? fitted : first;
        const std::complex<double> s = fitted - first;
        const Eigen::VectorXd theta = Eigen::Vector2d(s.real(), s.imag()).head(size);
        const Eigen::MatrixXd V = fit.refinement->covariance.block(at, at, size, size);
        const Eigen::LDLT<Eigen::MatrixXd> solver(V);
        const Eigen::VectorXd share = solver.solve(theta);
        information += solver.solve(Eigen::MatrixXd::Identity(size, size));
        weighted += share;
        squares += theta.dot(share);
        ++shots;
    }
    *dof = std::max<Index>(0, (shots - 1) * size);
    return *dof == 0 ? 0.0 : squares - weighted.dot(information.ldlt().solve(weighted));
}

/// Uncertainty of a pole that the shots do not share, from their scatter.
void useScatter(const std::vector<PartFit> &fits, Index at, Pole &pole)
{
    std::vector<double> frequency;
    std::vector<double> u_frequency;
    std::vector<double> damping;
    std::vector<double> u_damping;
    for (const PartFit &fit : fits) {
        if (!fit.has(at))
            continue;
        const PoleFigures figures = poleFigures(*fit.refinement, fit.at(at));
        frequency.push_back(figures.frequency_Hz);
        u_frequency.push_back(figures.u_frequency_Hz);
        damping.push_back(figures.dampingRatio);
        u_damping.push_back(figures.u_dampingRatio);
    }
    pole.flags.push_back(kShotsDisagreeFlag);
    if (frequency.size() < 2) { // one shot has no scatter
        pole.u_frequency_Hz = kUnknown;
        pole.u_dampingRatio = kUnknown;
        pole.coverageFactor = kUnknown;
        return;
    }
    const double k = coverageFactor95(static_cast<double>(frequency.size() - 1));
    // Never narrower than the noise alone makes the interval.
    const double noise = pole.coverageFactor / k;
    pole.u_frequency_Hz
        = std::max(noise * pole.u_frequency_Hz, betweenShots(frequency, u_frequency));
    if (pole.s_rad_s.imag() != 0.0)
        pole.u_dampingRatio
            = std::max(noise * pole.u_dampingRatio, betweenShots(damping, u_damping));
    pole.coverageFactor = k;
}

struct PoleTest
{
    std::size_t pole = 0;
    double statistic = 0.0;
    double dof = 0.0;
    double probability = 1.0;
};

/// Statistic for a pole that rings in one shot and is missing in another: the missing energy over
/// noise. Missing: with the shape of the other shots it would have ten times the energy that stands
/// out, but it does not stand out, or has less than a thousandth of that energy (a remainder of
/// fitting poles that do not quite fit that shot).
double missing(const ModelInput &input, const ModelDraft &draft, Index pole)
{
    constexpr double kClear = 10.0;
    constexpr double kTrace = 1e-3;
    const auto clarity = [&](std::size_t r) { // of the step
        return std::pow(draft.series[r].constant / input.series[r].noiseSd, 2);
    };
    double largest = 0.0; // energy for a clarity of 1
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        if (clarity(r) > 0.0)
            largest = std::max(largest, energyOf(input, draft, r, pole) / clarity(r));
    }
    double statistic = 0.0;
    for (std::size_t r = 0; r < input.series.size(); ++r) {
        const double expected = largest * clarity(r);
        const double found = energyOf(input, draft, r, pole);
        const bool isAbsent = found <= std::max(kStandsOut, kTrace * expected);
        if (isAbsent && expected > kClear * kStandsOut && std::isfinite(expected))
            statistic = std::max(statistic, std::pow(std::sqrt(expected) - std::sqrt(found), 2));
    }
    return statistic;
}

std::vector<PoleTest> testPoles(const ModelInput &input, const ModelDraft &draft,
    const std::vector<PartFit> &fits, const std::vector<Pole> &poles)
{
    std::vector<PoleTest> tests;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const Pole &pole = poles[i];
        if (pole.poleClass != PoleClass::Sensor || pole.s_rad_s.imag() < 0.0)
            continue;
        const Index size = pole.s_rad_s.imag() > 0.0 ? 2 : 1;
        Index dof = 0;
        const double statistic
            = std::max(disagreement(fits, static_cast<Index>(i), size, &dof), 0.0); // NaN stays NaN
        if (!std::isfinite(statistic))
            continue;
        const double degrees = static_cast<double>(dof);
        PoleTest test{i, statistic, degrees, dof > 0 ? chiSquareSurvival(statistic, degrees) : 1.0};
        if (const double absent = missing(input, draft, static_cast<Index>(i)); absent > statistic)
            test = {i, absent, 2.0, chiSquareSurvival(absent, 2.0)};
        if (test.dof > 0.0)
            tests.push_back(test);
    }
    return tests;
}

void judgeShared(const ModelInput &input, const ModelDraft &draft, const std::vector<PartFit> &fits,
    ModelAssessment &assessment)
{
    const std::vector<PoleTest> tests = testPoles(input, draft, fits, assessment.poles);
    if (tests.empty())
        return;
    // Several poles are several chances to fail: each is tested at its share of 1 %.
    const double share = static_cast<double>(tests.size());
    const PoleTest &worst = *std::min_element(tests.begin(), tests.end(),
        [](const PoleTest &a, const PoleTest &b) { return a.probability < b.probability; });
    const double probability = std::min(1.0, share * worst.probability);
    assessment.homogeneity = Homogeneity{assessment.poles[worst.pole].frequency_Hz, worst.statistic,
        worst.dof, probability, probability >= kSharedAtLeast};
    for (const PoleTest &test : tests) {
        if (share * test.probability >= kSharedAtLeast)
            continue;
        Pole &upper = assessment.poles[test.pole];
        useScatter(fits, static_cast<Index>(test.pole), upper);
        if (upper.s_rad_s.imag() > 0.0) {
            Pole &lower = assessment.poles[test.pole + 1];
            lower.u_frequency_Hz = upper.u_frequency_Hz;
            lower.u_dampingRatio = upper.u_dampingRatio;
            lower.coverageFactor = upper.coverageFactor;
            lower.flags.push_back(kShotsDisagreeFlag);
        }
    }
}

} // namespace

void compareShots(const ModelInput &input, const SensorModel &model, ModelAssessment &assessment,
    const JobControl &control)
{
    const ModelDraft &draft = model.draft;
    if (!draft.refinement || input.series.front().shot == 0)
        return;
    if (model.secondOrder)
        return compareSecondOrderShots(input, model, assessment, control);
    const Source source{input, draft, refinementRecords(input), mainPlace(model)};
    std::vector<PartFit> shots;
    for (std::size_t r = 0; r < input.series.size(); ++r)
        shots.push_back(fitPart(source, {r}, control));
    for (const PartFit &fit : shots)
        assessment.perShot.push_back(describePart(input, fit, source.main));
    for (const PartFit &fit : fitLevels(source, shots, control))
        assessment.perLevel.push_back(describePart(input, fit, source.main));
    if (shots.size() > 1)
        judgeShared(input, draft, shots, assessment);
}

Findings judgeShots(const ModelAssessment &assessment)
{
    if (!assessment.homogeneity || assessment.homogeneity->passed)
        return {};
    double lowest = std::numeric_limits<double>::infinity();
    double highest = 0.0;
    for (const LevelPole &shot : assessment.perShot) {
        if (std::isfinite(shot.frequency_Hz)) {
            lowest = std::min(lowest, shot.frequency_Hz);
            highest = std::max(highest, shot.frequency_Hz);
        }
    }
    const double p = assessment.homogeneity->probability;
    const std::string probability
        = p < kSmallestP ? "< " + numberText(100.0 * kSmallestP, 1) : numberText(100.0 * p, 2);
    const std::string pole = numberWithUnit(assessment.homogeneity->frequency_Hz, "Hz", 4);
    Message message{
        DYNCAL_TEXT("core",
            "The shots do not share the pole at %1 (their scatter would be chance in %2 % of cases; the limit is 1 %). Its uncertainty is the scatter between them; state one value per level."),
        {pole, probability}};
    if (highest > lowest)
        message = {
            DYNCAL_TEXT("core",
                "The shots do not share the pole at %1 (their scatter would be chance in %2 % of cases; the limit is 1 %); their main resonances lie at %3 to %4. Its uncertainty is the scatter between them; state one value per level."),
            {pole, probability, numberWithUnit(lowest, "Hz", 6), numberWithUnit(highest, "Hz", 6)}};
    return {{.id = "MOD-010",
        .severity = Severity::Caution,
        .message = std::move(message),
        .value = assessment.homogeneity->probability,
        .limit = kSharedAtLeast}};
}

} // namespace dyncal
