// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/report_language.h"

#include "ui/text/number_locale.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>
#include <QEvent>

namespace dyncal {

ReportLanguage::ReportLanguage(const std::string &code)
    : m_numbers(numberLocale(rawText(code)))
{
    // A code without a translation gets English: dyncal_en has the plural forms, the sources the
    // rest.
    if (!load(QStringLiteral("dyncal_") + rawText(code), QStringLiteral(":/i18n")))
        (void)load(QStringLiteral("dyncal_en"), QStringLiteral(":/i18n"));
}

QString ReportLanguage::translate(
    const char *context, const char *source, const char *disambiguation, int number) const
{
    const QString text = QTranslator::translate(context, source, disambiguation, number);
    return text.isNull() ? QString::fromUtf8(source) : text;
}

/// Installing and removing a translator sends this event to the application, and every window would
/// be laid out anew each time.
bool ReportLanguage::eventFilter(QObject *watched, QEvent *event)
{
    return watched == QCoreApplication::instance() && event->type() == QEvent::LanguageChange;
}

ReportLanguage::Scope::Scope(ReportLanguage &language)
    : m_language(language)
{
    QCoreApplication::instance()->installEventFilter(&language);
    QCoreApplication::installTranslator(&language); // the newest is asked first
}

ReportLanguage::Scope::~Scope()
{
    QCoreApplication::removeTranslator(&m_language);
    QCoreApplication::instance()->removeEventFilter(&m_language);
}

} // namespace dyncal
