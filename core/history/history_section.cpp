// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/history/history_section.h"

#include "core/base/number_text.h"
#include "core/certificate/certificate_history.h"
#include "core/certificate/certificate_words.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr int kDigitsOfEn = 2;

/// A quantity without a unit has none printed.
std::string unitOf(const HistorySeries &series)
{
    return series.unit == "1" ? std::string() : series.unit;
}

Message enCell(double En)
{
    return std::isfinite(En) ? inNumbers(numberText(En, kDigitsOfEn)) : dash();
}

Message chartCell(const std::optional<ControlState> &state)
{
    if (!state)
        return dash();
    switch (*state) {
    case ControlState::Inside:
        return {DYNCAL_TEXT("core", "inside"), {}};
    case ControlState::Warning:
        return {DYNCAL_TEXT("core", "beyond the warning limits"), {}};
    case ControlState::Action:
        return {DYNCAL_TEXT("core", "beyond the action limits"), {}};
    }
    return dash();
}

std::vector<Message> rowOf(
    const HistorySeries &series, const SeriesEntry &entry, const EarlierCalibration &calibration)
{
    const FollowedValue &stated = entry.stated;
    const std::string unit = stated.unit == "1" ? std::string() : stated.unit;
    const bool isThere = std::isfinite(stated.value);
    return {verbatim(calibration.time),
        calibration.number > 0 ? verbatim(std::to_string(calibration.number)) : dash(),
        isThere ? valueCell(stated.value, stated.u, unit, stated.k) : dash(),
        isThere ? expandedCell(stated.value, stated.u, unit, stated.k) : dash(), enCell(entry.En),
        series.limits ? chartCell(entry.state) : dash()};
}

CertificateTable tableOf(
    const HistorySeries &series, const std::vector<EarlierCalibration> &calibrations)
{
    CertificateTable table;
    table.id = historyFigureId(series);
    table.caption = historyTitle(series.quantity);
    table.columns = {{{DYNCAL_TEXT("core", "Date"), {}}},
        {{DYNCAL_TEXT("core", "Certificate"), {}}}, {{DYNCAL_TEXT("core", "Value"), {}}, true},
        {{DYNCAL_TEXT("core", "U (k = 2)"), {}}, true}, {{"En", {}}, true},
        {{DYNCAL_TEXT("core", "Control chart"), {}}}};
    for (std::size_t i = 0; i < series.entries.size(); ++i)
        table.rows.push_back(rowOf(series, series.entries[i], calibrations[i]));
    return table;
}

/// Only a drift beyond its own U is one.
Message driftSentence(const HistorySeries &series)
{
    const YearlyDrift &drift = *series.drift;
    const std::string unit = unitOf(series);
    const std::string perYear = unit.empty() ? "1/a" : unit + "/a";
    Message stated = printedWithUncertainty(drift.perYear, drift.u, perYear, drift.k);
    return std::abs(drift.perYear) > drift.U()
        ? Message{DYNCAL_TEXT("core", "%M1: it drifts by %M2, more than its U."), {},
            {historyTitle(series.quantity), std::move(stated)}}
        : Message{DYNCAL_TEXT("core", "%M1: the drift of %M2 is within its U."), {},
            {historyTitle(series.quantity), std::move(stated)}};
}

bool isStated(const HistorySeries &series)
{
    return std::ranges::any_of(
        series.entries, [](const SeriesEntry &entry) { return std::isfinite(entry.stated.value); });
}

} // namespace

std::string historyFigureId(const HistorySeries &series)
{
    return std::string("history-") + series.quantity.name();
}

bool hasHistoryFigure(const HistorySeries &series)
{
    return std::ranges::count_if(series.entries, [](const SeriesEntry &entry) {
        return std::isfinite(entry.position);
    }) > 1;
}

Message historyTitle(const FollowedQuantity &quantity)
{
    switch (quantity.kind) {
    case FollowedKind::NaturalFrequency:
        return {DYNCAL_TEXT("core", "Undamped natural frequency"), {}};
    case FollowedKind::DampingRatio:
        return {DYNCAL_TEXT("core", "Damping ratio"), {}};
    case FollowedKind::Sensitivity:
        return {DYNCAL_TEXT("core", "Sensitivity"), {}};
    case FollowedKind::Magnitude:
        return {
            DYNCAL_TEXT("core", "Magnitude at %1"), {numberWithUnit(quantity.asked_Hz, "Hz", 4)}};
    case FollowedKind::Phase:
        return {DYNCAL_TEXT("core", "Phase at %1"), {numberWithUnit(quantity.asked_Hz, "Hz", 4)}};
    }
    return {};
}

CertificateSection historySection(const SensorHistory &history)
{
    CertificateSection section = historyToCome();
    section.paragraphs = {
        {DYNCAL_TEXT("core",
             "What the laboratory's certificates of this sensor state that are in force, this one last. En compares a value with the one before: up to 1 they agree within their U. Control limits need five calibrations."),
            {}}};
    for (const HistorySeries &series : history.series) {
        if (!isStated(series))
            continue;
        section.tables.push_back(tableOf(series, history.sensor.points));
        if (series.drift)
            section.notes.push_back(driftSentence(series));
        if (hasHistoryFigure(series))
            section.figures.push_back({historyFigureId(series), historyTitle(series.quantity)});
    }
    section.notes.push_back(
        {DYNCAL_TEXT("core",
             "Calibrations of one laboratory share tube, references and method: what they share is in every U and cancels in the difference, so that En is smaller than it would be for independent results."),
            {}});
    return section;
}

} // namespace dyncal
