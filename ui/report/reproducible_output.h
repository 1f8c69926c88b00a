// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QHashSeed>
#include <QLocale>

namespace dyncal {

/// While one of these lives, what is drawn comes out the same in every process: it fixes the order
/// in hash tables (which Qt makes random, and which the fonts in a PDF follow) and how numbers are
/// written: as the document's language does. For the thread of the window only.
class ReproducibleOutput
{
public:
    explicit ReproducibleOutput(const QLocale &numbers)
    {
        QHashSeed::setDeterministicGlobalSeed();
        QLocale::setDefault(numbers);
    }
    ~ReproducibleOutput()
    {
        QLocale::setDefault(m_locale);
        QHashSeed::resetRandomGlobalSeed();
    }
    Q_DISABLE_COPY(ReproducibleOutput)

private:
    QLocale m_locale; ///< the default before
};

} // namespace dyncal
