// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/signal_curves.h"

#include "ui/plot/axis_prefix.h"
#include "ui/plot/curve_building.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace dyncal {

namespace {

constexpr double kRiseTimesShown = 20.0;
constexpr double kShareShown = 0.05; ///< of the window, where no rise time is known
constexpr Index kLeastSamplesShown = 50;
constexpr double kShareBeforeStart = 0.1;

struct RawExtremes
{
    double min = 0.0;
    double max = 0.0;
    bool any = false;
};

template <typename T>
RawExtremes extremesOf(std::span<const T> counts)
{
    RawExtremes found;
    for (const T count : counts) {
        const auto value = static_cast<double>(count);
        if (!std::isfinite(value))
            continue;
        found.min = found.any ? std::min(found.min, value) : value;
        found.max = found.any ? std::max(found.max, value) : value;
        found.any = true;
    }
    return found;
}

/// Extremes of the physical values: those of the counts where the conversion is a line.
RawExtremes physicalExtremes(const Channel &channel, Index begin, Index end)
{
    if (channel.polynomial.size() > 2) {
        const Eigen::VectorXd values = physicalValues(channel, begin, end - begin);
        return extremesOf(
            std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
    }
    RawExtremes found;
    channel.samples.visitBlocks(begin, end, [&](auto counts, Index) {
        const RawExtremes here = extremesOf(counts);
        if (!here.any)
            return;
        found.min = found.any ? std::min(found.min, here.min) : here.min;
        found.max = found.any ? std::max(found.max, here.max) : here.max;
        found.any = true;
    });
    const double a = physicalValue(channel, found.min);
    const double b = physicalValue(channel, found.max);
    return {std::min(a, b), std::max(a, b), found.any};
}

void appendEnvelope(const Channel &channel, PlotCurve &curve)
{
    const Index count = channel.samples.size();
    const Index stretch = (count + kRawBuckets - 1) / kRawBuckets;
    for (Index begin = 0; begin < count; begin += stretch) {
        const Index end = std::min(count, begin + stretch);
        const RawExtremes found = physicalExtremes(channel, begin, end);
        if (!found.any)
            continue;
        const double time = 0.5 * (channel.timeOf_s(begin) + channel.timeOf_s(end - 1));
        curve.x.insert(curve.x.end(), {time, time});
        curve.y.insert(curve.y.end(), {found.min, found.max});
    }
}

PlotCurve rawCurve(const Channel &channel, const ShotStyle &style)
{
    PlotCurve curve{style.name, style.role, CurveStyle::Line, {}, {}, true};
    const Index count = channel.samples.size();
    if (count > 2 * kRawBuckets) {
        appendEnvelope(channel, curve);
    } else {
        curve.x = timeAxis(channel.t0_s, 1.0 / channel.sampleRate_Hz, count);
        curve.y = toVector(physicalValues(channel, 0, count));
    }
    return curve;
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
    PlotCurve curve{style.name, style.role, CurveStyle::Line, {}, {}, true};
    curve.x = timeAxis(static_cast<double>(begin - response.lead) * step, step, end - begin);
    curve.y = toVector(response.values.segment(begin, end - begin));
    return curve;
}

Index samplesOfStart(const WindowedResponse &response)
{
    const double fallback_s
        = kShareShown * static_cast<double>(response.length) / response.sampleRate_Hz;
    const double shown_s
        = response.riseTime_s ? kRiseTimesShown * *response.riseTime_s : fallback_s;
    const auto samples = static_cast<Index>(std::min(shown_s * response.sampleRate_Hz, 1e9));
    return std::clamp(samples, std::min(kLeastSamplesShown, response.length), response.length);
}

} // namespace

PlotContent rawCurves(const CaptureSet &set, ChannelRole role)
{
    PlotContent content;
    content.title = roleTitle(role);
    content.xAxis = timeAxisMeaning();
    content.yAxis = {Plots::tr("Signal"), QString()};
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Shot &shot = set.shots[i];
        const Channel *channel = shot.channelWithRole(role);
        if (!shot.included || !channel || !(channel->sampleRate_Hz > 0.0))
            continue;
        if (content.curves.empty())
            content.yAxis.unit = QString::fromStdString(channel->unit);
        content.curves.push_back(
            rawCurve(*channel, shotStyle(static_cast<Index>(i) + 1, shot.level)));
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
    PlotContent content;
    content.title = Plots::tr("Power spectrum");
    content.xAxis = frequencyAxisMeaning();
    const QString unit = responseAxisMeaning(window).unit;
    content.yAxis = {Plots::tr("Power spectral density"),
        unit.isEmpty() ? QStringLiteral("dB re 1/Hz") : QStringLiteral("dB re %1²/Hz").arg(unit)};
    std::vector<ShotStyle> shots;
    std::vector<const PowerSpectrum *> spectra;
    for (std::size_t i = 0; i < spectrum.perShot.size() && i < window.responses.size(); ++i) {
        shots.push_back(shotStyle(window.responses[i].shot, window.responses[i].level));
        spectra.push_back(&spectrum.perShot[i]);
    }
    content.curves = spectraOfShots(shots, spectra);
    content.yMin = lowestShown_dB(content.curves);
    for (const Resonance &resonance : spectrum.resonances)
        content.marks.push_back({resonance.frequency_Hz,
            valueWithUnit(resonance.frequency_Hz, QStringLiteral("Hz"), 4), CurveRole::Suggestion});
    content.summary = spectrum.resonances.empty()
        ? Plots::tr("Power spectrum; no resonance found.")
        : Plots::tr("Power spectrum; main resonance at %1.").arg(content.marks.front().label);
    return content;
}

} // namespace dyncal
