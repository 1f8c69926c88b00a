// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QHashSeed>
#include <QLocale>

namespace dyncal {

/// While one of these lives, what is drawn comes out the same in every process: the order of hashes
/// (fonts in a PDF follow it; Qt makes it random) and the decimal mark of numbers ('.', as in every
/// file that is written). For the thread of the window only.
class ReproducibleOutput
{
public:
    ReproducibleOutput()
    {
        QHashSeed::setDeterministicGlobalSeed();
        QLocale::setDefault(QLocale::c());
    }
    ~ReproducibleOutput()
    {
        QLocale::setDefault(m_locale);
        QHashSeed::resetRandomGlobalSeed();
    }
    Q_DISABLE_COPY(ReproducibleOutput)

private:
    QLocale m_locale; ///< the default one of before
};

} // namespace dyncal
