// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

#include <optional>

namespace dyncal {

/// Numbers as the window shows them: SI prefix, the decimal mark of the language. For display only;
/// files go through core/base/number_text.h.
QString shownQuantity(double value, const QString &unit, int digits = 4);
QString shownNumber(double value, int digits = 4);
/// "–" where there is no value.
QString shownQuantity(const std::optional<double> &value, const QString &unit, int digits = 4);

/// In the unit, prefix included, in which shownQuantity(beside, ...) shows another: an uncertainty
/// beside its value.
QString shownQuantityBeside(double value, double beside, const QString &unit, int digits);

/// A number as people type it: ',' or '.' as decimal mark, blanks around it. Empty if it is none
/// or not finite.
std::optional<double> typedNumber(QString text);

} // namespace dyncal
