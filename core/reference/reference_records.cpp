// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_records.h"

#include "core/reference/certified_source.h"
#include "core/signal/window_cutting.h"

#include <algorithm>
#include <utility>

namespace dyncal {
namespace {

Result<void> checkPlaces(const ComparisonSettings &settings)
{
    if (settings.model.has_value() == !settings.source.empty())
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "A comparison needs the reference transducer's sensitivity from one place: give comparison.source or comparison.model, not both and not neither."),
                {}});
    return {};
}

Result<CertifiedReference> modelWithKnownU(ReferenceSensitivity sensitivity)
{
    if (!sensitivity.withoutU_Hz())
        return CertifiedReference{std::move(sensitivity), {}};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "comparison.model has an uncertainty of 0, which counts as unknown; u_sensitivity, u_f0_hz and u_zeta must be stated, above 0."),
            {}});
}

Result<CertifiedReference> sensitivityOf(const ComparisonSettings &settings)
{
    if (settings.model)
        return ReferenceSensitivity::fromModel(*settings.model).and_then(modelWithKnownU);
    return readCertifiedSource({"comparison", settings.source, settings.sha256, settings.quantityId,
        settings.unit, settings.loaded});
}

const Channel *referenceOf(const Shot &shot, const ComparisonSettings &settings)
{
    return settings.channel.empty() ? shot.channelWithRole(ChannelRole::Reference)
                                    : shot.channelCalled(settings.channel);
}

std::optional<Error> channelFault(
    const Channel *channel, const WindowedResponse &dut, const ComparisonSettings &settings)
{
    if (channel == nullptr || channel->name == dut.channel)
        return Error{ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1 has no channel of a reference transducer beside the sensor; give one the role 'reference' (import.channels), name it in comparison.channel, or switch the comparison off."),
                {std::to_string(dut.shot)}},
            {}, dut.shot};
    if (channel->unit + "/Pa" != settings.unit && !(channel->unit == "Pa" && settings.unit == "1"))
        return Error{ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "The reference transducer's channel %1 is recorded in %2, but comparison.unit is %3; they must belong together, such as V and V/Pa."),
                {channel->name, channel->unit, settings.unit}},
            {}, dut.shot};
    return std::nullopt;
}

Result<WindowedResponse> responseOf(const CaptureSet &set, const WindowedResponse &dut,
    const ComparisonSettings &settings, const CheckSettings &checks)
{
    const Shot &shot = set.shots.at(static_cast<std::size_t>(dut.shot - 1));
    const Channel *channel = referenceOf(shot, settings);
    if (auto error = channelFault(channel, dut, settings))
        return tl::unexpected(*error);
    return cutAlongside(shot, *channel, dut, checks);
}

} // namespace

const WindowedResponse *ReferenceRecords::ofShot(Index shot) const
{
    const auto found = std::ranges::find(responses, shot, &WindowedResponse::shot);
    return found == responses.end() ? nullptr : &*found;
}

Result<ReferenceRecords> referenceRecords(const CaptureSet &set,
    const std::vector<WindowedResponse> &duts, const ComparisonSettings &settings,
    const CheckSettings &checks)
{
    if (const Result<void> source = checkPlaces(settings); !source)
        return tl::unexpected(source.error());
    Result<CertifiedReference> certified = sensitivityOf(settings);
    if (!certified)
        return tl::unexpected(certified.error());
    ReferenceRecords records{std::move(certified->sensitivity), {}, {}, {},
        certified->certificate.empty() ? settings.certificate : certified->certificate,
        settings.due, settings.delay_s, settings.u_delay_s, settings.correlationWithStep};
    if (settings.loaded && !settings.model)
        records.sourceSha256 = settings.loaded->sha256;
    for (const WindowedResponse &dut : duts) {
        Result<WindowedResponse> response = responseOf(set, dut, settings, checks);
        if (!response)
            return tl::unexpected(response.error());
        records.channel = response->channel;
        records.responses.push_back(std::move(*response));
    }
    return records;
}

} // namespace dyncal
