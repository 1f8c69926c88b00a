// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/curves/shock_curves.h"

#include "ui/plot/curves/curve_building.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/plot/values/record_samples.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kTubeMargin = 0.06; ///< of the tube's length, beside it
constexpr int kStrokes = 12; ///< of the hatched plateau
constexpr int kPointsPerWay = 600; ///< few points are drawn as samples, with dots; these are none
constexpr int kLabelledModes = 6; ///< across the tube; the next ones lie too close for labels
constexpr double kArrivalRisesShown = 60.0;
constexpr double kLeastArrivalSamples = 400.0;

struct LineLook
{
    QString name;
    CurveRole role;
};

LineLook lookOf(TubeLine line)
{
    switch (line) {
    case TubeLine::Shock:
        return {Plots::tr("shock"), CurveRole::ShotHigh};
    case TubeLine::ReflectedShock:
        return {Plots::tr("reflected"), CurveRole::ShotMedium};
    case TubeLine::ContactSurface:
        return {Plots::tr("contact"), CurveRole::ShotLow};
    case TubeLine::ContactReflection:
        return {Plots::tr("its echo"), CurveRole::ShotOther};
    case TubeLine::RarefactionHead:
        return {Plots::tr("expansion head"), CurveRole::Model};
    case TubeLine::RarefactionTail:
        return {Plots::tr("expansion tail"), CurveRole::Noise};
    }
    return {};
}

/// A path through `corners`, drawn as a line without dots.
void addWay(PlotContent &content, PlotCurve look, const std::vector<TubePoint> &corners)
{
    const auto pieces = static_cast<int>(corners.size()) - 1;
    for (int i = 0; i <= kPointsPerWay && pieces > 0; ++i) {
        const double at = static_cast<double>(i) * pieces / kPointsPerWay;
        const auto piece = static_cast<std::size_t>(std::min(static_cast<int>(at), pieces - 1));
        const double share = at - static_cast<double>(piece);
        const TubePoint &from = corners[piece], &to = corners[piece + 1];
        look.x.push_back(from.x_m + share * (to.x_m - from.x_m));
        look.y.push_back(from.time_s + share * (to.time_s - from.time_s));
    }
    content.curves.push_back(std::move(look));
}

/// A graph is sorted by x, so a path that turns back becomes two curves.
void addPath(const TubePath &path, double burst_s, PlotContent &content)
{
    const LineLook name = lookOf(path.line);
    PlotCurve look{name.name, name.role, CurveStyle::Line, {}, {}, true};
    std::vector<TubePoint> corners;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const auto &p = path.points;
        corners.push_back({p[i].x_m, burst_s + p[i].time_s});
        const bool turns = i > 0 && i + 1 < p.size()
            && (p[i].x_m - p[i - 1].x_m) * (p[i + 1].x_m - p[i].x_m) < 0.0;
        if (!turns)
            continue;
        addWay(content, look, corners);
        look.inLegend = false;
        corners.erase(corners.begin(), corners.end() - 1);
    }
    addWay(content, look, corners);
}

/// The plateau is hatched beside the end wall.
void addPlateau(const TubeDiagram &diagram, PlotContent &content)
{
    const double wall_m = diagram.waves.geometry.drivenLength_m;
    const double width_m = 0.6 * kTubeMargin * wall_m;
    const Interval plateau = diagram.plateau_s;
    PlotCurve look{Plots::tr("plateau"), CurveRole::Suggestion, CurveStyle::Line, {}, {}, true};
    addWay(content, look, {{wall_m, plateau.begin}, {wall_m, plateau.end}});
    look.inLegend = false;
    for (int i = 0; i < kStrokes; ++i) {
        const double from_s = plateau.begin + plateau.length() * i / kStrokes;
        addWay(content, look,
            {{wall_m, from_s}, {wall_m + width_m, from_s + plateau.length() / kStrokes}});
    }
}

