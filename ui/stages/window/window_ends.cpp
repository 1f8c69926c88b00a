// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/window/window_ends.h"

#include "ui/text/quantity_format.h"

#include <QCoreApplication>
#include <QStringList>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct EndText
{
    Q_DECLARE_TR_FUNCTIONS(WindowEnds)
};

/// The shots whose plateau is over before their end, each with when.
QStringList endedPlateaus(const WindowSettings &settings, const CalibrationResults &results)
{
    QStringList early;
    if (!results.expected)
        return early;
    for (const ShockConditions &shot : results.expected->conditions.shots) {
        const Auto<double> end_s = settings.endOfShot_s(shot.shot);
        if (shot.plateau_s && !end_s.isAuto() && *shot.plateau_s < *end_s.value)
            early << EndText::tr("%1 (%2)").arg(shot.shot).arg(
                shownQuantity(*shot.plateau_s, "s", 3));
    }
    return early;
}

QString whoseEnd(const WindowSettings &settings, Index shot)
{
    if (settings.endAtPlateau)
        return EndText::tr("Each shot ends with its own plateau.");
    if (hasOwnEnds(settings))
        return settings.endOfShot_s(shot).isAuto()
            ? EndText::tr("Set for each shot; that of shot %1 is automatic.").arg(shot)
            : EndText::tr("Set for each shot; this is the end of shot %1 alone.").arg(shot);
    return settings.end_s.isAuto() ? EndText::tr("Automatic: each shot has an end of its own.")
                                   : EndText::tr("One end, common to all shots.");
}

} // namespace

bool hasOwnEnds(const WindowSettings &settings)
{
    return !settings.ownEnds_s.empty();
}

void giveOwnEnds(WindowSettings &settings, std::size_t shots)
{
    settings.ownEnds_s.assign(shots, settings.end_s);
    settings.end_s = {}; // the recipe has one of them
}

void giveCommonEnd(WindowSettings &settings, Index shot)
{
    settings.end_s = settings.endOfShot_s(shot);
    settings.ownEnds_s.clear();
}

void typeEnd(WindowSettings &settings, Index shot, const Auto<double> &end_s)
{
    settings.endAtPlateau = false;
    const auto at = static_cast<std::size_t>(shot - 1);
    if (hasOwnEnds(settings) && shot >= 1 && at < settings.ownEnds_s.size())
        settings.ownEnds_s[at] = end_s;
    else
        settings.end_s = end_s;
}

std::optional<RecordEnd> lastEnd(
    const WindowSettings &settings, const CalibrationResults &results, Index shot)
{
    std::optional<RecordEnd> first;
    if (!results.window || !results.captures)
        return first;
    for (const WindowedResponse &response : results.window->responses) {
        const auto at = static_cast<std::size_t>(response.shot - 1);
        const auto &shots = results.captures->set.shots;
        const Channel *dut
            = at < shots.size() ? shots[at].channelWithRole(ChannelRole::Dut) : nullptr;
        if (!dut || (hasOwnEnds(settings) && response.shot != shot))
            continue;
        const double end_s = dut->t0_s + dut->duration_s() - response.start_s;
        // A sample less: what is after it is rounded to whole samples.
        const double last_s = end_s - 1.0 / dut->sampleRate_Hz;
        if (!first || last_s < first->end_s)
            first = RecordEnd{last_s, response.shot};
    }
    return first;
}

QString endText(const WindowSettings &settings, const CalibrationResults &results, Index shot)
{
    QStringList said{whoseEnd(settings, shot)};
    if (settings.endAtPlateau)
        return said.front();
    if (const QStringList early = endedPlateaus(settings, results); !early.isEmpty())
        said << EndText::tr("The plateau is over before it in: %1.")
                    .arg(early.join(QStringLiteral(", ")));
    const Auto<double> end_s = settings.endOfShot_s(shot);
    const std::optional<RecordEnd> last = lastEnd(settings, results, shot);
    if (last && !end_s.isAuto() && *end_s.value >= last->end_s)
        said << EndText::tr("The record of shot %1 ends here.").arg(last->shot);
    return said.join(QLatin1Char(' '));
}

} // namespace dyncal
