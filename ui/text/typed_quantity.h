// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>
#include <QStringList>

#include <optional>

namespace dyncal {

/// Letters that a number with its unit may have: a table pasted by mistake is none, and its undo
/// would be kept.
inline constexpr int kMostLettersOfNumber = 200;

/// A unit as shown beside a number: SI value = shown value * si.
struct ShownUnit
{
    QString text;
    double si = 1.0;
};

/// Of a number that stands in a field: what is typed there comes back as it was.
inline constexpr int kFieldDigits = 10;

/// What was typed into a field: its value in the field's unit, or why it is none.
struct TypedQuantity
{
    std::optional<double> value;
    QString fault; ///< a sentence; empty with a value
};

/// Reads "21 °C", "10 MHz", "1,5 ms" or a bare number, which is in the field's unit. Units that
/// differ in case only ("mHz", "MHz") are told apart by it, others are read in either case. A mark
/// that may group thousands ("1,234" where the language's mark is '.') is refused, as in the
/// header of a text file.
TypedQuantity typedQuantity(const QString &text, const ShownUnit &field);

/// The units that a field of this unit understands, its own first; empty for a pure number.
QStringList understoodUnits(const ShownUnit &field);

} // namespace dyncal
