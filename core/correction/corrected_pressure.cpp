// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/corrected_pressure.h"

#include "core/base/distributions.h"
#include "core/base/number_text.h"
#include "core/base/svd.h"
#include "core/correction/fir_passage.h"
#include "core/signal/fft.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace dyncal {
namespace {

constexpr double kNoiseOfLargest = 3.0; ///< sigmas that the largest of a few samples seldom exceeds
constexpr double kTapsToGrid = 4.0;

/// Sum of squares of what the errors make of each sample, and of their squares over dof.
struct ResponseShare
{
    Eigen::VectorXd variance;
    Eigen::VectorXd squareOverDof;
};

/// The columns of tapErrors as few filters and what each column takes of them: errors that the fit
/// of a smooth ratio has gone through span few directions.
struct FewFilters
{
    Eigen::MatrixXd taps; ///< a column each
    Eigen::MatrixXd shares; ///< filters x errors
};

FewFilters fewFilters(const Eigen::MatrixXd &tapErrors)
{
    constexpr double kNegligible = 1e-10;
    if (tapErrors.cols() == 0)
        return {Eigen::MatrixXd(tapErrors.rows(), 0), Eigen::MatrixXd(0, 0)};
    const LeftSvd svd = leftSvd(tapErrors);
    const Index rank = (svd.singularValues.array() > kNegligible * svd.singularValues[0]).count();
    const Eigen::MatrixXd taps = svd.left.leftCols(rank);
    return {taps, taps.transpose() * tapErrors};
}

/// Of no use once it was asked to stop.
ResponseShare responseShare(
    const FirPassage &passage, const CorrectionFilter &filter, const JobControl &control)
{
    constexpr Index kSamplesAtOnce = 4096;
    const FewFilters few = fewFilters(filter.tapErrors);
    Eigen::MatrixXd passed(passage.size(), few.taps.cols());
    for (Index r = 0; r < passed.cols() && !control.stopRequested(); ++r) {
        passed.col(r) = passage.through(few.taps.col(r));
        control.report(static_cast<double>(r + 1) / static_cast<double>(passed.cols()));
    }
    ResponseShare share{Eigen::VectorXd(passed.rows()), Eigen::VectorXd(passed.rows())};
    const Eigen::VectorXd overDof = filter.errorDof.cwiseInverse();
    for (Index first = 0; first < passed.rows() && !control.stopRequested();
         first += kSamplesAtOnce) {
        const Index count = std::min(kSamplesAtOnce, passed.rows() - first);
        const Eigen::ArrayXXd squares
            = (passed.middleRows(first, count) * few.shares).array().square();
        share.variance.segment(first, count) = squares.rowwise().sum();
        share.squareOverDof.segment(first, count) = squares.square().matrix() * overDof;
    }
    return share;
}

/// Variance of noise behind a filter, and its degrees of freedom.
struct FilteredNoise
{
    double variance = 0.0;
    double squareOverDof = 0.0;
};

FilteredNoise filteredNoise(const NoiseDensity &noise, double rate_Hz, const Eigen::VectorXd &taps)
{
    const Index n
        = fastFftLength(static_cast<Index>(kTapsToGrid * static_cast<double>(taps.size())));
    const Eigen::VectorXd gain = RealFft(n).forward(taps).cwiseAbs2();
    double sum = 0.0;
    double overDof = 0.0;
    for (Index i = 0; i < gain.size(); ++i) {
        const bool isAlone = i == 0 || 2 * i == n;
        const NoiseDensity::Value density = noise.at(
            static_cast<double>(std::max<Index>(i, 1)) * rate_Hz / static_cast<double>(n));
        const double part
            = (isAlone ? 1.0 : 2.0) * gain[i] * density.variance / static_cast<double>(n);
        sum += part;
        overDof += part / density.dof;
    }
    return {sum, sum * overDof};
}

/// The largest of `values` within `reach` samples of each.
Eigen::VectorXd largestAround(const Eigen::VectorXd &values, Index reach)
{
    Eigen::VectorXd largest(values.size());
    std::vector<Index> falling; // places of values that may still be the largest
    std::size_t first = 0;
    Index next = 0;
    for (Index i = 0; i < values.size(); ++i) {
        for (; next < std::min(i + reach + 1, values.size()); ++next) {
            while (falling.size() > first && values[falling.back()] <= values[next])
                falling.pop_back();
            falling.push_back(next);
        }
        while (falling[first] < i - reach)
            ++first;
        largest[i] = values[falling[first]];
    }
    return largest;
}

/// Takes the upper half of the band out of a corrected pressure: 1 less a low-pass.
Result<CorrectionFilter> lowerHalf(const CorrectionFilter &filter)
{
    constexpr double kFrom = 0.25;
    constexpr double kTo = 0.75;
    KnownResponse one;
    one.knot_Hz = Eigen::VectorXd::Zero(1);
    one.knot_Hz[0] = kFrom * filter.lowPass.band_Hz;
    one.atKnots = Eigen::VectorXcd::Ones(1);
    one.validTo_Hz = filter.rate_Hz;
    return designCorrection(one, filter.rate_Hz,
        {kFrom * filter.lowPass.band_Hz, kTo * filter.lowPass.band_Hz, {}, LowPassKind::Gaussian});
}

/// The taps of what is left above `lower`.
Eigen::VectorXd upperTaps(const CorrectionFilter &lower)
{
    Eigen::VectorXd taps = -lower.taps;
    taps[lower.delaySamples] += 1.0;
    return taps;
}

Eigen::VectorXd convolved(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
{
    const Index n = a.size() + b.size() - 1;
    const RealFft fft(fastFftLength(n));
    return fft.inverse(fft.forward(a).cwiseProduct(fft.forward(b))).head(n);
}

Eigen::VectorXd boundOf(const RecordedStretch &stretch, const NoiseDensity &noise,
    const CorrectionFilter &filter, const CorrectionFilter &lower)
{
    const Eigen::VectorXd taps = convolved(filter.taps, upperTaps(lower));
    const Eigen::VectorXd upper = FirPassage(stretch.values, taps.size()).through(taps).cwiseAbs();
    const double variance = filteredNoise(noise, filter.rate_Hz, taps).variance;
    const auto reach = static_cast<Index>(std::ceil(filter.rate_Hz / filter.lowPass.band_Hz));
    return (
        largestAround(upper, reach).array().square() - kNoiseOfLargest * kNoiseOfLargest * variance)
        .max(0.0)
        .sqrt();
}

/// Student's factors; whole degrees of freedom, rounded down (GUM G.4.1), are looked up once.
class CoverageFactors
{
public:
    double of(double dof)
    {
        constexpr double kManyDof = 1e4;
        const double whole = dof < kManyDof ? std::max(1.0, std::floor(dof))
                                            : std::numeric_limits<double>::infinity();
        const auto [at, isNew] = m_known.try_emplace(whole, 0.0);
        if (isNew)
            at->second = studentQuantile(0.5 * (1.0 + kCoverageOfPressure), whole);
        return at->second;
    }

private:
    std::map<double, double> m_known;
};

void combine(CorrectedPressure &result, const ResponseShare &share, const FilteredNoise &noise)
{
    result.u_response_Pa = share.variance.cwiseSqrt();
    const Eigen::VectorXd variance = share.variance.array() + result.u_noise_Pa * result.u_noise_Pa
        + result.bound_Pa.array().square() / 3.0;
    result.u_Pa = variance.cwiseSqrt();
    result.k.resize(variance.size());
    CoverageFactors factors;
    for (Index i = 0; i < variance.size(); ++i)
        result.k[i] = factors.of(
            variance[i] * variance[i] / (share.squareOverDof[i] + noise.squareOverDof));
}

Result<void> checkStretch(
    const RecordedStretch &stretch, const CorrectionFilter &filter, Index needed)
{
    if (!stretch.values.allFinite())
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "The recording has samples that are no numbers in the stretch to be corrected; choose another stretch (--window)."),
                {}});
    if (stretch.values.size() >= needed)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The stretch to be corrected has %1 samples, but this filter needs %2 at %3; take a longer one (--window) or a wider transition (--edge)."),
            {std::to_string(stretch.values.size()), std::to_string(needed),
                numberWithUnit(filter.rate_Hz, "Hz")}});
}

} // namespace

