// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/filled_words.h"

#include "core/base/message_places.h"
#include "ui/text/quantity_format.h"

#include <QRegularExpression>

#include <string_view>

namespace dyncal {

namespace {

constexpr QChar kGroupSpace(0x202f); // narrow, and no line breaks there
constexpr qsizetype kGroup = 3;
constexpr qsizetype kMostUngrouped = 4; ///< a fifth digit makes groups (SI brochure, 5.4.4)

bool hasPlace(const char *text, const char *kind, std::size_t argument)
{
    const std::string place = kind + std::to_string(argument + 1);
    return std::string_view(text).find(place) != std::string_view::npos;
}

QString groupedWhole(QString digits)
{
    if (digits.size() > kMostUngrouped)
        for (qsizetype at = digits.size() - kGroup; at > 0; at -= kGroup)
            digits.insert(at, kGroupSpace);
    return digits;
}

QString groupedDecimals(QString digits)
{
    if (digits.size() > kMostUngrouped)
        for (qsizetype at = (digits.size() - 1) / kGroup * kGroup; at > 0; at -= kGroup)
            digits.insert(at, kGroupSpace);
    return digits;
}

/// Every number of a text of numbers and units. Digits of a unit ("N/mm2") are part of a word.
QString numbersIn(const QString &text, QChar mark)
{
    static const QRegularExpression number(QStringLiteral(
        "(?:(?<![\\w.^])|(?<=\u00b1 j))(\\d+)(?:\\.(\\d+))?((?:e[-+]?\\d+)?)(?![\\w.])"));
    QString shown;
    qsizetype taken = 0;
    for (auto match = number.globalMatch(text); match.hasNext();) {
        const QRegularExpressionMatch found = match.next();
        shown += QStringView(text).mid(taken, found.capturedStart() - taken);
        shown += groupedWhole(found.captured(1));
        if (found.capturedLength(2) > 0)
            shown += mark + groupedDecimals(found.captured(2));
        shown += found.capturedView(3);
        taken = found.capturedEnd();
    }
    shown += QStringView(text).mid(taken);
    return shown;
}

std::vector<std::string> markedArguments(const Message &message, QChar mark)
{
    std::vector<std::string> arguments = message.arguments;
    if (mark == QLatin1Char('.') || std::string_view(message.text) == "%1")
        return arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (isVerbatimPlace(message.text, i))
            continue;
        const QString text = QString::fromStdString(arguments[i]);
        const QString shown
            = hasPlace(message.text, "%L", i) ? numbersIn(text, mark) : inDecimalMark(text, mark);
        arguments[i] = shown.toStdString();
    }
    return arguments;
}

} // namespace

bool isVerbatimPlace(const char *text, std::size_t argument)
{
    return hasPlace(text, "%V", argument);
}

QString filledWords(const Message &message,
    const std::function<QString(const char *text)> &translate, QChar decimalMark,
    ArgumentText length)
{
    const auto shown = [&](const Message &sentence) {
        return filledWords(sentence, translate, decimalMark, length).toStdString();
    };
    return QString::fromStdString(withSentences(
        message, std::string("\n"), shown, [&](const std::vector<std::string> &within) {
            return fillPlaces(translate(message.text).toStdString(),
                markedArguments(message, decimalMark), length, within);
        }));
}

} // namespace dyncal