void addSensors(const TubeDiagram &diagram, PlotContent &content)
{
    PlotCurve seen{Plots::tr("seen"), CurveRole::Measured, CurveStyle::Markers, {}, {}, true};
    const double wall_m = diagram.waves.geometry.drivenLength_m;
    for (const TubeSensor &sensor : diagram.sensors) {
        const double x_m = wall_m - sensor.distance_m;
        const QString name
            = sensor.distance_m > 0.0 ? shownText(sensor.channel) : Plots::tr("end wall");
        content.marks.push_back({x_m, name, CurveRole::Reference});
        if (!sensor.arrival_s)
            continue;
        seen.x.push_back(x_m);
        seen.y.push_back(*sensor.arrival_s);
    }
    if (!seen.x.empty())
        content.curves.push_back(std::move(seen));
}

const TubeSensor *sensorAt(const ShockConditions &shot, double distance_m)
{
    if (!shot.diagram)
        return nullptr;
    const auto &sensors = shot.diagram->sensors;
    const auto found = std::find_if(sensors.begin(), sensors.end(),
        [&](const TubeSensor &sensor) { return sensor.distance_m == distance_m; });
    return found != sensors.end() ? &*found : nullptr;
}

const SideArrival *arrivalOf(const ShockConditions &shot, const Channel &channel)
{
    for (const SeenArrival &seen : shot.seen) {
        const bool same
            = seen.channel == channel.name || seen.channel == channelRoleName(channel.role);
        if (same && seen.found)
            return &*seen.found;
    }
    return nullptr;
}

PlotCurve recordOf(const Channel &channel, const EnvelopeSource &envelopeOf)
{
    PlotCurve curve{shownText(channel.name), CurveRole::Measured, CurveStyle::Line, {}, {}, true};
    if (!isLongRecord(channel)) {
        curve.x = timeAxis(channel.t0_s, 1.0 / channel.sampleRate_Hz, channel.samples.size());
        curve.y = toVector(physicalValues(channel, 0, channel.samples.size()));
        return curve;
    }
    const auto envelope = envelopeOf(channel);
    if (!envelope)
        return curve;
    auto record = std::make_shared<const RecordSamples>(envelope);
    DrawnPoints whole = record->overview(kRawColumns);
    curve.x = std::move(whole.x);
    curve.y = std::move(whole.y);
    curve.record = std::move(record);
    return curve;
}

/// The first view: the passing shock, or at the end wall everything until the driver gas arrives.
void setView(const Channel &channel, const SideArrival *arrival, const TubeSensor *sensor,
    PlotContent &content)
{
    if (arrival != nullptr) {
        const double half_s = std::max(
            kArrivalRisesShown * arrival->rise_s, kLeastArrivalSamples / channel.sampleRate_Hz);
        content.xMin = arrival->time_s - half_s;
        content.xMax = arrival->time_s + half_s;
        const double step = arrival->behind - arrival->before;
        content.yMin = std::min(arrival->before - 0.4 * step, arrival->behind + 0.6 * step);
        content.yMax = std::max(arrival->before - 0.4 * step, arrival->behind + 0.6 * step);
    } else if (sensor != nullptr) {
        const double span_s = sensor->driverGas_s - sensor->expected_s;
        content.xMin = sensor->expected_s - 0.1 * span_s;
        content.xMax = sensor->driverGas_s + 0.2 * span_s;
    }
}

/// Short words for the ticks; higher modes along the tube get none.
QString modeLabel(const TubeResonance &mode)
{
    switch (mode.kind) {
    case ResonanceKind::Transverse:
        return QStringLiteral("(%1,%2)").arg(mode.m).arg(mode.n);
    case ResonanceKind::Body:
        return mode.order == 1 ? QStringLiteral("5.1") : QString();
    case ResonanceKind::Cavity:
        return mode.order == 1 ? QStringLiteral("5.2") : QString();
    case ResonanceKind::CavityShocked:
        return mode.order == 1 ? QStringLiteral("a5") : QString();
    case ResonanceKind::CavityMixed:
        return mode.order == 1 ? Plots::tr("mix", "tube mode") : QString();
    }
    return {};
}

