// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace dyncal {

/// A key of the recipe and what the window calls it.
struct RecipeKey
{
    std::string path; ///< "window.end_s", "import.exclude[].shot", "import.channels{}.unit"
    const char *label = ""; ///< "end of the window", marked for translation
};

} // namespace dyncal
