// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/refinement/refinement.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

bool isRelaxing(const Refinement &refinement, Index pole)
{
    return std::ranges::find(refinement.relaxing, pole) != refinement.relaxing.end();
}

/// Moves c_i, with the level at t = 0 held.
void setAmplitude(ExponentialSum &sum, Index pole, double amplitude)
{
    sum.constant -= amplitude - sum.amplitudes[pole].real();
    sum.amplitudes[pole] = amplitude;
}

/// Moves the rate, or the slope at t = 0, of a relaxing pole, the other and the level held.
void moveRelaxing(ExponentialSum &sum, Index pole, bool movesRate, double delta)
{
    constexpr double kOffZero = 1e-6; // of the step, where it would end at rate 0
    const double rate = sum.poles_rad_s[pole].real();
    const double slope = sum.amplitudes[pole].real() * rate;
    if (!movesRate) {
        setAmplitude(sum, pole, (slope + delta) / rate);
        return;
    }
    const double moved = rate + delta != 0.0 ? rate + delta : kOffZero * delta;
    sum.poles_rad_s[pole] = moved;
    setAmplitude(sum, pole, slope / moved);
}

/// Moves one of the record's parameters.
void move(const Refinement &refinement, Index index, double delta, ExponentialSum &sum)
{
    const Index n = refinement.poleParameters;
    if (index == 2 * n) {
        sum.constant += delta;
        return;
    }
    const bool movesPole = index < n;
    const Index i = movesPole ? index : index - n;
    Eigen::VectorXcd &values = movesPole ? sum.poles_rad_s : sum.amplitudes;
    if (isRelaxing(refinement, i)) {
        moveRelaxing(sum, i, movesPole, delta);
        return;
    }
    const double share = movesPole ? delta : delta / 2.0; // amplitudes are fitted as 2 Re, 2 Im
    const std::vector<std::complex<double>> &poles = refinement.poles_rad_s;
    if (isUpperOfPair(poles, static_cast<std::size_t>(i))) {
        values[i] += share;
        values[i + 1] += share;
    } else if (i > 0 && isUpperOfPair(poles, static_cast<std::size_t>(i - 1))) {
        values[i - 1] += std::complex<double>(0.0, share);
        values[i] -= std::complex<double>(0.0, share);
    } else {
        values[i] += delta;
    }
}

} // namespace

ExponentialSum perturbed(const Refinement &refinement, Index record, Index index, double delta)
{
    ExponentialSum sum = refinement.records[static_cast<std::size_t>(record)];
    move(refinement, index, delta, sum);
    return sum;
}

ExponentialSum perturbed(const Refinement &refinement, Index record, const Eigen::VectorXd &deltas)
{
    ExponentialSum sum = refinement.records[static_cast<std::size_t>(record)];
    for (Index i = 0; i < deltas.size(); ++i)
        move(refinement, i, deltas[i], sum);
    return sum;
}

Eigen::MatrixXd recordCovariance(const Refinement &refinement, Index record)
{
    const Index n = refinement.poleParameters;
    const Index m = n + (refinement.withConstant ? 1 : 0);
    const Index offset = refinement.offsets[static_cast<std::size_t>(record)];
    Eigen::MatrixXd covariance(n + m, n + m);
    covariance.topLeftCorner(n, n) = refinement.covariance.topLeftCorner(n, n);
    covariance.topRightCorner(n, m) = refinement.covariance.block(0, offset, n, m);
    covariance.bottomLeftCorner(m, n) = refinement.covariance.block(offset, 0, m, n);
    covariance.bottomRightCorner(m, m) = refinement.covariance.block(offset, offset, m, m);
    return covariance;
}

Eigen::MatrixXd amplitudesByParameters(const Refinement &refinement)
{
    const Index count = refinement.covariance.rows();
    Eigen::MatrixXd derivatives = Eigen::MatrixXd::Identity(count, count);
    for (std::size_t r = 0; r < refinement.records.size(); ++r) {
        const ExponentialSum &sum = refinement.records[r];
        const Index constant = refinement.offsets[r] + refinement.poleParameters;
        for (const Index i : refinement.relaxing) {
            const double rate = sum.poles_rad_s[i].real();
            const double byRate = -sum.amplitudes[i].real() / rate;
            const Index amplitude = refinement.offsets[r] + i;
            derivatives(amplitude, amplitude) = 1.0 / rate;
            derivatives(amplitude, i) = byRate;
            derivatives(constant, amplitude) = -1.0 / rate;
            derivatives(constant, i) = -byRate;
        }
    }
    return derivatives;
}

double constantVariance(const Refinement &refinement, Index record)
{
    const Index place = refinement.offsets[static_cast<std::size_t>(record)]
        + refinement.poleParameters - (refinement.withConstant ? 0 : 1);
    if (refinement.relaxing.empty())
        return refinement.covariance(place, place);
    const Eigen::VectorXd gradient = amplitudesByParameters(refinement).row(place).transpose();
    return std::max(0.0, gradient.dot(refinement.covariance * gradient));
}

Eigen::Matrix4d nuisanceCovariance(const Refinement &refinement, Index record, Index term)
{
    const Index own = refinement.poleParameters + (refinement.withConstant ? 1 : 0);
    const Index at = refinement.offsets[static_cast<std::size_t>(record)] + own + 4 * term;
    return refinement.covariance.block<4, 4>(at, at);
}

} // namespace dyncal
