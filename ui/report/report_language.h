// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QLocale>
#include <QTranslator>

namespace dyncal {

/// The texts of a report: in its own language, whatever the language of the window (or of the
/// command line, which has none). A text without translation comes out in English, never in the
/// window's language.
class ReportLanguage : public QTranslator
{
public:
    explicit ReportLanguage(const std::string &code); ///< "en", "sv", "de", as in the recipe

    const QLocale &numbers() const { return m_numbers; } ///< how it writes them

    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *disambiguation = nullptr,
        int number = -1) const override;

    /// While one of these lives, every text comes out in the language of the report. The window
    /// gets no LanguageChange, because its own texts stay; so no event may be handled meanwhile.
    /// Needs a QCoreApplication.
    class Scope
    {
    public:
        explicit Scope(ReportLanguage &language);
        ~Scope();
        Q_DISABLE_COPY(Scope)

    private:
        ReportLanguage &m_language;
    };

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QLocale m_numbers;
};

} // namespace dyncal
