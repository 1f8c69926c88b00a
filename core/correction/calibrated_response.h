// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/correction/known_response.h"

#include <string>
#include <vector>

namespace dyncal {

/// What results.json says that a correction needs.
struct CalibratedResponse
{
    KnownResponse response;
    double fLow_Hz = 0.0; ///< below, the response is taken to be that of the level at the onset
    std::vector<std::string> cautions; ///< ids of the findings that are cautions, each once
    std::string createdUtc;
};

/// The complete response of the item that a results.json (schema "dyncal-results/1") states: its
/// rows that have magnitude, phase and both u, and at 0 Hz the sensitivity; between them, and above
/// up to half the model's rate, the poles. Real poles slower than f_low are a drift and no part of
/// it. Errors: of each row noise, end of record and aliasing, each alone; every other line of the
/// rows' budgets is one input for all rows, of magnitude and phase apart; f0 and damping of every
/// pole. `name` is that of the file, for sentences. Fails (Usage) where the text is no results.json
/// or contradicts itself, (DataBlocked) where it states no response per pressure, no budget of the
/// rows, no step model, a pole that does not decay or that has no u.
Result<CalibratedResponse> calibratedResponse(const std::string &text, const std::string &name);

} // namespace dyncal
