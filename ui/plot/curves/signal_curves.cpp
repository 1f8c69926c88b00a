// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/signal_curves.h"

#include "core/signal/spectrum_analysis.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/plot/values/record_samples.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kResponseRisesShown = 20.0;
constexpr double kSettlingTimesShown = 1.5;
constexpr double kShareShown = 0.05; ///< of the window, where no rise time is known
constexpr Index kLeastSamplesShown = 50;
constexpr double kShareBeforeStart = 0.1;

/// The record through its envelope, or nothing while the envelope is still being built.
void appendRecord(
    const std::shared_ptr<const ChannelEnvelope> &envelope, bool keepRecord, PlotCurve &curve)
{
    if (!envelope)
        return;
    auto record = std::make_shared<const RecordSamples>(envelope);
    DrawnPoints whole = record->overview(kRawColumns);
    curve.x = std::move(whole.x);
    curve.y = std::move(whole.y);
    if (keepRecord)
        curve.record = std::move(record);
}

std::shared_ptr<const ChannelEnvelope> builtNow(const Channel &channel)
{
    auto envelope = ChannelEnvelope::build(channel);
    return envelope ? std::make_shared<const ChannelEnvelope>(std::move(*envelope)) : nullptr;
}

PlotCurve rawCurve(const Channel &channel, const ShotStyle &style, const EnvelopeSource &envelopeOf)
{
    PlotCurve curve = shotCurve(style, CurveStyle::Line, {}, {});
    if (isLongRecord(channel)) {
        appendRecord(envelopeOf ? envelopeOf(channel) : builtNow(channel), !!envelopeOf, curve);
    } else {
        curve.x = timeAxis(channel.t0_s, 1.0 / channel.sampleRate_Hz, channel.samples.size());
        curve.y = toVector(physicalValues(channel, 0, channel.samples.size()));
    }
    return curve;
}

/// The view spans the whole record at once, even while it is still being read.
void extendView(const Channel &channel, PlotContent &content)
{
    if (channel.samples.size() == 0)
        return;
    const double begin = channel.t0_s;
    const double end = channel.timeOf_s(channel.samples.size() - 1);
    content.xMin = std::min(content.xMin.value_or(begin), begin);
    content.xMax = std::max(content.xMax.value_or(end), end);
}

/// The channel of a shot that plots of the role show.
const Channel *drawn(const Shot &shot, ChannelRole role)
{
    const Channel *channel = shot.included ? shot.channelWithRole(role) : nullptr;
    return channel && channel->sampleRate_Hz > 0.0 ? channel : nullptr;
}

QString roleTitle(ChannelRole role)
{
    switch (role) {
    case ChannelRole::Dut:
        return Plots::tr("Sensor under test");
    case ChannelRole::DrivenSide:
        return Plots::tr("Side wall, driven section");
    case ChannelRole::Driver:
        return Plots::tr("Driver section");
    case ChannelRole::Trigger:
        return Plots::tr("Trigger");
    case ChannelRole::Reference:
        return Plots::tr("Reference transducer");
    case ChannelRole::Other:
        break;
    }
    return Plots::tr("Other channel");
}

PlotContent responseContent(const WindowResult &window, const QString &title)
{
    PlotContent content;
    content.title = title;
    content.xAxis = timeAxisMeaning();
    content.yAxis = responseAxisMeaning(window);
    return content;
}

/// Samples [begin, end) of the stored values, times relative to the start.
PlotCurve responseCurve(const WindowedResponse &response, Index begin, Index end)
{
    const ShotStyle style = shotStyle(response.shot, response.level);
    const double step = 1.0 / response.sampleRate_Hz;
    PlotCurve curve = shotCurve(style, CurveStyle::Line, {}, {});
    curve.x = timeAxis(static_cast<double>(begin - response.lead) * step, step, end - begin);
    curve.y = toVector(response.values.segment(begin, end - begin));
    return curve;
}

Index samplesOfStart(const WindowedResponse &response)
{
    const double fallback_s
        = kShareShown * static_cast<double>(response.length) / response.sampleRate_Hz;
    const double shown_s
        = response.riseTime_s ? kResponseRisesShown * *response.riseTime_s : fallback_s;
    const auto samples = static_cast<Index>(std::min(shown_s * response.sampleRate_Hz, 1e9));
    return std::clamp(samples, std::min(kLeastSamplesShown, response.length), response.length);
}

} // namespace

bool isLongRecord(const Channel &channel)
{
    return channel.samples.size() > 2 * kRawColumns && channel.sampleRate_Hz > 0.0;
}

