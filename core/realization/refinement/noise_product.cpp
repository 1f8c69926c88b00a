// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/noise_product.h"

#include "core/signal/window_bands.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
constexpr Index kBlock = 128; ///< powers within a block stay accurate

/// Values of columns that are sums of t^order Re(factor e^(s t)).
using ColumnSum = std::vector<ExponentialColumn>;

/// Parameters x samples begin .. begin + count - 1.
Eigen::MatrixXd valuesOf(
    const std::vector<ColumnSum> &rows, const Sensitivities &modes, Index begin, Index count)
{
    std::vector<Eigen::MatrixX2d> powers;
    std::vector<Complex> first;
    for (const Complex &exponent : modes.exponents) {
        powers.push_back(powerTable(exponent, count));
        first.push_back(std::exp(exponent * static_cast<double>(begin)));
    }
    const Eigen::ArrayXd t_s = modes.dt_s
        * Eigen::ArrayXd::LinSpaced(
            count, static_cast<double>(begin), static_cast<double>(begin + count - 1));
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(std::ssize(rows), count);
    for (Index i = 0; i < values.rows(); ++i) {
        for (const ExponentialColumn &column : rows[static_cast<std::size_t>(i)]) {
            const Complex gain = column.factor * first[column.mode];
            const Eigen::MatrixX2d &power = powers[column.mode];
            const Eigen::ArrayXd value
                = gain.real() * power.col(0).array() - gain.imag() * power.col(1).array();
            values.row(i) += (column.order == 0 ? value : (t_s * value).eval()).matrix();
        }
    }
    return values;
}

/// Output of the filter for the columns once it has forgotten their end: with A = sum a_j z^j at z
/// = e^(s dt), z^k becomes z^k / A and k z^k becomes (k - sum j a_j z^j / A) z^k / A.
std::vector<ColumnSum> settledRows(
    const Sensitivities &sensitivities, const Eigen::VectorXd &unit, const Eigen::VectorXd &a)
{
    std::vector<Complex> gain;
    std::vector<Complex> shift;
    for (const Complex &exponent : sensitivities.exponents) {
        Complex sum = 1.0;
        Complex moment = 0.0;
        for (Index j = 1; j <= a.size(); ++j) {
            const auto power = static_cast<double>(j);
            const Complex term = a[j - 1] * std::exp(exponent * power);
            sum += term;
            moment += power * term;
        }
        gain.push_back(1.0 / sum);
        shift.push_back(-moment / sum * sensitivities.dt_s);
    }
    std::vector<ColumnSum> rows;
    for (const ExponentialColumn &column : sensitivities.columns) {
        const Complex factor = unit[std::ssize(rows)] * column.factor * gain[column.mode];
        rows.push_back({{factor, column.mode, column.order}});
        if (column.order == 1)
            rows.back().push_back({factor * shift[column.mode], column.mode, 0});
    }
    return rows;
}

Eigen::MatrixXd gramOf(
    const std::vector<ColumnSum> &rows, const Sensitivities &modes, const SampleRange &range)
{
    const ExponentialGram gram(modes.exponents, {range});
    const Index count = std::ssize(rows);
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(count, count);
    for (Index i = 0; i < count; ++i) {
        for (Index k = 0; k <= i; ++k) {
            for (const ExponentialColumn &left : rows[static_cast<std::size_t>(i)]) {
                for (const ExponentialColumn &right : rows[static_cast<std::size_t>(k)])
                    product(i, k) += gram.product(left, right, modes.dt_s);
            }
            product(k, i) = product(i, k);
        }
    }
    return product;
}

/// The transposed filter 1/A, from the last sample to the first.
class BackwardFilter
{
public:
    BackwardFilter(const Sensitivities &sensitivities, const Eigen::VectorXd &unit,
        const Eigen::VectorXd &coefficients)
        : m_modes(sensitivities)
        , m_coefficients(coefficients)
        , m_settled(settledRows(sensitivities, unit, coefficients))
        , m_states(Eigen::MatrixXd::Zero(unit.size(), coefficients.size()))
        , m_largest(Eigen::VectorXd::Zero(unit.size()))
        , m_sum(Eigen::MatrixXd::Zero(unit.size(), unit.size()))
    {
        for (const ExponentialColumn &column : sensitivities.columns)
            m_inputs.push_back(
                {{unit[std::ssize(m_inputs)] * column.factor, column.mode, column.order}});
    }

    /// Runs over the samples of a range; the filter must be at the range's end.
    void drive(const SampleRange &range)
    {
        Index end = range.end;
        while (end > range.begin && !isSettled(end)) {
            const Index begin = std::max(range.begin, end - kBlock);
            add(valuesOf(m_inputs, m_modes, begin, end - begin));
            end = begin;
        }
        if (end == range.begin)
            return;
        m_sum += gramOf(m_settled, m_modes, {range.begin, end});
        if (m_coefficients.size() == 0)
            return;
        m_states = valuesOf(m_settled, m_modes, range.begin, m_coefficients.size());
        m_largest = m_largest.cwiseMax(m_states.cwiseAbs().rowwise().maxCoeff());
    }