double firstFrequency_Hz(const PlotContent &content)
{
    double first_Hz = std::numeric_limits<double>::infinity();
    for (const PlotCurve &curve : content.curves) {
        for (const double x : curve.x) {
            if (x > 0.0) {
                first_Hz = std::min(first_Hz, x);
                break;
            }
        }
    }
    return std::isfinite(first_Hz) ? first_Hz : 0.0;
}

} // namespace

PlotContent tubeDiagramCurves(const ShockConditions &shot)
{
    PlotContent content;
    content.title = Plots::tr("Waves in the tube, shot %1").arg(shot.shot);
    content.xAxis = {Plots::tr("Distance from the diaphragm"), QStringLiteral("m")};
    content.yAxis = timeAxisMeaning();
    if (!shot.diagram) {
        content.summary = Plots::tr("No diagram: the tube's lengths or the velocity are unknown.");
        return content;
    }
    const TubeDiagram &diagram = *shot.diagram;
    for (const TubePath &path : diagram.waves.paths)
        addPath(path, diagram.burst_s, content);
    addPlateau(diagram, content);
    addSensors(diagram, content);
    content.marks.push_back({0.0, Plots::tr("diaphragm"), CurveRole::Reference});
    const double length_m = diagram.waves.geometry.drivenLength_m;
    content.xMin = -(1.0 + kTubeMargin) * diagram.waves.geometry.driverLength_m.value_or(0.0)
        - kTubeMargin * length_m;
    content.xMax = (1.0 + kTubeMargin) * length_m;
    const double last_s = std::max(diagram.plateau_s.end,
        diagram.burst_s + diagram.waves.shockAtWall_s + diagram.waves.plateau_s);
    content.yMin = diagram.burst_s;
    content.yMax = last_s + 0.1 * (last_s - diagram.burst_s);
    content.summary = Plots::tr("Waves in the tube; the plateau at the end wall lasts %1.")
                          .arg(valueWithUnit(diagram.plateau_s.length(), QStringLiteral("s"), 4));
    return content;
}

PlotContent arrivalCurves(const Channel &channel, const ShockConditions &shot, double distance_m,
    const EnvelopeSource &envelopeOf)
{
    PlotContent content;
    content.title = Plots::tr("Arrival at %1, shot %2")
                        .arg(shownText(channel.name), QString::number(shot.shot));
    content.xAxis = timeAxisMeaning();
    content.yAxis = {Plots::tr("Signal"), shownText(channel.unit)};
    if (channel.sampleRate_Hz > 0.0)
        content.curves.push_back(recordOf(channel, envelopeOf));
    const SideArrival *arrival = arrivalOf(shot, channel);
    if (arrival != nullptr)
        content.levels = {{arrival->before, Plots::tr("before"), CurveRole::Reference},
            {0.5 * (arrival->before + arrival->behind), Plots::tr("50 %"), CurveRole::Reference},
            {arrival->behind, Plots::tr("behind the shock"), CurveRole::Reference}};
    const TubeSensor *sensor = sensorAt(shot, distance_m);
    if (sensor != nullptr) {
        content.marks.push_back(
            {sensor->driverGas_s, Plots::tr("driver gas (computed)"), CurveRole::Suggestion});
        if (distance_m == 0.0)
            content.marks.push_back({shot.diagram->plateau_s.end,
                Plots::tr("plateau ends (computed)"), CurveRole::Reference});
    }
    setView(channel, arrival, sensor, content);
    content.summary = content.title;
    return content;
}

void addTubeModes(PlotContent &content, const ShockConditions &shot)
{
    const double first_Hz = firstFrequency_Hz(content);
    bool any = false;
    int across = 0;
    for (const TubeResonance &mode : shot.resonances) { // by frequency
        if (mode.frequency_Hz < first_Hz)
            continue;
        across += mode.kind == ResonanceKind::Transverse ? 1 : 0;
        const bool labelled = mode.kind != ResonanceKind::Transverse || across <= kLabelledModes;
        content.marks.push_back(
            {mode.frequency_Hz, labelled ? modeLabel(mode) : QString(), CurveRole::Reference});
        any = true;
    }
    if (any)
        content.title += Plots::tr(" – tube modes computed");
}

} // namespace dyncal
