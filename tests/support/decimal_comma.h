// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <clocale>

namespace dyncal::testing {

/// While one of these lives the C library is in de_DE.UTF-8, whether this machine has that locale
/// or not: it is made in a folder of its own (localedef of libc-bin, sources of package locales).
class DecimalComma
{
public:
    DecimalComma()
    {
        const QString compiler = QStandardPaths::findExecutable(
            "localedef", {"/usr/bin", "/usr/sbin", "/bin", "/sbin"});
        QProcess::execute(
            compiler, {"-i", "de_DE", "-f", "UTF-8", m_folder.filePath("de_DE.UTF-8")});
        qputenv("LOCPATH", m_folder.path().toUtf8());
        m_isInForce = std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr
            && *std::localeconv()->decimal_point == ',';
    }
    ~DecimalComma()
    {
        std::setlocale(LC_ALL, "C");
        qunsetenv("LOCPATH");
    }
    Q_DISABLE_COPY(DecimalComma)

    bool isInForce() const { return m_isInForce; }

private:
    QTemporaryDir m_folder;
    bool m_isInForce = false;
};

} // namespace dyncal::testing
