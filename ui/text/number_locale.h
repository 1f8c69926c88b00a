// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QLocale>

namespace dyncal {

/// How numbers look beside the words of a language ("en", "sv", "de"): the comma as decimal mark in
/// Swedish and German, else the point. No signs group digits, so that a shown number can be typed
/// back as it stands.
QLocale numberLocale(const QString &code);

/// The language whose way of writing numbers is the default now: "sv", "de", else "en".
QString numberLanguage();

} // namespace dyncal
