// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/reference/chain_settings.h"
#include "core/reference/reference_sensitivity.h"

#include <optional>
#include <string>

namespace dyncal {

/// The response of amplifier and converter, relative to the gain that the records are scaled with.
struct ChainResponse
{
    ReferenceSensitivity relative; ///< 1 at its lowest frequency
    std::string sourceSha256;
    std::string certificate; ///< its number, where the file states one
};

/// Empty without chain.source. Fails as readCertifiedSource() (the unit is 1), and (Usage) where
/// the lowest row is not 1 within its expanded uncertainty or 1e-3: then it is no ratio to the gain
/// at low frequency, which the records are scaled with.
Result<std::optional<ChainResponse>> chainResponse(const ChainSettings &settings);

} // namespace dyncal
