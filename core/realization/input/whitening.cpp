// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/input/whitening.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kValuesPerCoefficient = 10;

/// Levinson's step from order p to p + 1.
void raiseOrder(const Eigen::VectorXd &r, AutoregressiveModel &model)
{
    const Index p = model.order();
    Eigen::VectorXd &a = model.coefficients;
    double reflection = r[p + 1];
    for (Index i = 0; i < p; ++i)
        reflection += a[i] * r[p - i];
    reflection = -reflection / model.innovationVariance;
    Eigen::VectorXd next(p + 1);
    next.head(p) = a + reflection * a.reverse();
    next[p] = reflection;
    a = std::move(next);
    model.innovationVariance *= 1.0 - reflection * reflection;
}

/// Highest order that every record can carry.
Index highestOrder(const std::vector<NoiseCovariance> &records, Index largest)
{
    for (const NoiseCovariance &record : records) {
        const bool varies = record.values.size() > 0 && record.values[0] > 0.0;
        largest = std::min(
            {largest, record.values.size() - 1, record.count / kValuesPerCoefficient - 1});
        if (!varies)
            largest = 0;
    }
    return std::max<Index>(0, largest);
}

} // namespace

NoiseCovariance noiseCovariance(const Eigen::Ref<const Eigen::VectorXd> &noise, Index lags)
{
    const Index n = noise.size();
    if (n == 0)
        return {};
    const Eigen::VectorXd x = noise.array() - noise.mean();
    NoiseCovariance covariance{Eigen::VectorXd(std::min(lags, n - 1) + 1), n};
    for (Index lag = 0; lag < covariance.values.size(); ++lag)
        covariance.values[lag] = x.head(n - lag).dot(x.tail(n - lag)) / static_cast<double>(n);
    return covariance;
}

AutoregressiveModel autoregressiveModel(const NoiseCovariance &covariance, Index order)
{
    AutoregressiveModel model;
    model.innovationVariance = covariance.values.size() > 0 ? covariance.values[0] : 0.0;
    while (model.order() < order && model.innovationVariance > 0.0)
        raiseOrder(covariance.values, model);
    return model;
}

std::vector<AutoregressiveModel> chooseAutoregressiveModels(
    const std::vector<NoiseCovariance> &records, Index largest)
{
    std::vector<AutoregressiveModel> models;
    for (const NoiseCovariance &record : records)
        models.push_back(autoregressiveModel(record, 0));
    const Index highest = highestOrder(records, largest);
    std::vector<AutoregressiveModel> tried = models;
    double change = 0.0; // of the sum of BIC against order 0
    double smallest = 0.0;
    for (Index p = 1; p <= highest; ++p) {
        for (std::size_t i = 0; i < records.size(); ++i) {
            const double n = static_cast<double>(records[i].count);
            const double before = tried[i].innovationVariance;
            raiseOrder(records[i].values, tried[i]);
            if (!(tried[i].innovationVariance > 0.0))
                return models; // predictable to the last digit: no noise
            change += n * std::log(tried[i].innovationVariance / before) + std::log(n);
        }
        if (change < smallest) {
            smallest = change;
            models = tried;
        }
    }
    return models;
}

Eigen::VectorXd whitened(const Eigen::Ref<const Eigen::VectorXd> &x, const Eigen::VectorXd &a)
{
    const Index p = a.size();
    const Index count = x.size() - p;
    Eigen::VectorXd result = x.tail(count);
    for (Index i = 0; i < p; ++i)
        result += a[i] * x.segment(p - 1 - i, count);
    return result;
}

} // namespace dyncal
