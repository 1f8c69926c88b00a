// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/propagation.h"

#include "core/base/input_draws.h"
#include "core/base/number_text.h"
#include "core/base/portable_random.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr double kDifferenceShare = 0.1; ///< of u: f is nearly linear there; rounding is negligible
constexpr Index kBatch = 10000;

Result<Eigen::VectorXd> finite(Result<Eigen::VectorXd> results)
{
    if (results && !results->allFinite())
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core", "The result is not a finite number."), {}});
    return results;
}

Error outsideDomain(Index failed, Index trials, const Error &first)
{
    return {ErrorKind::DataBlocked,
        Message{
            DYNCAL_TEXT("core",
                "Monte Carlo: %1 of %2 trials leave the range of the relations (%M1); the stated uncertainties are too large for the value."),
            {std::to_string(failed), std::to_string(trials)}, {first.message}},
        {}, 0};
}

/// All trials of one propagation; results one per column of `m_results`.
class Trials
{
public:
    Trials(const std::vector<UncertainInput> &inputs, const Measurement &measurement,
        const MonteCarloSettings &settings)
        : m_inputs(inputs)
        , m_measurement(measurement)
        , m_correlated(inputs)
    {
        for (const UncertainInput &input : inputs)
            m_streams.emplace_back(
                settings.seed, input.common ? 0 : settings.shot, streamOf(input.quantity));
    }

    Result<void> add(Index count, const JobControl &control)
    {
        Eigen::VectorXd x(std::ssize(m_inputs));
        Index failed = 0;
        Error first;
        for (Index i = 0; i < count; ++i) {
            if (i % 1000 == 0 && control.stopRequested())
                return fail(ErrorKind::Cancelled, {});
            draw(x);
            const Result<Eigen::VectorXd> y = finite(m_measurement(x));
            if (!y && failed++ == 0)
                first = y.error();
            if (!y)
                continue;
            m_results.resize(static_cast<std::size_t>(y->size()));
            for (Index r = 0; r < y->size(); ++r)
                m_results[static_cast<std::size_t>(r)].push_back((*y)[r]);
        }
        if (failed > 0)
            return tl::unexpected(outsideDomain(failed, count, first));
        return {};
    }

    /// Of the last `count` trials.
    MonteCarloResult summary(double coverage, Index count) const
    {
        const Index results = std::ssize(m_results);
        MonteCarloResult s;
        for (Eigen::VectorXd *list : {&s.mean, &s.u, &s.low, &s.high})
            list->resize(results);
        for (Index r = 0; r < results; ++r) {
            const std::vector<double> &values = m_results[static_cast<std::size_t>(r)];
            std::vector<double> sorted(values.end() - count, values.end());
            s.trials = count;
            const Eigen::Map<const Eigen::VectorXd> y(sorted.data(), s.trials);
            s.mean[r] = y.mean();
            s.u[r] = std::sqrt(
                (y.array() - y.mean()).square().sum() / static_cast<double>(s.trials - 1));
            std::sort(sorted.begin(), sorted.end());
            s.low[r] = quantile(sorted, 0.5 * (1.0 - coverage));
            s.high[r] = quantile(sorted, 0.5 * (1.0 + coverage));
        }
        return s;
    }

private:
    void draw(Eigen::VectorXd &x)
    {
        for (std::size_t k = 0; k < m_inputs.size(); ++k)
            x[static_cast<Index>(k)] = m_inputs[k].u > 0.0 ? m_streams[k].nextUniform() : 0.5;
        m_correlated.apply(x);
        for (std::size_t k = 0; k < m_inputs.size(); ++k) {
            const UncertainInput &input = m_inputs[k];
            double &value = x[static_cast<Index>(k)];
            value = drawnValue(input, value);
        }
    }

    /// Interpolated between order statistics, the k-th at (k - 1/2)/n.
    static double quantile(const std::vector<double> &sorted, double p)
    {
        const double position = std::clamp(p * static_cast<double>(sorted.size()) - 0.5, 0.0,
            static_cast<double>(sorted.size() - 1));
        const auto below = static_cast<std::size_t>(position);
        const std::size_t above = std::min(below + 1, sorted.size() - 1);
        const double share = position - static_cast<double>(below);
        return sorted[below] * (1.0 - share) + sorted[above] * share;
    }

    const std::vector<UncertainInput> &m_inputs;
    const Measurement &m_measurement;
    CorrelatedDraws m_correlated;
    std::vector<RandomStream> m_streams;
    std::vector<std::vector<double>> m_results;
};

/// Whether two batches agree so well that more trials change no significant digit.
bool isStable(const std::vector<MonteCarloResult> &batches)
{
    if (batches.size() < 2)
        return false;
    const double n = static_cast<double>(batches.size());
    for (Index r = 0; r < batches.front().u.size(); ++r) {
        for (const auto member : {&MonteCarloResult::mean, &MonteCarloResult::u,
                 &MonteCarloResult::low, &MonteCarloResult::high}) {
            double mean = 0.0, squares = 0.0, u = 0.0;
            for (const MonteCarloResult &batch : batches) {
                mean += (batch.*member)[r] / n;
                u += batch.u[r] / n;
            }
            for (const MonteCarloResult &batch : batches)
                squares += ((batch.*member)[r] - mean) * ((batch.*member)[r] - mean);
            const double deviation = std::sqrt(squares / (n * (n - 1.0)));
            if (u > 0.0 && 2.0 * deviation > numericalTolerance(u, 2))
                return false;
        }
    }
    return true;
}

