// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/checked_change.h"

#include "core/project/recipe.h"
#include "ui/stages/frame/refusal_note.h"
#include "ui/text/core_text.h"

namespace dyncal {

bool changeIfAllowed(Session &session, QWidget *field, const QString &label,
    const std::function<void(Recipe &)> &edit)
{
    Recipe next = session.recipe();
    edit(next);
    const Result<Recipe> read = parseRecipe(recipeJson(next));
    showRefusal(field, read ? QString() : translated(read.error().message));
    if (read)
        session.apply(next, label);
    return read.has_value();
}

} // namespace dyncal
