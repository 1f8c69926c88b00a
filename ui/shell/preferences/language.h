// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QTranslator>

namespace dyncal {

/// The language of the window: our own sentences, Qt's own dialogs and the way numbers are shown.
/// Installing sends LanguageChange to every widget. Files always use '.' whatever the language.
class Language
{
public:
    ~Language();
    void install(const QString &code); ///< "en" or "sv"
    QString code() const { return m_code; }

private:
    QString m_code;
    QTranslator m_own;
    QTranslator m_qt;
    QTranslator m_qtMore; ///< what the translation of Qt lacks
};

} // namespace dyncal
