// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/kept_together.h"

#include <QRegularExpression>

namespace dyncal {

namespace {

const QString kKept(QChar::Nbsp);

/// Behind "±", and in brackets.
QString signsKept(QString text)
{
    static const QRegularExpression behindSign(QStringLiteral("(?<=\u00b1) (?=\\d)"));
    static const QRegularExpression factor(QStringLiteral("\\(([ku]) = ([^)]*)\\)"));
    text.replace(behindSign, kKept);
    return text.replace(factor, QStringLiteral("(\\1%1=%1\\2)").arg(kKept));
}

} // namespace

QString keptTogether(QString text)
{
    static const QRegularExpression beforeUnit(
        QStringLiteral("(?<=\\d) (?=[^\\s\\d(\u00b1\u2026\u2013])"));
    return signsKept(text.replace(beforeUnit, kKept));
}

QString withUnitsKept(QString text)
{
    static const QRegularExpression parted(
        QStringLiteral("(?<=[0-9]) (?=(?:%|°C|dB|(?:[pnuµmkMGT]i?)?(?:Pa|Hz|V|A|s|S/s|m|g|K|bar|B))"
                       "(?![\\w]))"),
        QRegularExpression::UseUnicodePropertiesOption);
    return signsKept(text.replace(parted, kKept));
}

} // namespace dyncal
