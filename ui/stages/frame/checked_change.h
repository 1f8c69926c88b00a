// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <functional>

class QWidget;

namespace dyncal {

/// As changeRecipe(), unless a file with this recipe would be refused: then the reason is said
/// below `field`, nothing changes, and the answer is false.
bool changeIfAllowed(Session &session, QWidget *field, const QString &label,
    const std::function<void(Recipe &)> &edit);

} // namespace dyncal
