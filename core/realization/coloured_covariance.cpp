// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/coloured_covariance.h"

#include "core/base/distributions.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
constexpr double kSignificance = 0.01;
constexpr double kDecayed = 1e-6; ///< of its largest value: the filter's memory before the record

/// Whether the work on all records is worth a second thread.
bool isLong(const std::vector<RefinementRecord> &records)
{
    constexpr Index kSamples = 100'000;
    Index samples = 0;
    for (const RefinementRecord &record : records)
        samples += record.y.size();
    return samples >= kSamples;
}

std::vector<SampleRange> usedRanges(const RefinementRecord &record)
{
    return record.used.empty() ? std::vector<SampleRange>{{0, record.y.size()}} : record.used;
}

/// What the model leaves of the samples that took part, one stretch after the other.
Eigen::VectorXd residualOf(const RefinementRecord &record, const ExponentialSum &sum,
    const std::vector<NuisanceTerm> &terms)
{
    ExponentialSum whole = sum;
    for (const NuisanceTerm &term : terms) {
        const Index n = whole.rates_rad_s.size();
        whole.rates_rad_s.conservativeResize(n + 1);
        whole.amplitudes.conservativeResize(n + 1);
        whole.rates_rad_s[n] = term.rate_rad_s; // its real part alone is sampled
        whole.amplitudes[n] = term.amplitude;
    }
    const ExponentialSampler sampler(whole, 1.0 / record.rate_Hz);
    Eigen::VectorXd residual = record.y;
    for (Index begin = 0; begin < residual.size(); begin += ExponentialSampler::kBlock) {
        const Index size = std::min(ExponentialSampler::kBlock, residual.size() - begin);
        residual.segment(begin, size)
            -= sampler.block(begin / ExponentialSampler::kBlock).head(size);
    }
    Index kept = 0;
    for (const SampleRange &range : usedRanges(record)) {
        residual.segment(kept, range.size()) = residual.segment(range.begin, range.size()).eval();
        kept += range.size();
    }
    return residual.head(kept);
}

/// Whether the residual holds more than the noise: innovations of both by the noise's own model.
bool exceedsNoise(const Eigen::VectorXd &residual, const NoiseCovariance &noise,
    const AutoregressiveModel &model, double lostFreedom)
{
    const double count = static_cast<double>(residual.size() - model.order());
    if (noise.count == 0 || !(model.innovationVariance > 0.0))
        return true;
    const double freedom = std::max(1.0, count - lostFreedom);
    const double variance = whitened(residual, model.coefficients).squaredNorm() / freedom;
    const double spread = std::sqrt(2.0 / freedom + 2.0 / static_cast<double>(noise.count));
    return std::log(variance / model.innovationVariance)
        > normalQuantile(1.0 - kSignificance) * spread;
}

/// d model / d parameter of one record in the order of Refinement::covariance: poles, amplitudes
/// (2 Re, 2 Im of the upper half of a pair), constant, nuisance terms. A block of samples at a
/// time.
class Sensitivities
{
public:
    Sensitivities(const Refinement &refinement, std::size_t record, const RefinementRecord &data)
        : m_sum(refinement.records[record])
        , m_terms(refinement.nuisance[record])
        , m_used(usedRanges(data))
        , m_dt_s(1.0 / data.rate_Hz)
        , m_ownBegin(refinement.poleParameters)
        , m_nuisanceBegin(2 * m_ownBegin + (refinement.withConstant ? 1 : 0))
    {
    }

    Index parameters() const { return m_nuisanceBegin + 4 * std::ssize(m_terms); }

    /// Parameters x samples begin .. begin + count - 1; zero where a sample took no part.
    Eigen::MatrixXd block(Index begin, Index count) const
    {
        Eigen::MatrixXd J = Eigen::MatrixXd::Ones(parameters(), count); // the constant's row stays
        for (Index i = 0; i < m_ownBegin; ++i) {
            const Complex s = m_sum.rates_rad_s[i];
            if (s.imag() > 0.0)
                fill(J, begin, {i, m_ownBegin + i, s, 2.0 * m_sum.amplitudes[i], true});
            else if (s.imag() == 0.0)
                fill(J, begin, {i, m_ownBegin + i, s, m_sum.amplitudes[i], false});
        }
        Index own = m_nuisanceBegin;
        for (const NuisanceTerm &term : m_terms) {
            fill(J, begin, {own, own + 2, term.rate_rad_s, term.amplitude, true});
            own += 4;
        }
        Index free = begin;
        for (const SampleRange &range : m_used) {
            const Index next = std::clamp(range.begin, free, begin + count);
            J.middleCols(free - begin, next - free).setZero();
            free = std::clamp(range.end, next, begin + count);
        }
        J.rightCols(begin + count - free).setZero();
        return J;
    }

private:
    /// Re(gain e^(rate t)) and where its parameters lie.
    struct Mode
    {
        Index rateRow = 0;
        Index gainRow = 0;
        Complex rate_rad_s;
        Complex gain;
        bool isPair = false;
    };

