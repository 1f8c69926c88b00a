// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/history_rows.h"

#include "ui/plot/curves/history_curves.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QDate>
#include <QJsonArray>

#include <cmath>

namespace dyncal {

namespace {

struct HistoryRows
{
    Q_DECLARE_TR_FUNCTIONS(HistoryRows)
};

constexpr int kDigitsOfU = 2, kDigitsOfRatio = 3;
constexpr int kCharsOfDay = 10; // "2026-01-31"

/// NaN for null, which stands for what is not stated.
double numberOf(const QJsonValue &value)
{
    return value.toDouble(kUnknown);
}

QString numberOrNone(const QJsonValue &value, int digits)
{
    return value.isDouble() ? shownNumber(value.toDouble(), digits) : QStringLiteral("–");
}

QString unitOf(const QJsonValue &of)
{
    const QString unit = shownText(of["unit"].toString());
    return unit == QLatin1String("1") ? QString() : unit;
}

QString quantityName(const QString &key)
{
    if (key == QLatin1String("f0_hz"))
        return HistoryRows::tr("Natural frequency");
    if (key == QLatin1String("damping_ratio"))
        return HistoryRows::tr("Damping ratio");
    if (key == QLatin1String("sensitivity"))
        return HistoryRows::tr("Sensitivity");
    return key == QLatin1String("magnitude") ? HistoryRows::tr("Magnitude")
                                             : HistoryRows::tr("Phase");
}

QString stateText(const QString &state)
{
    if (state == QLatin1String("inside"))
        return HistoryRows::tr("● inside");
    if (state == QLatin1String("warning"))
        return HistoryRows::tr("▲ beyond the warning limits");
    return state == QLatin1String("action") ? HistoryRows::tr("■ beyond the action limits")
                                            : QStringLiteral("–");
}

QString remarkOf(const QJsonValue &point, const QJsonValue &value)
{
    QStringList remarks;
    if (point["blocked"].isString())
        remarks << HistoryRows::tr("blocked: it states nothing");
    else if (!value["value"].isDouble())
        remarks << HistoryRows::tr("not stated");
    else if (!value["u"].isDouble())
        remarks << HistoryRows::tr("without complete U");
    if (std::abs(value["e_n"].toDouble()) > 1.0)
        remarks << HistoryRows::tr("differs from the one before by more than U");
    if (point["methods_changed"].isString())
        remarks << HistoryRows::tr("other versions of the method than before");
    if (!point["remarks"].toArray().isEmpty())
        remarks << HistoryRows::tr("results.json is not as the run wrote it");
    return remarks.join(QStringLiteral("; "));
}

bool isConspicuous(const QJsonValue &value)
{
    const QString state = value["control_state"].toString();
    return std::abs(value["e_n"].toDouble()) > 1.0
        || (!state.isEmpty() && state != QLatin1String("inside"));
}

double yearOf(const QString &time)
{
    const QDate day = QDate::fromString(time.left(kCharsOfDay), Qt::ISODate);
    return day.isValid() ? day.year() + (day.dayOfYear() - 0.5) / day.daysInYear() : kUnknown;
}

QVariantList rowOf(const QJsonValue &point, const QJsonValue &value)
{
    const QString unit = unitOf(value);
    const double stated = numberOf(value["value"]), U = numberOf(value["u_expanded"]);
    const bool hasU = std::isfinite(U);
    const ShownResult shown = shownResult(stated, hasU ? U : numberOf(value["u"]), unit);
    const qint64 number = point["certificate"].toInteger();
    return {shownText(point["time"].toString()).left(kCharsOfDay),
        number > 0 ? QVariant(number) : QVariant(),
        std::isfinite(stated) ? shown.value : QStringLiteral("–"),
        hasU ? shown.u : QStringLiteral("–"), numberOrNone(value["k"], kDigitsOfRatio),
        numberOrNone(value["e_n"], kDigitsOfU), stateText(value["control_state"].toString()),
        remarkOf(point, value)};
}

std::optional<ControlLimits> limitsOf(const QJsonValue &series)
{
    const QJsonValue limits = series["limits"];
    if (!limits.isObject())
        return std::nullopt;
    return ControlLimits{.mean = numberOf(limits["mean"]), .sigma = numberOf(limits["sigma"])};
}

QString driftText(const QJsonValue &series)
{
    const QJsonValue drift = series["drift"];
    if (!drift.isObject())
        return HistoryRows::tr("A drift is stated from %1 calibrations with complete U on.")
            .arg(kFewestForDrift);
    return HistoryRows::tr("Drift in a year: %1 (k = %2, %3 calibrations).")
        .arg(shownWithU(numberOf(drift["per_year"]), numberOf(drift["u_expanded"]), unitOf(series)),
            numberOrNone(drift["k"], kDigitsOfRatio))
        .arg(drift["calibrations"].toInteger());
}

QString leftOutText(const QJsonArray &leftOut)
{
    QStringList lines;
    for (const QJsonValue one : leftOut) {
        const QString file = shownText(one["file"].toString()), why = one["why"].toString();
        if (why == QLatin1String("not_in_force"))
            lines << HistoryRows::tr("Left out, withdrawn or replaced: %1").arg(file);
        else if (why == QLatin1String("same_recordings"))
            lines << HistoryRows::tr("Left out, a newer result of the same recordings counts: %1")
                         .arg(file);
        else
            lines << HistoryRows::tr("Left out, without serial number: %1").arg(file);
    }
    return lines.join('\n');
}

} // namespace

QString seriesTitle(const QJsonValue &series)
{
    const QString name = quantityName(series["quantity"].toString());
    if (!series["asked_hz"].isDouble())
        return name;
    const double row_Hz = numberOf(series["frequency_hz"]);
    return HistoryRows::tr("%1 at %2")
        .arg(name,
            shownQuantity(std::isfinite(row_Hz) ? row_Hz : numberOf(series["asked_hz"]),
                QStringLiteral("Hz")));
}

std::vector<QVariantList> historyRows(const QJsonObject &history, int series)
{
    const QJsonArray points = history["points"].toArray();
    const QJsonValue values = history["series"][series]["values"];
    std::vector<QVariantList> rows;
    rows.reserve(static_cast<std::size_t>(points.size()));
    for (int i = 0; i < points.size(); ++i)
        rows.push_back(rowOf(points[i], values[i]));
    return rows;
}

PlotContent historyContent(const QJsonObject &history, int series)
{
    const QJsonArray points = history["points"].toArray();
    const QJsonValue shown = history["series"][series];
    std::vector<DatedValue> values;
    for (int i = 0; i < points.size(); ++i) {
        const QJsonValue value = shown["values"][i];
        const DatedValue dated{yearOf(points[i]["time"].toString()), numberOf(value["value"]),
            numberOf(value["u_expanded"]), isConspicuous(value)};
        // A value in another unit than the newest is in the table only.
        if (std::isfinite(dated.year) && std::isfinite(dated.value)
            && value["unit"] == shown["unit"])
            values.push_back(dated);
    }
    return historyCurves(seriesTitle(shown), unitOf(shown), values, limitsOf(shown));
}

QString historySummary(const QJsonObject &history, int series)
{
    const QJsonValue shown = history["series"][series];
    QStringList sentences{driftText(shown)};
    if (!shown["limits"].isObject())
        sentences << HistoryRows::tr("Control limits are drawn from %1 calibrations on.")
                         .arg(kFewestForLimits);
    QString text = sentences.join(' ');
    if (const QString leftOut = leftOutText(history["left_out"].toArray()); !leftOut.isEmpty())
        text += '\n' + leftOut;
    return text;
}

} // namespace dyncal