Result<CorrectedPressure> correctedPressure(const RecordedStretch &stretch,
    const NoiseDensity &noise, const CorrectionFilter &filter, std::optional<double> beyond_Pa,
    const JobControl &control)
{
    const Result<CorrectionFilter> lower = lowerHalf(filter);
    if (!lower)
        return tl::unexpected<Error>(lower.error());
    const Index behind = lower->taps.size() - 1 - lower->delaySamples;
    const Index needed = filter.taps.size() + lower->taps.size();
    if (const Result<void> checked = checkStretch(stretch, filter, needed); !checked)
        return tl::unexpected<Error>(checked.error());
    // The bound needs more samples on both sides than the pressure: both are stated where it is.
    const Eigen::VectorXd inner
        = stretch.values.segment(behind, stretch.values.size() - lower->taps.size() + 1);
    const FirPassage passage(inner, filter.taps.size());
    const FilteredNoise ofNoise = filteredNoise(noise, filter.rate_Hz, filter.taps);
    CorrectedPressure result;
    result.rate_Hz = filter.rate_Hz;
    result.time_s = stretch.time_s
        + static_cast<double>(behind + filter.taps.size() - 1 - filter.delaySamples)
            / filter.rate_Hz;
    result.pressure_Pa = passage.through(filter.taps);
    result.u_noise_Pa
        = std::sqrt(ofNoise.variance + noise.ofBaseline() * filter.gain() * filter.gain());
    result.bound_Pa = beyond_Pa ? Eigen::VectorXd::Constant(passage.size(), *beyond_Pa)
                                : boundOf(stretch, noise, filter, *lower);
    const ResponseShare share = responseShare(passage, filter, control);
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Cancelled."), {}});
    combine(result, share, ofNoise);
    return result;
}

} // namespace dyncal