    void fill(Eigen::MatrixXd &J, Index begin, const Mode &mode) const
    {
        const Complex first = std::exp(mode.rate_rad_s * (static_cast<double>(begin) * m_dt_s));
        const Eigen::MatrixX2d powers = powerTable(mode.rate_rad_s * m_dt_s, J.cols());
        for (Index k = 0; k < J.cols(); ++k) {
            const Complex e = first * Complex(powers(k, 0), powers(k, 1));
            const Complex moved = mode.gain * e * (static_cast<double>(begin + k) * m_dt_s);
            J(mode.rateRow, k) = moved.real();
            J(mode.gainRow, k) = e.real();
            if (mode.isPair) {
                J(mode.rateRow + 1, k) = -moved.imag();
                J(mode.gainRow + 1, k) = -e.imag();
            }
        }
    }

    const ExponentialSum &m_sum;
    const std::vector<NuisanceTerm> &m_terms;
    std::vector<SampleRange> m_used;
    double m_dt_s;
    Index m_ownBegin;
    Index m_nuisanceBegin;
};

/// The transposed filter 1/A run backwards over the sensitivities: with u its output, the product
/// J^T S J is the innovation variance times sum u u^T, samples before the record included, in which
/// the noise already lived.
class BackwardFilter
{
public:
    BackwardFilter(const AutoregressiveModel &model, Index parameters)
        : m_model(model)
        , m_states(Eigen::MatrixXd::Zero(parameters, model.order()))
        , m_sum(Eigen::MatrixXd::Zero(parameters, parameters))
    {
    }

    /// `input` in order of time; the block before it comes next. Returns the largest output.
    double add(const Eigen::MatrixXd &input)
    {
        const Index p = m_model.order();
        const Index count = input.cols();
        Eigen::MatrixXd outputs(input.rows(), count + p);
        outputs << input, m_states;
        for (Index k = count - 1; k >= 0 && p > 0; --k)
            outputs.col(k).noalias() -= outputs.middleCols(k + 1, p) * m_model.coefficients;
        m_states = outputs.leftCols(p);
        m_sum.noalias() += outputs.leftCols(count) * outputs.leftCols(count).transpose();
        return outputs.leftCols(count).cwiseAbs().maxCoeff();
    }

    Eigen::MatrixXd product() const { return m_model.innovationVariance * m_sum; }

private:
    const AutoregressiveModel &m_model;
    Eigen::MatrixXd m_states; ///< the last outputs, the latest first
    Eigen::MatrixXd m_sum;
};

/// J^T S J of one record. Parameters are divided by `scale`.
Eigen::MatrixXd noiseProduct(const Sensitivities &sensitivities, const Eigen::VectorXd &scale,
    Index samples, const AutoregressiveModel &model)
{
    constexpr Index kBlock = 256;
    BackwardFilter filter(model, scale.size());
    double largest = 0.0;
    for (Index end = samples; end > 0; end -= std::min(end, kBlock)) {
        const Index begin = std::max<Index>(0, end - kBlock);
        largest = std::max(
            largest, filter.add(scale.asDiagonal() * sensitivities.block(begin, end - begin)));
    }
    // The filter's memory runs on before the record; a stable model ends it.
    for (Index before = 0; before < samples; before += kBlock) {
        if (filter.add(Eigen::MatrixXd::Zero(scale.size(), kBlock)) < kDecayed * largest)
            break;
    }
    return filter.product();
}

/// Rows of the joint covariance that belong to one record: poles, then its own.
std::vector<Index> rowsOf(const Refinement &refinement, std::size_t record, Index count)
{
    const Index n = refinement.poleParameters;
    std::vector<Index> rows(static_cast<std::size_t>(count));
    std::iota(rows.begin(), rows.begin() + n, Index(0));
    std::iota(rows.begin() + n, rows.end(), refinement.offsets[record]);
    return rows;
}

