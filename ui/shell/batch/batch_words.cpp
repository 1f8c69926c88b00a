// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_words.h"

#include "core/base/constants.h"
#include "core/base/rounding.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct Words
{
    Q_DECLARE_TR_FUNCTIONS(BatchWords)
};

QString glyphOf(ShownState state)
{
    switch (state) {
    case ShownState::Failed:
    case ShownState::Blocked:
        return QStringLiteral("■");
    case ShownState::Cautions:
        return QStringLiteral("▲");
    case ShownState::Running:
        return QStringLiteral("⟳");
    case ShownState::Missing:
        return QStringLiteral("□");
    case ShownState::Done:
        break;
    }
    return QStringLiteral("●");
}

QString resultText(const StatedResult &result)
{
    return shownWithU(result.value, result.expanded.value_or(kUnknown), shownText(result.unit),
        kDigitsWithoutUncertainty);
}

QString markText(const FindingMark &mark)
{
    const QString id = shownText(mark.id);
    return mark.shot > 0 ? Words::tr("%1, shot %2").arg(id).arg(mark.shot) : id;
}

QString marksLine(const SensorOutcome &record, Severity severity)
{
    QStringList marks;
    for (const FindingMark &mark : record.findings)
        if (mark.severity == severity)
            marks << markText(mark);
    return marks.isEmpty()
        ? QString()
        : severityWord(severity) + QStringLiteral(": ") + marks.join(QStringLiteral("; "));
}

} // namespace

ShownState shownState(const SensorNow &sensor)
{
    if (sensor.isRunning)
        return ShownState::Running;
    switch (sensor.standing.record.state) {
    case SensorState::Done:
        return ShownState::Done;
    case SensorState::Cautions:
        return ShownState::Cautions;
    case SensorState::Blocked:
        return ShownState::Blocked;
    case SensorState::Failed:
        return ShownState::Failed;
    case SensorState::Missing:
        break;
    }
    return ShownState::Missing;
}

QString stateWord(ShownState state)
{
    switch (state) {
    case ShownState::Failed:
        return Words::tr("failed");
    case ShownState::Blocked:
        return Words::tr("blocked");
    case ShownState::Cautions:
        return Words::tr("cautions");
    case ShownState::Running:
        return Words::tr("running");
    case ShownState::Missing:
        return Words::tr("missing");
    case ShownState::Done:
        break;
    }
    return Words::tr("done");
}

QString stateText(ShownState state)
{
    return glyphOf(state) + QLatin1Char(' ') + stateWord(state);
}

QString batchTallyText(const BatchMoment &moment)
{
    QStringList parts;
    for (const ShownState state : kShownStates) {
        const auto count = std::ranges::count(moment.sensors, state, shownState);
        if (count > 0)
            parts << QString::number(count) + QLatin1Char(' ') + stateWord(state);
    }
    const QString all = Words::tr("%n sensor(s)", nullptr, static_cast<int>(moment.sensors.size()));
    return parts.isEmpty() ? all : all + QStringLiteral(": ") + parts.join(QStringLiteral(", "));
}

QString keyResultText(const SensorOutcome &record, const char *quantity)
{
    const auto found = std::ranges::find(record.results, quantity, &StatedResult::quantity);
    return found == record.results.end() ? QString() : resultText(*found);
}

QString worstFindingText(const SensorOutcome &record)
{
    const auto worst = worstFinding(record);
    if (!worst || worst->severity == Severity::Info)
        return {};
    const auto others = std::ranges::count_if(record.findings, [](const FindingMark &mark) {
        return mark.severity != Severity::Info;
    }) - 1;
    const QString text = severityGlyph(worst->severity) + QLatin1Char(' ') + markText(*worst);
    return others > 0 ? Words::tr("%1 (and %2 more)").arg(text).arg(others) : text;
}

QString reasonText(const SensorOutcome &record)
{
    return record.said.text.empty() ? shownText(record.reason) : translated(record.said.message());
}

QString recordText(const SensorNow &sensor)
{
    const SensorOutcome &record = sensor.standing.record;
    QStringList lines{
        shownText(sensor.standing.id) + QStringLiteral(": ") + stateWord(shownState(sensor))};
    if (!record.reason.empty())
        lines << reasonText(record);
    for (const StatedResult &result : record.results)
        lines << shownText(result.quantity) + QStringLiteral(" = ") + resultText(result)
                + (result.k ? Words::tr(" (k = %1)").arg(shownNumber(*result.k, 3)) : QString());
    for (const Severity severity : {Severity::Block, Severity::Caution, Severity::Info})
        if (const QString line = marksLine(record, severity); !line.isEmpty())
            lines << line;
    return lines.join(QLatin1Char('\n'));
}

} // namespace dyncal
