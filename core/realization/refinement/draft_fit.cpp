// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/draft_fit.h"

#include "core/realization/exponentials/pole_mapping.h"
#include "core/realization/input/left_out.h"
#include "core/realization/refinement/aperiodic_start.h"
#include "core/realization/refinement/coloured_covariance.h"
#include "core/realization/refinement/fit_residual.h"
#include "core/realization/refinement/pole_refinement.h"
#include "core/realization/refinement/refinement_problem.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

/// Pairs stay together: both have the same |s|, the upper half comes first.
void sortByFrequency(std::vector<std::complex<double>> &poles)
{
    std::stable_sort(poles.begin(), poles.end(), [](const auto &a, const auto &b) {
        const double left = std::abs(a);
        const double right = std::abs(b);
        return left != right ? left < right : a.imag() > b.imag();
    });
}

bool canRefine(const ModelInput &input, const std::vector<std::complex<double>> &poles)
{
    return !isThesisMode(input) && !poles.empty()
        && static_cast<Index>(poles.size()) <= kLargestRefined
        && std::all_of(poles.begin(), poles.end(), [&](const std::complex<double> &z) {
               const bool isReal = z.imag() == 0.0;
               if (isReal && z.real() <= 0.0)
                   return false;
               return std::abs(z) < 1.0
                   || (isReal
                       && isNearlyRamp(std::log(z.real()) * static_cast<double>(input.samples)));
           });
}

/// Leaves out the sample that the start was found by. It is the first beyond a threshold, so its
/// noise points the way of the step, in every shot; that of those behind it does not depend on
/// that.
void leaveOutTheStart(RefinementRecord &record)
{
    record.used = usedRanges(record);
    if (SampleRange &first = record.used.front(); first.begin == 0 && first.size() > 1)
        first.begin = 1;
}

} // namespace

ExponentialSum atStart(const ModelSeries &series,
    const std::vector<std::complex<double>> &poles_rad_s, const AmplitudeFit &fit)
{
    ExponentialSum sum;
    sum.constant = fit.constant;
    sum.poles_rad_s = Eigen::Map<const Eigen::VectorXcd>(
        poles_rad_s.data(), static_cast<Index>(poles_rad_s.size()));
    sum.amplitudes = fit.amplitudes;
    for (Index i = 0; i < sum.amplitudes.size(); ++i) {
        const std::complex<double> s = sum.poles_rad_s[i];
        sum.amplitudes[i] *= std::exp(-s * series.first_s) / series.filter.gain(s);
    }
    return sum;
}

ModelDraft linearDraft(const ModelInput &input, const std::vector<std::complex<double>> &poles)
{
    ModelDraft draft;
    for (const std::complex<double> &z : poles)
        draft.poles_rad_s.push_back(continuousPole(z, sampleInterval_s(input)));
    sortByFrequency(draft.poles_rad_s);
    draft.realizedPoles_rad_s = draft.poles_rad_s;
    const auto sorted = discretePoles(draft.poles_rad_s, sampleInterval_s(input));
    Eigen::MatrixXd records(input.samples, static_cast<Index>(input.series.size()));
    for (Index r = 0; r < records.cols(); ++r) {
        const ModelSeries &series = input.series[static_cast<std::size_t>(r)];
        records.col(r) = series.y;
        if (series.correction.size() > 0)
            records.col(r) += series.correction;
    }
    const auto fits = fitAmplitudesTogether(records, sorted, isStepTreatment(input.treatment));
    for (std::size_t r = 0; r < fits.size(); ++r) {
        draft.series.push_back(atStart(input.series[r], draft.poles_rad_s, fits[r]));
        draft.nuisance.push_back(input.series[r].nuisance);
    }
    return draft;
}

std::vector<RefinementRecord> refinementRecords(const ModelInput &input)
{
    std::vector<RefinementRecord> records;
    for (const ModelSeries &series : input.series) {
        constexpr double kNoiseFree = 1e-9; // of the record's range: keeps weights finite
        const double range = series.fullRate.maxCoeff() - series.fullRate.minCoeff();
        const double noise = std::max(series.fullRateNoiseSd, kNoiseFree * range);
        records.push_back({series.fullRate, series.fullRate_Hz, 1.0 / noise, series.nuisance,
            usedSamples(series)});
        leaveOutTheStart(records.back());
    }
    return records;
}

std::vector<RefinementRecord> refinementRecords(const ModelInput &input, const ModelDraft &draft)
{
    std::vector<RefinementRecord> records = refinementRecords(input);
    for (std::size_t r = 0; r < records.size(); ++r)
        records[r].nuisance = draft.nuisance[r];
    return records;
}

std::vector<NoiseCovariance> noiseBeforeStart(const ModelInput &input)
{
    std::vector<NoiseCovariance> noise;
    for (const ModelSeries &series : input.series)
        noise.push_back(series.fullRateNoise);
    return noise;
}

void refineDraft(const ModelInput &input, ModelDraft &draft, const JobControl &control)
{
    const std::vector<RefinementRecord> records = refinementRecords(input);
    if (canRefine(input, discretePoles(draft.poles_rad_s, sampleInterval_s(input))))
        draft.refinement
            = refinePoles(records, draft.poles_rad_s, isStepTreatment(input.treatment), control);
    if (!draft.refinement)
        draft.refinement = refineAperiodic(input, draft, records, control);
    if (!draft.refinement)
        return;
    draft.noise = allowForColour(records, noiseBeforeStart(input), *draft.refinement);
    draft.poles_rad_s = draft.refinement->poles_rad_s;
    draft.series = draft.refinement->records;
    draft.nuisance = draft.refinement->nuisance;
}

} // namespace dyncal