Eigen::MatrixXd sandwich(const std::vector<RefinementRecord> &records,
    const std::vector<AutoregressiveModel> &models, const Refinement &refinement)
{
    const Eigen::MatrixXd bread = refinement.covariance
        / std::max(1.0, refinement.residualToNoise * refinement.residualToNoise);
    const Eigen::VectorXd unit = bread.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd perUnit
        = unit.unaryExpr([](double u) { return u > 0.0 ? 1.0 / u : 0.0; });
    const Eigen::MatrixXd filling = noiseFilling(records, models, refinement, unit);
    const Eigen::MatrixXd scaled = perUnit.asDiagonal() * bread * perUnit.asDiagonal();
    return unit.asDiagonal() * (scaled * filling * scaled) * unit.asDiagonal();
}

} // namespace

std::string noiseName(const NoiseBasis &basis)
{
    if (basis.order == 0)
        return "white";
    return "AR(" + std::to_string(basis.order) + ")"
        + (basis.fromResidual ? " of the residual" : "");
}

NoiseModels chooseNoiseModels(const std::vector<RefinementRecord> &records,
    const std::vector<NoiseCovariance> &noise, const Refinement &fit, Index parameters)
{
    NoiseBasis basis;
    const auto before = chooseAutoregressiveModels(noise, kLargestNoiseModelOrder);
    const double lost = static_cast<double>(parameters) / static_cast<double>(records.size());
    std::vector<NoiseCovariance> used = noise;
    std::vector<Index> counts(records.size());
    std::vector<int> fromResidual(records.size());
    forEachPart(std::ssize(records), isLong(records), [&](Index part) {
        const auto r = static_cast<std::size_t>(part);
        const Eigen::VectorXd residual = residualOf(records[r], fit.records[r], fit.nuisance[r]);
        if (exceedsNoise(residual, noise[r], before[r], lost)) {
            const double count = static_cast<double>(residual.size());
            used[r] = noiseCovariance(residual, kLargestNoiseModelOrder);
            used[r].values *= count / std::max(1.0, count - lost);
            fromResidual[r] = 1;
        }
        counts[r] = residual.size();
    });
    Index samples = 0;
    Index values = 0;
    for (std::size_t r = 0; r < records.size(); ++r) {
        basis.fromResidual = basis.fromResidual || fromResidual[r] != 0;
        samples += counts[r];
        values += used[r].count;
    }
    auto models = chooseAutoregressiveModels(used, kLargestNoiseModelOrder);
    basis.order = models.front().order();
    // The spectral density of an AR(p) model has a relative variance of 2 (p + 1)/values.
    const double freedom = basis.order == 0
        ? static_cast<double>(samples - parameters)
        : static_cast<double>(values) / static_cast<double>(basis.order + 1);
    basis.dof = std::max(1.0, freedom);
    return {basis, std::move(models)};
}

Eigen::MatrixXd noiseFilling(const std::vector<RefinementRecord> &records,
    const std::vector<AutoregressiveModel> &models, const Refinement &fit,
    const Eigen::VectorXd &unit)
{
    std::vector<std::vector<Index>> rows(records.size());
    std::vector<Eigen::MatrixXd> products(records.size());
    forEachPart(std::ssize(records), isLong(records), [&](Index part) {
        const auto r = static_cast<std::size_t>(part);
        const Sensitivities sensitivities(fit, r, records[r]);
        rows[r] = rowsOf(fit, r, sensitivities.parameters());
        products[r] = noiseProduct(sensitivities, unit(rows[r]), records[r].y.size(), models[r]);
    });
    Eigen::MatrixXd filling = Eigen::MatrixXd::Zero(unit.size(), unit.size());
    for (std::size_t r = 0; r < records.size(); ++r)
        filling(rows[r], rows[r]) += std::pow(records[r].weight, 4) * products[r];
    return filling;
}

NoiseBasis allowForColour(const std::vector<RefinementRecord> &records,
    const std::vector<NoiseCovariance> &noise, Refinement &refinement)
{
    const NoiseModels models
        = chooseNoiseModels(records, noise, refinement, refinement.covariance.rows());
    if (models.basis.order > 0)
        refinement.covariance = sandwich(records, models.ofRecord, refinement);
    return models.basis;
}

} // namespace dyncal
