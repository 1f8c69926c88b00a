// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/kept_units.h"

#include <QRegularExpression>

namespace dyncal {

QString withUnitsKept(QString text)
{
    static const QRegularExpression parted(
        QStringLiteral("(?<=[0-9]) (?=(?:%|°C|dB|(?:[pnuµmkMGT]i?)?(?:Pa|Hz|V|A|s|S/s|m|g|K|bar|B))"
                       "(?![\\w]))"),
        QRegularExpression::UseUnicodePropertiesOption);
    text.replace(QLatin1String("(u = "), QStringLiteral("(u%1=%1").arg(QChar(QChar::Nbsp)));
    return text.replace(parted, QString(QChar::Nbsp));
}

} // namespace dyncal
