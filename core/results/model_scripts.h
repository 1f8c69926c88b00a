// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/signal/signal_settings.h"

#include <string>

namespace dyncal {

/// Scripts that load model.mat from their own folder, simulate A, B, C, D and compare with the
/// exponentials (with step-as-impulse: with the simulation in the file), printing the largest
/// difference.
std::string matlabScript(ResponseTreatment treatment);
std::string pythonScript(ResponseTreatment treatment);

} // namespace dyncal
