// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/chain_response.h"

#include "core/base/number_text.h"
#include "core/reference/certified_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

Result<void> checkRatio(const ReferencePoint &lowest, const ChainSettings &settings)
{
    constexpr double kRounding = 1e-3;
    if (std::abs(lowest.magnitude - 1.0) <= std::max(kRounding, 2.0 * lowest.u_magnitude))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The file '%1' of chain.source begins with the magnitude %2 at %3 Hz; it needs the ratio to the gain at low frequency, which begins with 1. Divide its magnitudes by that gain, which belongs into the channel's scale."),
            {settings.source, numberText(lowest.magnitude, 6),
                numberText(lowest.frequency_Hz, 6)}});
}

/// A malformed file is told in the words of the reference transducer's, which has the same form.
Error ofChain(Error error, const ChainSettings &settings)
{
    if (error.kind == ErrorKind::Usage)
        error.message
            = {DYNCAL_TEXT("core",
                   "The file '%1' of chain.source is read as that of a reference transducer: %2"),
                {settings.source, english(error.message)}};
    return error;
}

} // namespace

Result<std::optional<ChainResponse>> chainResponse(const ChainSettings &settings)
{
    if (settings.source.empty())
        return std::optional<ChainResponse>();
    Result<CertifiedReference> certified = readCertifiedSource(
        {"chain", settings.source, settings.sha256, settings.quantityId, "1", settings.loaded});
    if (!certified)
        return tl::unexpected(ofChain(certified.error(), settings));
    if (const Result<void> ratio = checkRatio(certified->sensitivity.lowest(), settings); !ratio)
        return tl::unexpected(ratio.error());
    return std::optional(ChainResponse{std::move(certified->sensitivity), settings.loaded->sha256,
        std::move(certified->certificate)});
}

} // namespace dyncal
