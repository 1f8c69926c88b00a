// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/monte_carlo/row_draws.h"

#include "core/base/input_draws.h"
#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/portable_random.h"
#include "core/monte_carlo/row_sources.h"
#include "core/realization/exponentials/front.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

namespace dyncal {
namespace {

constexpr double kSmallAgainstU = 0.1;

double rectangle(RandomStream &stream)
{
    return 2.0 * stream.nextUniform() - 1.0;
}

std::complex<double> within(RandomStream &stream, double bound)
{
    const double along = rectangle(stream);
    return bound * std::complex<double>(along, rectangle(stream));
}

/// 1 + relative error of the magnitude, turned by that of the phase.
std::complex<double> factorOf(RandomStream &stream, const RelativeError &error)
{
    if (error.along == 0.0 && error.across == 0.0)
        return 1.0;
    const double wider = 1.0 / std::sqrt(drawnVariance(stream, error.dof));
    const double along = error.along * wider * stream.nextNormal();
    return std::polar(1.0 + along, error.across * wider * stream.nextNormal());
}

/// A front that lasts longer than was divided out has taken more off |S|.
double frontShare(double assumed_s, double front_s, double frequency_Hz)
{
    const std::complex<double> jw(0.0, kTwoPi * frequency_Hz);
    return (frontFactor(assumed_s, jw) / frontFactor(front_s, jw)).real();
}

/// One trial of one row, over the value that is stated.
class RowTrial
{
public:
    RowTrial(const TrialPlan &plan, const TrialBlock &trials, const ResponseResult &response,
        const RowSources &of)
        : m_plan(plan)
        , m_trials(trials)
        , m_of(of)
        , m_assumedFront_s(response.front.duration_s)
        , m_withFront(!response.isByTransducer)
        , m_stream(streamOf("row at " + exactNumber(of.frequency_Hz) + " Hz"))
    {
    }

    std::complex<double> own(Index trial) const
    {
        RandomStream stream(m_plan.seed, trial, m_stream);
        const double wider = m_of.noise / std::sqrt(drawnVariance(stream, m_of.dofNoise));
        const double re = stream.nextNormal();
        std::complex<double> q = 1.0 + wider * std::complex<double>(re, stream.nextNormal());
        q += within(stream, m_of.boundEnd);
        q += within(stream, m_of.boundAlias);
        q *= std::polar(1.0, m_of.onset_rad * stream.nextNormal());
        q *= factorOf(stream, m_of.reference);
        q /= factorOf(stream, m_of.chain);
        q /= 1.0 + m_of.drift * m_trials.drift[trial];
        if (m_withFront)
            q *= frontShare(m_assumedFront_s, m_trials.front_s[trial], m_of.frequency_Hz);
        return q;
    }

private:
    const TrialPlan &m_plan;
    const TrialBlock &m_trials;
    const RowSources &m_of;
    double m_assumedFront_s;
    bool m_withFront;
    Index m_stream;
};

void addCovariance(const Eigen::VectorXcd &values, DrawnRow &row)
{
    const Eigen::ArrayXcd rest = values.array() - values.mean();
    const double n = static_cast<double>(values.size() - 1);
    row.varRe = rest.real().square().sum() / n;
    row.varIm = rest.imag().square().sum() / n;
    row.covReIm = (rest.real() * rest.imag()).sum() / n;
}

DrawnQuantity drawnOf(
    const Eigen::VectorXd &values, const ReportedValue &reported, const DrawnIntervals &intervals)
{
    DrawnQuantity drawn
        = drawnQuantity(values, reported.value, intervals.coverage, intervals.comparisons);
    leaveOutMoments(leastDofOf(reported.lines), drawn);
    return drawn;
}

DrawnQuantity drawnPhase(
    const Eigen::VectorXcd &ratios, const ReportedValue &reported, const DrawnIntervals &intervals)
{
    Eigen::VectorXd phase_rad(ratios.size());
    for (Index i = 0; i < ratios.size(); ++i)
        phase_rad[i] = reported.value + std::arg(ratios[i]);
    return drawnOf(phase_rad, reported, intervals);
}

/// Maker of all rows of one response.
class RowMaker
{
public:
    RowMaker(const TrialPlan &plan, const TrialBlock &trials, const ResponseResult &response,
        const RowUncertainty &rows, const DrawnIntervals &intervals)
        : m_plan(plan)
        , m_trials(trials)
        , m_response(response)
        , m_rows(rows)
        , m_intervals(intervals)
    {
    }

