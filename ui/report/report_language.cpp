// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_language.h"

#include <QCoreApplication>

namespace dyncal {

ReportLanguage::ReportLanguage(const std::string &code)
{
    // A code without a translation leaves this empty: English.
    if (!load(QStringLiteral("dyncal_") + QString::fromStdString(code), QStringLiteral(":/i18n")))
        (void)load(QStringLiteral("dyncal_en"), QStringLiteral(":/i18n"));
    QCoreApplication::installTranslator(this); // the newest is asked first
}

ReportLanguage::~ReportLanguage()
{
    QCoreApplication::removeTranslator(this);
}

QString ReportLanguage::translate(
    const char *context, const char *source, const char *disambiguation, int number) const
{
    const QString text = QTranslator::translate(context, source, disambiguation, number);
    return text.isNull() ? QString::fromUtf8(source) : text;
}

} // namespace dyncal
