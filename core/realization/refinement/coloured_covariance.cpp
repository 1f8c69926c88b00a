// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/coloured_covariance.h"

#include "core/base/distributions.h"
#include "core/base/parallel.h"
#include "core/realization/refinement/fit_residual.h"
#include "core/realization/refinement/noise_product.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dyncal {
namespace {

constexpr double kSignificance = 0.01;

/// Whether the work on all records is worth a second thread.
bool isLong(const std::vector<RefinementRecord> &records)
{
    constexpr Index kSamples = 100'000;
    Index samples = 0;
    for (const RefinementRecord &record : records)
        samples += record.y.size();
    return samples >= kSamples;
}

/// Whether the residual exceeds the noise, by the innovations of both under the noise's model.
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

/// Rows of the joint covariance for one record: the poles, then the record's own parameters.
std::vector<Index> rowsOf(const Refinement &refinement, std::size_t record, Index count)
{
    const Index n = refinement.poleParameters;
    std::vector<Index> rows(static_cast<std::size_t>(count));
    std::iota(rows.begin(), rows.begin() + n, Index(0));
    std::iota(rows.begin() + n, rows.end(), refinement.offsets[record]);
    return rows;
}

/// noiseFilling() for the parameters of the covariance: J of slopes and levels is that of the
/// amplitudes times the derivatives of these.
Eigen::MatrixXd fillingOf(const std::vector<RefinementRecord> &records,
    const std::vector<AutoregressiveModel> &models, const Refinement &refinement,
    const Eigen::VectorXd &unit)
{
    if (refinement.relaxing.empty())
        return noiseFilling(records, models, refinement, unit);
    const Eigen::MatrixXd derivatives = amplitudesByParameters(refinement) * unit.asDiagonal();
    const Eigen::MatrixXd filling
        = noiseFilling(records, models, refinement, Eigen::VectorXd::Ones(unit.size()));
    return derivatives.transpose() * filling * derivatives;
}

Eigen::MatrixXd sandwich(const std::vector<RefinementRecord> &records,
    const std::vector<AutoregressiveModel> &models, const Refinement &refinement)
{
    const Eigen::MatrixXd bread = refinement.covariance
        / std::max(1.0, refinement.residualToNoise * refinement.residualToNoise);
    const Eigen::VectorXd unit = bread.diagonal().cwiseMax(0.0).cwiseSqrt();
    const Eigen::VectorXd perUnit
        = unit.unaryExpr([](double u) { return u > 0.0 ? 1.0 / u : 0.0; });
    const Eigen::MatrixXd filling = fillingOf(records, models, refinement, unit);
    const Eigen::MatrixXd scaled = perUnit.asDiagonal() * bread * perUnit.asDiagonal();
    return unit.asDiagonal() * (scaled * filling * scaled) * unit.asDiagonal();
}

} // namespace

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
        const Eigen::VectorXd residual = fitResidual(records[r], fit.records[r], fit.nuisance[r]);
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
        const Sensitivities sensitivities = sensitivitiesOf(fit, r, records[r]);
        rows[r] = rowsOf(fit, r, std::ssize(sensitivities.columns));
        products[r] = noiseProduct(sensitivities, unit(rows[r]), usedRanges(records[r]), models[r]);
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