    /// Runs over `count` samples without input, or until the output has decayed.
    void coast(Index count)
    {
        for (Index done = 0; done < count && m_coefficients.size() > 0; done += kBlock) {
            if ((m_states.cwiseAbs().rowwise().maxCoeff().array() <= kForgotten * m_largest.array())
                    .all()) {
                m_states.setZero();
                return;
            }
            add(Eigen::MatrixXd::Zero(m_states.rows(), std::min(kBlock, count - done)));
        }
    }

    /// sum u u^T
    Eigen::MatrixXd sum() const { return m_sum.selfadjointView<Eigen::Lower>(); }

private:
    static constexpr double kForgotten = 1e-8; ///< of the row's largest value

    /// Whether the last outputs, at samples from `begin` on, are those of the settled filter.
    bool isSettled(Index begin) const
    {
        if (m_coefficients.size() == 0)
            return true;
        const Eigen::MatrixXd rest
            = m_states - valuesOf(m_settled, m_modes, begin, m_coefficients.size());
        return (rest.cwiseAbs().rowwise().maxCoeff().array() <= kForgotten * m_largest.array())
            .all();
    }

    /// `input` in order of time; the next call takes the block before it.
    void add(const Eigen::MatrixXd &input)
    {
        const Index p = m_coefficients.size();
        const Index count = input.cols();
        Eigen::MatrixXd outputs(input.rows(), count + p);
        outputs << input, m_states;
        for (Index k = count - 1; k >= 0 && p > 0; --k)
            outputs.col(k).noalias() -= outputs.middleCols(k + 1, p) * m_coefficients;
        m_states = outputs.leftCols(p);
        m_sum.selfadjointView<Eigen::Lower>().rankUpdate(outputs.leftCols(count));
        m_largest = m_largest.cwiseMax(outputs.leftCols(count).cwiseAbs().rowwise().maxCoeff());
    }

    const Sensitivities &m_modes;
    const Eigen::VectorXd &m_coefficients;
    std::vector<ColumnSum> m_inputs;
    std::vector<ColumnSum> m_settled;
    Eigen::MatrixXd m_states; ///< the last outputs, the latest first
    Eigen::VectorXd m_largest; ///< output of every row so far
    Eigen::MatrixXd m_sum; ///< its lower half
};

/// The parameters of a pole (two for a pair, else one), then those of its amplitude.
void addMode(Sensitivities &result, Complex exponent, Complex gain, Index ratePlace,
    Index amplitudePlace, bool isPair)
{
    const Complex i(0.0, 1.0);
    const std::size_t mode = result.exponents.size();
    result.exponents.push_back(exponent);
    const auto at = [&result](Index place) -> ExponentialColumn & {
        return result.columns[static_cast<std::size_t>(place)];
    };
    at(ratePlace) = {gain, mode, 1};
    at(amplitudePlace) = {1.0, mode, 0};
    if (isPair) {
        at(ratePlace + 1) = {i * gain, mode, 1};
        at(amplitudePlace + 1) = {i, mode, 0};
    }
}

} // namespace

Sensitivities sensitivitiesOf(
    const Refinement &refinement, std::size_t record, const RefinementRecord &data)
{
    const ExponentialSum &sum = refinement.records[record];
    const std::vector<NuisanceTerm> &terms = refinement.nuisance[record];
    const Index n = refinement.poleParameters;
    const Index nuisance = 2 * n + (refinement.withConstant ? 1 : 0);
    Sensitivities result;
    result.dt_s = 1.0 / data.rate_Hz;
    result.columns.resize(static_cast<std::size_t>(nuisance) + 4 * terms.size());
    for (Index i = 0; i < n; ++i) {
        const Complex exponent = sum.poles_rad_s[i] * result.dt_s;
        const Complex amplitude = sum.amplitudes[i];
        if (exponent.imag() > 0.0)
            addMode(result, exponent, 2.0 * amplitude, i, n + i, true);
        else if (exponent.imag() == 0.0)
            addMode(result, exponent, amplitude, i, n + i, false);
    }
    if (refinement.withConstant) {
        result.columns[static_cast<std::size_t>(2 * n)] = {1.0, result.exponents.size(), 0};
        result.exponents.push_back(0.0);
    }
    Index own = nuisance;
    for (const NuisanceTerm &term : terms) {
        addMode(result, term.pole_rad_s * result.dt_s, term.amplitude, own, own + 2, true);
        own += 4;
    }
    return result;
}

Eigen::MatrixXd noiseProduct(const Sensitivities &sensitivities, const Eigen::VectorXd &unit,
    const std::vector<SampleRange> &used, const AutoregressiveModel &noise)
{
    BackwardFilter filter(sensitivities, unit, noise.coefficients);
    for (auto range = used.rbegin(); range != used.rend(); ++range) {
        filter.drive(*range);
        const auto before = std::next(range);
        if (before != used.rend())
            filter.coast(range->begin - before->end);
    }
    // Before the record the filter runs on without input; a stable model's output decays.
    filter.coast(used.empty() ? 0 : used.back().end);
    return noise.innovationVariance * filter.sum();
}

} // namespace dyncal
