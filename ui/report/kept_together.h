// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

namespace dyncal {

/// The text with no-break spaces where a line must not end: between a number and its unit, behind
/// "\u00b1", and inside "(k = 2)" (SI brochure, 5.4.3). For the cells of tables; a sentence may
/// break anywhere.
QString keptTogether(QString text);

} // namespace dyncal
