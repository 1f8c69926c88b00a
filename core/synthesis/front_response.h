// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/synthesis/step_response.h"

#include <complex>
#include <optional>
#include <span>
#include <vector>

namespace dyncal {

/// A step that needs time to come. Ramp: it grows evenly. Tilt: a straight front moves over a
/// circular diaphragm, so that it grows as 2/pi sqrt(1 - x^2), x from -1 to 1.
struct Front
{
    enum class Kind { Ramp, Tilt };
    Kind kind = Kind::Ramp;
    double duration_s = 0.0; ///< from its beginning to its end, above 0
};

/// Duration of a front tilted by so many degrees (0 to below 90), of velocity W, over a disc of
/// that diameter: D sin(angle)/W.
double tiltDuration_s(double angle_deg, double diameter_m, double velocity_m_s);

/// Convolution of a response with the growth of a front, times counted from the front's middle.
/// Behind the front it is again a sum of exponentials with the same poles, each times the
/// transform of the growth; within it each exponential is the integral over what has come so far,
/// in closed form (ramp) or by Gauss-Legendre quadrature in the angle arccos(x), where the
/// integrand is smooth (tilt; 1e-12 of the step). Without a front it is the response itself.
class FrontResponse
{
public:
    FrontResponse(StepResponse response, const std::optional<Front> &front);

    /// Value at a time after the front's middle; 0 before the front.
    double at(double time_s) const;

    /// As StepResponse::addTo.
    void addTo(
        std::span<double> values, double firstTime_s, double sampleRate_Hz, double scale) const;

private:
    struct Node
    {
        double position; ///< in -1 .. 1
        double weight;
    };

    static std::vector<Node> gaussLegendre(int count);
    std::complex<double> rampWeight(std::complex<double> pole_per_s, double elapsed_s) const;
    std::complex<double> tiltWeight(std::complex<double> pole_per_s, double elapsed_s) const;
    StepResponse weightedAfter(double elapsed_s) const;
    double half_s() const { return m_front ? 0.5 * m_front->duration_s : 0.0; }

    StepResponse m_response;
    std::optional<Front> m_front;
    std::vector<Node> m_nodes; ///< of a tilt
    StepResponse m_settled; ///< from the front's end on
};

} // namespace dyncal
