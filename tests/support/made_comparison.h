// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/uncertainty/transducer_comparison.h"

#include <cmath>
#include <limits>
#include <vector>

namespace dyncal::testing {

/// A response with these magnitudes at 1, 10, 100 kHz ..., in V/Pa, each with u of `relative`.
inline UncertainResponse answerOf(const std::vector<double> &magnitudes, double relative)
{
    UncertainResponse answer;
    ResponseResult &r = answer.response;
    const auto count = static_cast<Index>(magnitudes.size());
    r.frequency_Hz = Eigen::VectorXd(count);
    r.magnitude = Eigen::VectorXd(count);
    for (Index i = 0; i < count; ++i) {
        r.frequency_Hz[i] = 1e3 * std::pow(10.0, static_cast<double>(i));
        r.magnitude[i] = magnitudes[static_cast<std::size_t>(i)];
    }
    r.u_noiseMagnitude = r.u_magnitude = 1e-9 * r.magnitude;
    r.u_frontMagnitude = r.u_referenceMagnitude = r.boundEnd = r.boundAlias
        = Eigen::VectorXd::Zero(count);
    r.dof = r.dofReference
        = Eigen::VectorXd::Constant(count, std::numeric_limits<double>::infinity());
    r.unit = "V/Pa";
    answer.report.rows.common = {directLine("gain_relative", relative)};
    answer.report.rows.u_common_relative = relative;
    return answer;
}

/// Transducer (u 0.5 %) and step (u 1 %), with the E_n given.
inline ComparisonResult comparisonOf(const std::vector<double> &byTransducer,
    const std::vector<double> &byStep, const std::vector<double> &e_n, double difference = 0.01)
{
    ComparisonResult comparison;
    comparison.byTransducer = answerOf(byTransducer, 0.005);
    comparison.byTransducer->response.isByTransducer = true;
    comparison.byStep = answerOf(byStep, 0.01);
    StepAgainstTransducer against;
    against.e_n = Eigen::Map<const Eigen::VectorXd>(e_n.data(), std::ssize(e_n));
    against.difference_relative = difference;
    against.u_relative = 0.01;
    comparison.againstStep = against;
    return comparison;
}

} // namespace dyncal::testing
