// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace dyncal {

/// A template that comes with the program: the file of its name in resources/templates.
struct BuiltInTemplate
{
    std::string name;
    std::string json;
};

/// All of them, the default first.
const std::vector<BuiltInTemplate> &builtInTemplates();

} // namespace dyncal
