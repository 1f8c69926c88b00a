// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/selftest/self_check.h"

namespace dyncal {

/// The stages "evidence" and "model_assessment": a sensor in white noise of a fixed seed, its
/// uncertainties against the Cramer-Rao bound.
std::vector<CheckSpec> checksInNoise();

} // namespace dyncal
