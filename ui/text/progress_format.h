// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

namespace dyncal {

/// How far a bar is, with the blank before the sign that every other number has.
inline QString progressFormat()
{
    return QStringLiteral("%p\u00a0%");
}

} // namespace dyncal