std::vector<Channel> longRecords(const CaptureSet &set)
{
    std::vector<Channel> records;
    for (const ChannelRole role : {ChannelRole::Dut, ChannelRole::DrivenSide, ChannelRole::Driver})
        for (const Shot &shot : set.shots)
            if (const Channel *channel = shot.channelWithRole(role);
                shot.included && channel && isLongRecord(*channel))
                records.push_back(*channel);
    return records;
}

std::vector<std::string> unitsOf(const CaptureSet &set, ChannelRole role)
{
    std::vector<std::string> units;
    for (const Shot &shot : set.shots)
        if (const Channel *channel = drawn(shot, role);
            channel && std::ranges::find(units, channel->unit) == units.end())
            units.push_back(channel->unit);
    return units;
}

PlotContent rawCurves(const CaptureSet &set, ChannelRole role, const EnvelopeSource &envelopeOf,
    const std::optional<std::string> &unit)
{
    PlotContent content;
    content.title = roleTitle(role);
    content.xAxis = timeAxisMeaning();
    content.yAxis = {Plots::tr("Signal"), QString()};
    const std::vector<std::string> units = unitsOf(set, role);
    const std::string wanted = unit.value_or(units.empty() ? std::string() : units.front());
    content.yAxis.unit = shownText(wanted);
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Channel *channel = drawn(set.shots[i], role);
        if (!channel || channel->unit != wanted)
            continue;
        const ShotStyle style = shotStyle(static_cast<Index>(i) + 1, set.shots[i].level);
        content.curves.push_back(rawCurve(*channel, style, envelopeOf));
        extendView(*channel, content);
    }
    content.summary
        = Plots::tr("%1; recordings: %2.").arg(content.title).arg(content.curves.size());
    return content;
}

PlotContent windowCurves(const WindowResult &window)
{
    PlotContent content = responseContent(window, Plots::tr("Responses, aligned at the start"));
    for (const WindowedResponse &response : window.responses)
        content.curves.push_back(responseCurve(response, 0,
            std::min(response.lead + response.length, static_cast<Index>(response.values.size()))));
    content.summary
        = Plots::tr("Responses aligned at the start; shots: %1.").arg(window.responses.size());
    return content;
}

Index pointsOf(const WindowResult &window)
{
    Index points = 0;
    for (const WindowedResponse &response : window.responses)
        points += response.values.size();
    return points;
}

double ringingEnd_s(const WindowResult &window)
{
    double end_s = 0.0;
    for (const WindowedResponse &response : window.responses) {
        const double length_s = static_cast<double>(response.length) / response.sampleRate_Hz;
        const double shown_s = response.settlingTime_s
            ? kSettlingTimesShown * *response.settlingTime_s
            : kShareShown * length_s;
        end_s = std::max(end_s, std::min(shown_s, length_s));
    }
    return end_s;
}

PlotContent startCurves(const WindowResult &window)
{
    PlotContent content = responseContent(window, Plots::tr("Start of the responses"));
    for (const WindowedResponse &response : window.responses) {
        const Index shown = samplesOfStart(response);
        const auto before = static_cast<Index>(kShareBeforeStart * static_cast<double>(shown)) + 1;
        content.curves.push_back(responseCurve(response, std::max<Index>(0, response.lead - before),
            std::min(response.lead + shown, static_cast<Index>(response.values.size()))));
    }
    content.summary
        = Plots::tr("The first moments of the responses; shots: %1.").arg(window.responses.size());
    return content;
}

PlotContent spectrumCurves(const SpectrumResult &spectrum, const WindowResult &window)
{
    std::vector<ShotStyle> shots;
    std::vector<const PowerSpectrum *> spectra;
    for (std::size_t i = 0; i < spectrum.perShot.size() && i < window.responses.size(); ++i) {
        shots.push_back(shotStyle(window.responses[i].shot, window.responses[i].level));
        spectra.push_back(&spectrum.perShot[i]);
    }
    PlotContent content = spectraContent(Plots::tr("Power spectrum"), window, shots, spectra);
    for (const Resonance &resonance : spectrum.resonances)
        content.marks.push_back({resonance.frequency_Hz,
            valueWithUnit(resonance.frequency_Hz, QStringLiteral("Hz"), 4), CurveRole::Suggestion});
    content.summary = spectrum.resonances.empty()
        ? Plots::tr("Power spectrum; no resonance found.")
        : Plots::tr("Power spectrum; main resonance at %1.").arg(content.marks.front().label);
    return content;
}

} // namespace dyncal
