// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>

namespace dyncal {

/// What the window calls a key of the recipe ("window.end_s"), in its language; empty for a word
/// that is none.
QString recipeLabel(const QString &key);

/// A sentence of ours that names keys, for the window: their labels, quoted, in their places.
QString withRecipeLabels(const QString &sentence);

} // namespace dyncal
