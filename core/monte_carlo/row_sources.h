// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/model_analysis/response_result.h"
#include "core/uncertainty/reported_value.h"

#include <complex>
#include <limits>

namespace dyncal {

/// A complex relative error: u along and across the value.
struct RelativeError
{
    double along = 0.0;
    double across = 0.0;
    double dof = std::numeric_limits<double>::infinity();
};

/// What one row is drawn from; relative, and in rad.
struct RowSources
{
    double frequency_Hz = 0.0;
    std::complex<double> value;
    double noise = 0.0;
    double dofNoise = std::numeric_limits<double>::infinity();
    double boundEnd = 0.0;
    double boundAlias = 0.0;
    std::complex<double> drift; ///< h for a deviate of 1
    double onset_rad = 0.0;
    RelativeError reference; ///< multiplies
    RelativeError chain; ///< divides
};

/// Of a row that is not withheld; `phase`: its phase as reported. What is not there is 0.
RowSources rowSources(const ResponseResult &response, const ReportedValue &phase, Index row);

} // namespace dyncal
