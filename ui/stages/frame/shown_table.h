// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QStringList>
#include <QVector>

namespace dyncal {

/// What a table shows: headers and rows of words.
struct ShownTable
{
    QStringList headers;
    QVector<QStringList> rows;
};

} // namespace dyncal
