// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stage "uncertainty": sums and distributions in closed form, the published sensitivities of
/// the step, and spectra with covariances of another implementation.
std::vector<CheckSpec> checksOfUncertainty();

} // namespace dyncal
