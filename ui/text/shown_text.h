// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/foreign_text.h"

#include <QString>

#include <string_view>

namespace dyncal {

/// Foreign text for a label, a cell, a menu or a plot (core/base/foreign_text.h). Not for what a
/// person edits: that must stay what it is.
inline QString shownText(std::string_view text)
{
    return QString::fromStdString(presentableInBrief(text));
}

inline QString shownText(const QString &text)
{
    return shownText(text.toStdString());
}

/// As it is, for what a person edits, for keys, paths and numbers: never shown.
inline QString rawText(const std::string &text)
{
    return QString::fromStdString(text);
}

/// For places where '&' marks the shortcut key: a menu, a button or a label with a partner.
inline QString withoutMnemonic(QString text)
{
    return text.replace(QLatin1Char('&'), QLatin1String("&&"));
}

/// For a window's title, where "[*]" marks what is not saved.
inline QString asTitle(const QString &text)
{
    return shownText(text).replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
}

/// A cell of a table for the clipboard.
inline QString pasted(const QString &text)
{
    return QString::fromStdString(pastedCell(text.toStdString()));
}

} // namespace dyncal
