// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/preferences/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace dyncal {

Language::~Language()
{
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
}

void Language::install(const QString &code)
{
    if (code == m_code)
        return;
    m_code = code;
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_qt);
    // Without grouping signs a shown number can be typed back as it stands.
    QLocale locale(code == "sv" ? QLocale(QLocale::Swedish, QLocale::Sweden) : QLocale::c());
    locale.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    QLocale::setDefault(locale);
    if (m_own.load("dyncal_" + code, ":/i18n"))
        QCoreApplication::installTranslator(&m_own);
    if (m_qt.load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
}

} // namespace dyncal
