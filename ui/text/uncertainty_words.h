// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/propagation.h"

#include <QString>

#include <string>

namespace dyncal {

/// What a u in a budget is counted in.
enum class CountedIn {
    Unit, ///< of the input: K, Pa, or a plain number
    Value, ///< relative to the reported value
    Own, ///< the unit of the reported value itself
};

/// An input of a budget in words of the window.
struct InputWords
{
    QString name; ///< "Distance, Side 1"; a key that is not known keeps itself
    QString unit; ///< of CountedIn::Unit
    CountedIn in = CountedIn::Unit;
};
InputWords inputWords(const std::string &quantity);

QString distributionText(Distribution distribution);
QString dofText(double dof); ///< "∞" where nothing limits it

} // namespace dyncal
