// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

namespace dyncal {

/// The text with no-break spaces where a line must not end: between a number and its unit, behind
/// "\u00b1", and inside "(k = 2)" and "(u = 3 Hz)" (SI brochure, 5.4.3). For the cells of tables.
QString keptTogether(QString text);

/// The same for a sentence, in which a number may also count things: known units alone stay with
/// theirs. For show only; what is copied stays as it is.
QString withUnitsKept(QString text);

} // namespace dyncal
