// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/results_model.h"

#include "core/base/constants.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

using Complex = std::complex<double>;
using Json = nlohmann::json;

constexpr Index kPointsOfCircle = 64; ///< the error of the residues is 2^-64 of the next pole
constexpr double kWidestCircle = 0.25;
constexpr double kSamePole = 1e-9;
constexpr Index kMostStates = 1000;

tl::unexpected<Error> noShape(const char *text)
{
    return fail(ErrorKind::DataBlocked, {text, {}});
}

/// Empty where it is no matrix of finite numbers.
Eigen::MatrixXd matrixAt(const Json &object, const std::string &key)
{
    const Json &rows = valueAt(object, key);
    Eigen::MatrixXd matrix;
    for (std::size_t i = 0; rows.is_array() && i < rows.size(); ++i) {
        const Eigen::VectorXd row = numbersAt({{"row", rows[i]}}, "row");
        if (i == 0)
            matrix.resize(static_cast<Index>(rows.size()), row.size());
        if (row.size() != matrix.cols() || !row.allFinite())
            return {};
        matrix.row(static_cast<Index>(i)) = row;
    }
    return matrix;
}

/// x(k+1) = A x + B u, y = C x + D u, as results.json has it.
struct SampledModel
{
    Eigen::MatrixXd A, B, C, D;
    double dt_s = 0.0;

    bool isWhole() const
    {
        const Index n = A.rows();
        return n > 0 && n <= kMostStates && A.cols() == n && B.rows() == n && B.cols() == 1
            && C.rows() == 1 && C.cols() == n && D.size() == 1 && dt_s > 0.0;
    }

    Complex at(Complex z) const
    {
        const Eigen::MatrixXcd system
            = z * Eigen::MatrixXcd::Identity(A.rows(), A.cols()) - A.cast<Complex>();
        return D(0, 0) + (C * system.partialPivLu().solve(B.cast<Complex>()))(0, 0);
    }
};

SampledModel sampledModel(const Json &model)
{
    return {matrixAt(model, "A"), matrixAt(model, "B"), matrixAt(model, "C"), matrixAt(model, "D"),
        numberAt(model, "dt_s")};
}

Eigen::VectorXcd polesOf(const Json &model)
{
    const Json &list = valueAt(model, "poles");
    Eigen::VectorXcd poles(list.is_array() ? static_cast<Index>(list.size()) : 0);
    for (Index i = 0; i < poles.size(); ++i) {
        const Json &pole = list[static_cast<std::size_t>(i)];
        poles[i] = {numberAt(pole, "re"), numberAt(pole, "im")};
    }
    return poles;
}

double distanceToNext(const Eigen::VectorXcd &poles, Index i)
{
    double least = 2.0 * kWidestCircle;
    for (Index j = 0; j < poles.size(); ++j)
        if (j != i)
            least = std::min(least, std::abs(poles[j] - poles[i]));
    return least;
}

/// Mean of G(z) (z - z_i) over a circle half way to the next pole: the trapezoidal rule converges
/// geometrically (L. N. Trefethen, J. A. C. Weideman, SIAM Review 56 (2014) 385).
Complex residueAt(const SampledModel &model, const Eigen::VectorXcd &poles, Index i)
{
    const double radius = 0.5 * distanceToNext(poles, i);
    Complex sum = 0.0;
    for (Index k = 0; k < kPointsOfCircle; ++k) {
        const Complex step = std::polar(
            radius, kTwoPi * (static_cast<double>(k) + 0.5) / static_cast<double>(kPointsOfCircle));
        sum += model.at(poles[i] + step) * step;
    }
    return sum / static_cast<double>(kPointsOfCircle);
}

bool isSlow(Complex s_rad_s, double fLow_Hz)
{
    return s_rad_s.imag() == 0.0 && std::abs(s_rad_s) < kTwoPi * fLow_Hz;
}

Result<void> checkPoles(const Eigen::VectorXcd &poles, const SampledModel &model)
{
    if (poles.size() != model.A.rows() || !poles.allFinite())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The results are not whole: their model has not as many poles as states; repeat the calibration."),
                {}});
    for (Index i = 0; i < poles.size(); ++i) {
        if (!(std::abs(poles[i]) < 1.0))
            return noShape(DYNCAL_TEXT("core",
                "The model of these results is not stable (a pole does not decay), so nothing can be said between the measured frequencies; calibrate with another order."));
        if (poles[i].imag() == 0.0 && poles[i].real() <= 0.0)
            return noShape(DYNCAL_TEXT("core",
                "The model of these results has a pole at half its rate, which is no sensor's; calibrate with another order."));
        if (distanceToNext(poles, i) < kSamePole)
            return noShape(DYNCAL_TEXT("core",
                "The model of these results has the same pole twice; calibrate with another order."));
    }
    return {};
}

