// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/constants.h"
#include "core/base/finding.h"
#include "core/model_analysis/sensor_response.h"
#include "core/uncertainty/uncertainty_report.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// A response with everything that is known of its uncertainty.
struct UncertainResponse
{
    ResponseResult response;
    UncertaintyReport report;
};

/// S(f) against the pressure step less that against a reference transducer.
struct StepAgainstTransducer
{
    Eigen::VectorXd e_n; ///< of each row of the transducer's response; NaN where one has none
    double difference_relative = kUnknown; ///< mean over the flat part of the band
    double u_relative = kUnknown; ///< of it; what both have in common cancels
    double meanE_n() const { return difference_relative / (2.0 * u_relative); } ///< at k = 2
};

/// Result of comparison with a reference transducer.
struct ComparisonResult
{
    std::optional<UncertainResponse> byTransducer; ///< empty unless it was asked for
    std::optional<UncertainResponse> byStep; ///< of the same records; there where that is
    std::string channel;
    std::string sourceSha256;
    std::string certificate;
    std::string due;
    std::optional<StepAgainstTransducer> againstStep; ///< where the step is known with its u
    Findings findings; ///< CMP-001; of the transducer's records CMP-002 to 004; CMP-005
};

/// Both of the same DUT's records at the same frequencies. The chain and the noise of the DUT are
/// in both and cancel; `correlation`: of the computed step with the reference's sensitivity. Flat
/// is the band within 10 % of the model, or all rows where it is not known. Empty where either has
/// no complete u, or they have no row in common.
std::optional<StepAgainstTransducer> compareWithStep(
    const UncertainResponse &byTransducer, const UncertainResponse &byStep, double correlation);

/// One frequency in both responses. A value that is withheld, or not asked for there, is NaN; a u
/// that is not complete is absent.
struct ComparedRow
{
    double frequency_Hz = kUnknown;
    ReportedValue byTransducer;
    ReportedValue byStep;
    double e_n = kUnknown;
};

/// The rows of the transducer's response, in its order; empty unless a comparison was made. byStep
/// is unknown throughout where the step is not known: its response then has another unit.
std::vector<ComparedRow> comparedRows(const ComparisonResult &comparison);

/// CMP-001, a caution: the two differ by more than their expanded uncertainty (|E_n| above 1).
Findings judgeAgainstStep(const StepAgainstTransducer &comparison);

} // namespace dyncal
