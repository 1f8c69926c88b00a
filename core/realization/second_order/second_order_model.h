// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <string>
#include <vector>

namespace dyncal {

/// One shot as a step of the second-order sensor.
struct SecondOrderShot
{
    Index shot = 0; ///< number from 1; 0 = the average
    double plateauGain = 0.0; ///< K, in the units of the series
    double u_plateauGain = 0.0;
    double onset_s = 0.0; ///< relative to the detected start
    double u_onset_s = 0.0;
    double fit_percent = 0.0;
};

/// The sensor as K w0^2 / (s^2 + 2 zeta w0 s + w0^2), fitted for comparison with the free model
/// (docs/method/model.md).
struct SecondOrderModel
{
    double f0_Hz = 0.0; ///< w0/2pi
    double u_f0_Hz = 0.0;
    double zeta = 0.0;
    double u_zeta = 0.0;
    double coverageFactor = 0.0; ///< k: value +- k u is a 95 % interval
    std::string uncertaintyMethod; ///< as SensorModel::uncertaintyMethod
    std::vector<SecondOrderShot> shots;
    double fit_percent = 0.0; ///< pooled, over the model inputs
    double residualToNoise = 0.0; ///< rms over the records at their own rate; 1 = noise explains it
    bool describes = false; ///< its FIT comes within two points of the free model's
    bool isModel = false; ///< it has the smaller BIC, and its poles are the model's
};

} // namespace dyncal
