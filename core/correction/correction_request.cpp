// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/correction_request.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kPointsLookedAt = 4000;

/// |S| at the lowest frequency over |S| at each, L left out.
struct Amplification
{
    Eigen::VectorXd frequency_Hz;
    Eigen::VectorXd factor;
};

Amplification amplificationTo(const KnownResponse &response, double highest_Hz)
{
    Amplification found;
    found.frequency_Hz = Eigen::VectorXd::LinSpaced(
        kPointsLookedAt, std::min(response.knot_Hz[0], highest_Hz), highest_Hz);
    const Eigen::VectorXd magnitude = response.at(found.frequency_Hz).cwiseAbs();
    found.factor = magnitude[0] * magnitude.cwiseInverse();
    return found;
}

std::string inHz(double frequency_Hz)
{
    return numberWithUnit(frequency_Hz, "Hz");
}

tl::unexpected<Error> refused(const char *text, std::vector<std::string> arguments)
{
    return fail(ErrorKind::Usage, {text, std::move(arguments)});
}

/// 0 Hz is known by the level; measured is from the first knot above it.
double lowestMeasured_Hz(const KnownResponse &response)
{
    return response.knot_Hz[0] > 0.0 || response.knot_Hz.size() == 1 ? response.knot_Hz[0]
                                                                     : response.knot_Hz[1];
}

Result<void> checkBand(const KnownResponse &response, double band_Hz)
{
    const double low_Hz = lowestMeasured_Hz(response);
    const double high_Hz = response.knot_Hz.tail(1)[0];
    if (band_Hz >= low_Hz && band_Hz <= high_Hz)
        return {};
    return refused(
        DYNCAL_TEXT("core",
            "A band up to %1 (--band) is not possible: the response was measured from %2 to %3; ask for a band that ends there."),
        {inHz(band_Hz), inHz(low_Hz), inHz(high_Hz)});
}

Result<void> checkEdge(const KnownResponse &response, double rate_Hz, const LowPass &lowPass)
{
    const double highest_Hz = kHighestEdge * rate_Hz;
    const bool isEdgeUsed = lowPass.kind == LowPassKind::Gaussian;
    const double last_Hz = isEdgeUsed ? lowPass.edge_Hz : lowPass.band_Hz;
    if (isEdgeUsed && !(lowPass.edge_Hz > lowPass.band_Hz))
        return refused(
            DYNCAL_TEXT("core", "The edge %1 (--edge) must lie above the end %2 of the band."),
            {inHz(lowPass.edge_Hz), inHz(lowPass.band_Hz)});
    if (!(last_Hz <= highest_Hz))
        return refused(
            DYNCAL_TEXT("core",
                "The correction would reach to %1, but at %2 a recording holds only what lies below %3; ask for a narrower band (--band, --edge) or take a faster recording."),
            {inHz(last_Hz), numberWithUnit(rate_Hz, "Hz"), inHz(highest_Hz)});
    if (!(last_Hz <= response.validTo_Hz))
        return refused(
            DYNCAL_TEXT("core",
                "The correction would reach to %1, but the response is known up to %2 only; ask for a narrower band (--band, --edge)."),
            {inHz(last_Hz), inHz(response.validTo_Hz)});
    return {};
}

Result<void> checkAmplification(const KnownResponse &response, const LowPass &lowPass)
{
    const Amplification found = amplificationTo(response, lowPass.band_Hz);
    Index worst = 0;
    const double most = found.factor.maxCoeff(&worst);
    if (most <= kMostAmplified)
        return {};
    return fail(ErrorKind::DataBlocked,
        {DYNCAL_TEXT("core",
             "At %1 the sensor answers %2 times weaker than at the lowest frequency, and its noise would be amplified as much (at most %3 times); ask for a narrower band (--band)."),
            {inHz(found.frequency_Hz[worst]), numberText(most, 3), numberText(kMostAmplified, 3)}});
}

} // namespace

double widestBand_Hz(const KnownResponse &response, double rate_Hz)
{
    const double widest_Hz = std::min(response.knot_Hz.tail(1)[0],
        std::min(response.validTo_Hz, kHighestEdge * rate_Hz) / kEdgeOverBand);
    const Amplification found = amplificationTo(response, widest_Hz);
    for (Index i = 0; i < found.factor.size(); ++i)
        if (found.factor[i] > kMostAmplified)
            return found.frequency_Hz[std::max<Index>(i - 1, 0)];
    return widest_Hz;
}

Result<LowPass> requestedLowPass(
    const KnownResponse &response, double rate_Hz, const CorrectionSettings &settings)
{
    if (!(rate_Hz > 0.0) || !std::isfinite(rate_Hz))
        return refused(
            DYNCAL_TEXT("core",
                "The recording has no sample rate; state it (import.sample_rate_hz of a recipe)."),
            {});
    const double band_Hz = settings.band_Hz.value_or(widestBand_Hz(response, rate_Hz));
    const LowPass lowPass{
        settings.lowPass, band_Hz, settings.edge_Hz.value_or(kEdgeOverBand * band_Hz)};
    return checkBand(response, band_Hz)
        .and_then([&] { return checkEdge(response, rate_Hz, lowPass); })
        .and_then([&] { return checkAmplification(response, lowPass); })
        .map([&] { return lowPass; });
}

} // namespace dyncal
