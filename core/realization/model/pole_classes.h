// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/realization/model/sensor_model.h"
#include "core/signal/signal_settings.h"

#include <complex>
#include <vector>

namespace dyncal {

inline constexpr double kUnstableMargin = 1e-6; ///< of |z| beyond 1

/// Whether a pole grows to more than ten times its initial value over `samples`: a model with it
/// diverges.
bool isRunaway(std::complex<double> z, Index samples);

/// Removes such poles; true if there were any.
bool dropRunaways(std::vector<std::complex<double>> &poles, Index samples);

/// Class of every pole: `step` is the real pole nearest 1 within 1e-3 when the treatment feeds the
/// step itself; `unstable` |z| > 1 + 1e-6; `nyquist` a real z < -0.5 or |arg z| > 0.95 pi; else
/// `sensor` where its part of the response stands out of the noise, `other` where it does not.
std::vector<PoleClass> classifyPoles(const std::vector<std::complex<double>> &poles,
    ResponseTreatment treatment, const std::vector<bool> &standsOut);

/// Poles in the order of results.json: by frequency, then imaginary part descending.
void sortPoles(std::vector<Pole> &poles);

} // namespace dyncal
