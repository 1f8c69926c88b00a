// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/preferences/language.h"

#include "ui/text/number_locale.h"

#include <QCoreApplication>

namespace dyncal {

Language::~Language()
{
    for (QTranslator *translator : {&m_own, &m_qt, &m_qtMore})
        QCoreApplication::removeTranslator(translator);
}

void Language::install(const QString &code)
{
    if (code == m_code)
        return;
    m_code = code;
    for (QTranslator *translator : {&m_own, &m_qt, &m_qtMore})
        QCoreApplication::removeTranslator(translator);
    QLocale::setDefault(numberLocale(code));
    const auto install = [](QTranslator &translator, const QString &name) {
        if (translator.load(name, ":/i18n"))
            QCoreApplication::installTranslator(&translator);
    };
    install(m_qt, "qt_" + code);
    install(m_qtMore, "qt_" + code + "_more");
    install(m_own, "dyncal_" + code);
}

} // namespace dyncal
