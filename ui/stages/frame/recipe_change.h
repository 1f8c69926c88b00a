// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <functional>

namespace dyncal {

/// Changes the recipe as one undo step; changes with the same `mergeKey` become one (a drag).
inline void changeRecipe(Session &session, const QString &label,
    const std::function<void(Recipe &)> &edit, const QString &mergeKey = {})
{
    Recipe next = session.recipe();
    edit(next);
    session.apply(next, label, mergeKey);
}

} // namespace dyncal
