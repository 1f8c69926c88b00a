// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/broken_text.h"

#include <QStringList>

#include <algorithm>

namespace dyncal {

namespace {

constexpr qsizetype kLeastPart = 4; ///< letters of a word before and behind a hyphen

int widthOf(const QFontMetrics &metrics, const QString &text)
{
    return metrics.size(Qt::TextShowMnemonic, text).width();
}

/// How many letters of a word too long fit with a hyphen, 4 at least; few of them are measured, as
/// a word may have thousands.
qsizetype fittingLength(const QFontMetrics &metrics, const QString &word, int width_px)
{
    const qsizetype most = word.size() - kLeastPart;
    const auto fits = [&](qsizetype length) {
        return widthOf(metrics, word.left(length) + QChar('-')) <= width_px;
    };
    qsizetype beyond = kLeastPart + 1;
    while (beyond <= most && fits(beyond))
        beyond *= 2;
    qsizetype length = std::max(kLeastPart, beyond / 2);
    beyond = std::min(beyond, most + 1);
    while (beyond - length > 1) {
        const qsizetype middle = (length + beyond) / 2;
        (fits(middle) ? length : beyond) = middle;
    }
    return length;
}

/// The parts of a word, each but the last with its hyphen.
QStringList partsOf(const QFontMetrics &metrics, QString word, int width_px)
{
    QStringList parts;
    while (word.size() >= 2 * kLeastPart) {
        const qsizetype length = fittingLength(metrics, word, width_px);
        const bool mayFit = word.size() <= 2 * (length + kLeastPart);
        if (mayFit && widthOf(metrics, word) <= width_px)
            break;
        parts += word.left(length) + QChar('-');
        word.remove(0, length);
    }
    return parts << word;
}

} // namespace

QString brokenText(const QFontMetrics &metrics, const QString &text, int width_px)
{
    if (widthOf(metrics, text) <= width_px)
        return text;
    QStringList lines;
    QString line;
    for (const QString &word : text.split(QChar(' '))) {
        const QString longer = line.isEmpty() ? word : line + QChar(' ') + word;
        if (widthOf(metrics, longer) <= width_px) {
            line = longer;
            continue;
        }
        if (!line.isEmpty())
            lines += line;
        lines += partsOf(metrics, word, width_px);
        line = lines.takeLast();
    }
    return (lines << line).join(QChar('\n'));
}

} // namespace dyncal
