// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/number_locale.h"

namespace dyncal {

QLocale numberLocale(const QString &code)
{
    QLocale locale = code == QLatin1String("sv") ? QLocale(QLocale::Swedish, QLocale::Sweden)
        : code == QLatin1String("de")            ? QLocale(QLocale::German, QLocale::Germany)
                                                 : QLocale::c();
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

QString numberLanguage()
{
    for (const char *code : {"sv", "de"})
        if (QLocale().language() == numberLocale(code).language())
            return code;
    return QStringLiteral("en");
}

} // namespace dyncal