std::vector<VariancePart> partsOf(const std::vector<BudgetLine> &lines, Index result)
{
    std::vector<VariancePart> parts;
    parts.reserve(lines.size());
    for (const BudgetLine &line : lines)
        parts.push_back({line.input.quantity, line.contribution[result], line.input.dof, 0,
            line.input.correlated});
    return parts;
}

void addCorrelations(GumBudget &budget)
{
    const auto isCorrelated = [](const BudgetLine &line) { return !line.input.correlated.empty(); };
    if (std::ranges::none_of(budget.lines, isCorrelated))
        return;
    for (Index result = 0; result < budget.u.size(); ++result) {
        const CombinedUncertainty all = combinedParts(partsOf(budget.lines, result));
        budget.u[result] = all.u;
        budget.dof[result] = all.dof;
    }
}

} // namespace

const char *distributionName(Distribution distribution)
{
    switch (distribution) {
    case Distribution::Normal:
        return "normal";
    case Distribution::Rectangular:
        return "rectangular";
    case Distribution::Triangular:
        return "triangular";
    case Distribution::UShaped:
        return "u-shaped";
    }
    return "";
}

double GumBudget::sharePercent(std::size_t line, Index result) const
{
    if (!(u[result] > 0.0))
        return 0.0;
    const double share = lines[line].contribution[result] / u[result];
    if (lines[line].input.correlated.empty())
        return 100.0 * share * share;
    return 100.0 * varianceShares(partsOf(lines, result))[line] / (u[result] * u[result]);
}

Result<GumBudget> propagateGum(
    const std::vector<UncertainInput> &inputs, const Measurement &measurement)
{
    if (auto checked = checkInputs(inputs); !checked)
        return tl::unexpected(checked.error());
    Eigen::VectorXd x(std::ssize(inputs));
    for (Index i = 0; i < x.size(); ++i)
        x[i] = inputs[static_cast<std::size_t>(i)].value;
    const Result<Eigen::VectorXd> centre = finite(measurement(x));
    if (!centre)
        return tl::unexpected(centre.error());
    GumBudget budget;
    budget.value = *centre;
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(centre->size());
    Eigen::VectorXd satterthwaite = variance;
    for (Index i = 0; i < x.size(); ++i) {
        const UncertainInput &input = inputs[static_cast<std::size_t>(i)];
        BudgetLine line{input, Eigen::VectorXd::Zero(centre->size()), {}};
        if (input.u > 0.0) {
            const double value = x[i];
            const double step = kDifferenceShare * input.u;
            x[i] = value + step;
            const Result<Eigen::VectorXd> above = finite(measurement(x));
            x[i] = value - step;
            const Result<Eigen::VectorXd> below = finite(measurement(x));
            x[i] = value;
            if (!above || !below)
                return tl::unexpected(above ? below.error() : above.error());
            line.sensitivity = (*above - *below) / (2.0 * step);
        }
        line.contribution = line.sensitivity * input.u;
        variance += line.contribution.array().square().matrix();
        satterthwaite += (line.contribution.array().pow(4) / input.dof).matrix();
        budget.lines.push_back(std::move(line));
    }
    budget.u = variance.cwiseSqrt();
    budget.dof = variance.array().square() / satterthwaite.array();
    for (double &dof : budget.dof)
        dof = std::isnan(dof) ? std::numeric_limits<double>::infinity() : dof; // u = 0
    addCorrelations(budget);
    return budget;
}

double coverageFactor(double dof, double coverage)
{
    return studentQuantile(0.5 * (1.0 + coverage), dof);
}

Result<MonteCarloResult> propagateMonteCarlo(const std::vector<UncertainInput> &inputs,
    const Measurement &measurement, const MonteCarloSettings &settings, const JobControl &control)
{
    if (auto checked = checkMonteCarlo(settings); !checked)
        return tl::unexpected(checked.error());
    if (auto checked = checkInputs(inputs); !checked)
        return tl::unexpected(checked.error());
    Trials all(inputs, measurement, settings);
    if (settings.trials > 0) {
        if (auto done = all.add(settings.trials, control); !done)
            return tl::unexpected(done.error());
        return all.summary(settings.coverage, settings.trials);
    }
    std::vector<MonteCarloResult> batches;
    Index done = 0;
    for (; done < kMostTrials && !isStable(batches); done += kBatch) {
        if (auto added = all.add(kBatch, control); !added)
            return tl::unexpected(added.error());
        batches.push_back(all.summary(settings.coverage, kBatch));
    }
    return all.summary(settings.coverage, done);
}

bool isValidated(const GumBudget &gum, const MonteCarloResult &monteCarlo, Index result,
    double coverage, int digits)
{
    const double u = gum.u[result];
    if (!(u > 0.0))
        return false;
    const double half = coverageFactor(gum.dof[result], coverage) * u;
    const double tolerance = numericalTolerance(u, digits);
    return std::abs(gum.value[result] - half - monteCarlo.low[result]) <= tolerance
        && std::abs(gum.value[result] + half - monteCarlo.high[result]) <= tolerance;
}

} // namespace dyncal
