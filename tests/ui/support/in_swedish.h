// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/preferences/language.h"

#include <QLocale>

namespace dyncal::test {

/// The window's language and decimal mark are Swedish while one of these lives.
class InSwedish
{
public:
    InSwedish() { m_language.install("sv"); }
    ~InSwedish() { QLocale::setDefault(m_before); }
    InSwedish(const InSwedish &) = delete;
    InSwedish &operator=(const InSwedish &) = delete;

private:
    QLocale m_before;
    Language m_language;
};

} // namespace dyncal::test