PoleShape continuousShape(const SampledModel &model, const Eigen::VectorXcd &poles, double fLow_Hz)
{
    PoleShape shape;
    shape.level = model.at(1.0).real();
    std::vector<Complex> c, s;
    for (Index i = 0; i < poles.size(); ++i) {
        const Complex amplitude = residueAt(model, poles, i) / (poles[i] - 1.0);
        const Complex rate_rad_s = std::log(poles[i]) / model.dt_s;
        if (isSlow(rate_rad_s, fLow_Hz)) {
            shape.level += amplitude.real();
            continue;
        }
        c.push_back(amplitude);
        s.push_back(rate_rad_s);
    }
    shape.c = Eigen::Map<Eigen::VectorXcd>(c.data(), std::ssize(c));
    shape.s_rad_s = Eigen::Map<Eigen::VectorXcd>(s.data(), std::ssize(s));
    return shape;
}

/// The pole of results.json that is the i-th of the shape.
const Json *poleAt(const Json &model, double dt_s, Complex s_rad_s)
{
    const Complex z = std::exp(s_rad_s * dt_s);
    for (const Json &pole : valueAt(model, "poles"))
        if (std::abs(Complex(numberAt(pole, "re"), numberAt(pole, "im")) - z) < kSamePole)
            return &pole;
    return nullptr;
}

ResponseError poleError(const PoleShape &shape, Index knots, const char *quantity)
{
    return {quantity, Eigen::VectorXcd::Zero(knots), std::numeric_limits<double>::infinity(),
        Eigen::VectorXcd::Zero(shape.s_rad_s.size())};
}

/// Moves the pole, and its partner by the conjugate.
void move(ResponseError &error, const PoleShape &shape, Index i, Complex by_rad_s)
{
    for (Index j = 0; j < shape.s_rad_s.size(); ++j) {
        if (shape.s_rad_s[j] == shape.s_rad_s[i])
            error.polesMoved_rad_s[j] = by_rad_s;
        else if (std::abs(shape.s_rad_s[j] - std::conj(shape.s_rad_s[i]))
            < kSamePole * std::abs(shape.s_rad_s[i]))
            error.polesMoved_rad_s[j] = std::conj(by_rad_s);
    }
}

/// d s/d zeta at constant |s| = w, s = w (-zeta + j sqrt(1 - zeta^2)).
Complex byDamping(Complex s_rad_s)
{
    const double size = std::abs(s_rad_s);
    const double zeta = -s_rad_s.real() / size;
    return size * Complex(-1.0, -zeta / std::sqrt(1.0 - zeta * zeta));
}

} // namespace

Result<PoleShape> shapeOf(const Json &model, double fLow_Hz)
{
    const SampledModel sampled = sampledModel(model);
    if (!sampled.isWhole())
        return noShape(DYNCAL_TEXT("core",
            "The results have no model that carries the response between the measured frequencies; calibrate with another order."));
    const Eigen::VectorXcd poles = polesOf(model);
    return checkPoles(poles, sampled).map([&] { return continuousShape(sampled, poles, fLow_Hz); });
}

Result<std::vector<ResponseError>> poleErrors(
    const Json &model, const PoleShape &shape, Index knots)
{
    std::vector<ResponseError> errors;
    for (Index i = 0; i < shape.s_rad_s.size(); ++i) {
        const Complex s = shape.s_rad_s[i];
        if (s.imag() < 0.0)
            continue;
        const Json *pole = poleAt(model, numberAt(model, "dt_s"), s);
        const double relative
            = pole ? numberAt(*pole, "u_frequency_hz") / numberAt(*pole, "frequency_hz") : kUnknown;
        const double u_damping = pole ? numberAt(*pole, "u_damping_ratio") : kUnknown;
        if (!std::isfinite(relative) || (s.imag() > 0.0 && !std::isfinite(u_damping)))
            return noShape(DYNCAL_TEXT("core",
                "The poles of these results have no uncertainty (the model was not refined), so what lies between the measured frequencies is not known; calibrate with realization.refine."));
        errors.push_back(poleError(shape, knots, "pole_frequency"));
        move(errors.back(), shape, i, s * relative);
        if (s.imag() == 0.0)
            continue;
        errors.push_back(poleError(shape, knots, "pole_damping"));
        move(errors.back(), shape, i, u_damping * byDamping(s));
    }
    return errors;
}

} // namespace dyncal
