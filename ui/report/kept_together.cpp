// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/kept_together.h"

#include <QRegularExpression>

namespace dyncal {

QString keptTogether(QString text)
{
    static const QRegularExpression beforeUnit(
        QStringLiteral("(?<=\\d) (?=[^\\s\\d(\u00b1\u2026\u2013])"));
    static const QRegularExpression behindSign(QStringLiteral("(?<=\u00b1) (?=\\d)"));
    static const QRegularExpression factor(QStringLiteral("\\(k = ([^)]*)\\)"));
    const QString kept(QChar::Nbsp);
    text.replace(beforeUnit, kept);
    text.replace(behindSign, kept);
    return text.replace(factor, QStringLiteral("(k%1=%1\\1)").arg(kept));
}

} // namespace dyncal
