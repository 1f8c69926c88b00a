// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/broken_text.h"

#include <QStringList>

namespace dyncal {

namespace {

constexpr qsizetype kLeastPart = 4; ///< letters of a word before and behind a hyphen

int widthOf(const QFontMetrics &metrics, const QString &text)
{
    return metrics.size(Qt::TextShowMnemonic, text).width();
}

/// The parts of a word, each but the last with its hyphen.
QStringList partsOf(const QFontMetrics &metrics, QString word, int width_px)
{
    QStringList parts;
    while (word.size() >= 2 * kLeastPart && widthOf(metrics, word) > width_px) {
        qsizetype length = word.size() - kLeastPart;
        while (length > kLeastPart && widthOf(metrics, word.left(length) + QChar('-')) > width_px)
            --length;
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
