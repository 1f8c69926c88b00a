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
             "The file '%1' of chain.source begins with the magnitude %2 at %3 Hz; it needs the ratio to the gain at low frequency, which begins with 1. Divide its magnitudes by that gain, which belongs into the channel's scale, or begin the table at a lower frequency."),
            {settings.source, numberText(lowest.magnitude, 6),
                numberText(lowest.frequency_Hz, 6)}});
}

/// An inverting amplifier would be a delay that grows without bound towards low frequencies.
Result<void> checkPhase(const ReferencePoint &lowest, const ChainSettings &settings)
{
    constexpr double kQuarterTurn_rad = 1.5707963267948966;
    if (!(std::abs(lowest.phase_rad) > kQuarterTurn_rad))
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The file '%1' of chain.source begins with the phase %2 rad at %3 Hz; it needs one that begins near 0. Take whole turns off, and half a turn into the polarity of the channel; or begin the table at a lower frequency."),
            {settings.source, numberText(lowest.phase_rad, 4),
                numberText(lowest.frequency_Hz, 6)}});
}

Result<void> checkRange(const ReferenceSensitivity &chain, const ChainSettings &settings)
{
    if (chain.highest_Hz() > chain.lowest_Hz())
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The file '%1' of chain.source has one row; it needs the frequencies of the response, for nothing is extrapolated."),
            {settings.source}});
}

Result<void> checkChain(const ReferenceSensitivity &chain, const ChainSettings &settings)
{
    if (const Result<void> range = checkRange(chain, settings); !range)
        return range;
    const Result<void> ratio = checkRatio(chain.lowest(), settings);
    return ratio ? checkPhase(chain.lowest(), settings) : ratio;
}

} // namespace

Result<std::optional<ChainResponse>> chainResponse(const ChainSettings &settings)
{
    if (settings.source.empty())
        return std::optional<ChainResponse>();
    Result<CertifiedReference> certified = readCertifiedSource({"chain", settings.source,
        settings.sha256, settings.quantityId, "1", settings.loaded, true});
    if (!certified)
        return tl::unexpected(certified.error());
    if (const Result<void> usable = checkChain(certified->sensitivity, settings); !usable)
        return tl::unexpected(usable.error());
    return std::optional(ChainResponse{std::move(certified->sensitivity), settings.loaded->sha256,
        certified->certificate.empty() ? settings.certificate : certified->certificate});
}

} // namespace dyncal