    DrawnRow make(Index i) const
    {
        DrawnRow row;
        row.frequency_Hz = m_response.frequency_Hz[i];
        if (!std::isfinite(m_response.magnitude[i]))
            return row;
        const ReportedValue phase = phaseOfRow(m_response, m_rows, i);
        row.withPhase = phase.u.has_value();
        row.withMagnitude = m_rows.isComplete();
        if (!row.withPhase && !row.withMagnitude)
            return row;
        const RowSources of = rowSources(m_response, phase, i);
        const Eigen::VectorXcd own = drawn(of);
        if (row.withPhase)
            addPhase(own, phase, row);
        if (row.withMagnitude)
            addMagnitude(own, i, row);
        if (hasVariance(row))
            addCovariance(of.value * shared(own), row);
        row.isBivariate = !(sizeOf(row, std::abs(of.value)) < kSmallAgainstU * std::abs(of.value));
        return row;
    }

private:
    static bool hasVariance(const DrawnRow &row)
    {
        return std::min(row.magnitude.leastDof, row.phase.leastDof) > 2.0;
    }

    /// u of the complex value; without a variance half of its U.
    static double sizeOf(const DrawnRow &row, double magnitude)
    {
        if (hasVariance(row))
            return std::sqrt(row.varRe + row.varIm);
        return 0.5 * (row.withMagnitude ? row.magnitude.expanded : magnitude * row.phase.expanded);
    }

    Eigen::VectorXcd drawn(const RowSources &of) const
    {
        const RowTrial one(m_plan, m_trials, m_response, of);
        Eigen::VectorXcd values(m_trials.count());
        for (Index trial = 0; trial < values.size(); ++trial)
            values[trial] = one.own(trial);
        return values;
    }

    Eigen::VectorXcd shared(const Eigen::VectorXcd &own) const
    {
        return m_rows.isComplete() ? Eigen::VectorXcd(own.array() * m_trials.common.array()) : own;
    }

    void addPhase(const Eigen::VectorXcd &own, const ReportedValue &reported, DrawnRow &row) const
    {
        row.phase = drawnPhase(own, reported, m_intervals);
        row.gumPhase = validateGum(reported, m_intervals.coverage, row.phase);
    }

    void addMagnitude(const Eigen::VectorXcd &own, Index i, DrawnRow &row) const
    {
        const ReportedValue reported = magnitudeOfRow(m_response, m_rows, i);
        row.magnitude = drawnOf(reported.value * shared(own).cwiseAbs(), reported, m_intervals);
        row.gumMagnitude = validateGum(reported, m_intervals.coverage, row.magnitude);
    }

    const TrialPlan &m_plan;
    const TrialBlock &m_trials;
    const ResponseResult &m_response;
    const RowUncertainty &m_rows;
    DrawnIntervals m_intervals;
};

} // namespace

Result<std::vector<DrawnRow>> drawnRows(const TrialPlan &plan, const TrialBlock &trials,
    const ResponseResult &response, const RowUncertainty &rows, const DrawnIntervals &intervals,
    const JobControl &control)
{
    const Index count = response.magnitude.size();
    std::vector<DrawnRow> drawn(static_cast<std::size_t>(count));
    const RowMaker maker(plan, trials, response, rows, intervals);
    forEachPart(count, true, [&](Index i) {
        if (!control.stopRequested())
            drawn[static_cast<std::size_t>(i)] = maker.make(i);
    });
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    return drawn;
}

} // namespace dyncal
