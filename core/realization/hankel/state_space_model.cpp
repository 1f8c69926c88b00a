// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/state_space_model.h"

#include "core/base/eigenvalues.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

StateSpaceModel modalStateSpace(const std::vector<std::complex<double>> &poles,
    const Eigen::VectorXcd &residues, double feedthrough, double sampleInterval_s)
{
    const Index n = static_cast<Index>(poles.size());
    StateSpaceModel model;
    model.A = Eigen::MatrixXd::Zero(n, n);
    model.B = Eigen::MatrixXd::Zero(n, 1);
    model.C = Eigen::MatrixXd::Zero(1, n);
    model.D = Eigen::MatrixXd::Constant(1, 1, feedthrough);
    model.sampleInterval_s = sampleInterval_s;
    for (Index i = 0; i < n; ++i) {
        const std::complex<double> p = poles[static_cast<std::size_t>(i)];
        const double gain = std::sqrt(std::abs(residues[i]));
        // The refinement, at the record's own rate, may find a resonance above the model's Nyquist
        // frequency. It is folded: the upper half of its pair in s is the lower one in z.
        if (p.imag() != 0.0) {
            // C (zI - A)^-1 B = 2 Re-form of r/(z-p) + r*/(z-p*), inputs and outputs balanced.
            model.A.block(i, i, 2, 2) << p.real(), p.imag(), -p.imag(), p.real();
            const std::complex<double> output = gain > 0.0 ? residues[i] / gain : 0.0;
            model.B(i, 0) = 2.0 * gain;
            model.C(0, i) = output.real();
            model.C(0, i + 1) = output.imag();
            ++i;
        } else {
            model.A(i, i) = p.real();
            model.B(i, 0) = gain;
            model.C(0, i) = gain > 0.0 ? residues[i].real() / gain : 0.0;
        }
    }
    return model;
}

Eigen::VectorXd impulseResponse(const StateSpaceModel &model, Index count)
{
    Eigen::VectorXd h(count);
    if (count > 0)
        h[0] = model.D(0, 0);
    Eigen::VectorXd x = model.B;
    for (Index k = 1; k < count; ++k) {
        h[k] = (model.C * x)(0, 0);
        x = (model.A * x).eval();
    }
    return h;
}

std::vector<std::complex<double>> transmissionZeros(const StateSpaceModel &model)
{
    constexpr double kNegligible = 1e-9; ///< of the largest impulse response value
    constexpr double kFarAway = 1e6; ///< numerical infinity of a strictly proper system
    const Index n = model.order();
    if (n == 0)
        return {};
    const Eigen::VectorXd h = impulseResponse(model, 2 * n + 2);
    const double scale = h.cwiseAbs().maxCoeff();
    // The first value that is not 0 is h_d = C A^(d-1) B: d samples of delay.
    Index delay = 0;
    while (delay < n && !(std::abs(h[delay]) > kNegligible * scale))
        ++delay;
    if (!(std::abs(h[delay]) > kNegligible * scale))
        return {};
    Eigen::MatrixXd output = model.C;
    for (Index k = 0; k < delay; ++k)
        output = (output * model.A).eval();
    const Eigen::VectorXcd found = eigenvalues(model.A - model.B * output / h[delay]);
    std::vector<std::complex<double>> zeros(found.begin(), found.end());
    // Each sample of delay adds an eigenvalue at 0 (up to rounding) that is no zero.
    std::sort(zeros.begin(), zeros.end(),
        [](const auto &a, const auto &b) { return std::abs(a) < std::abs(b); });
    zeros.erase(zeros.begin(), zeros.begin() + delay);
    std::erase_if(zeros, [](const std::complex<double> &z) { return !(std::abs(z) < kFarAway); });
    std::sort(zeros.begin(), zeros.end(), [](const auto &a, const auto &b) {
        return a.real() != b.real() ? a.real() < b.real() : a.imag() > b.imag();
    });
    return zeros;
}

} // namespace dyncal
