// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signal/power_spectrum.h"

#include <Eigen/Core>

#include <vector>

namespace dyncal {

/// Spectra of several shots on one frequency axis. Internal to core/results.
struct SharedSpectrum
{
    Eigen::VectorXd frequency_Hz;
    std::vector<Eigen::VectorXd> psd; ///< per shot; NaN where the shot has no bin in the cell
};

/// Brings the spectra to at most `count` points: every bin above 0 Hz where these suffice, else
/// log-spaced cells that each hold their largest value. A cell's frequency is the one at which the
/// largest value of all shots lies, so that no peak moves. Shots may differ in rate and length.
SharedSpectrum sharedSpectrum(const std::vector<PowerSpectrum> &spectra, Index count);

} // namespace dyncal
