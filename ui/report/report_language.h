// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QTranslator>

namespace dyncal {

/// While one of these lives, texts come out in the language of the report, whatever the language of
/// the window (or of the command line, which has none). A text without translation comes out in
/// English, never in the window's language. Needs a QCoreApplication.
class ReportLanguage : public QTranslator
{
public:
    explicit ReportLanguage(const std::string &code); ///< "en", "sv", as in the recipe
    ~ReportLanguage() override;
    Q_DISABLE_COPY(ReportLanguage)

    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *disambiguation = nullptr,
        int number = -1) const override;
};

} // namespace dyncal
