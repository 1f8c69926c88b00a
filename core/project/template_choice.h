// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/project/certificate_template.h"
#include "core/project/recipe.h"

#include <map>
#include <string>

namespace dyncal {

/// A template as it was chosen, with what it needs. The default is the built-in "accredited".
struct ChosenTemplate
{
    CertificateTemplate layout = {};
    std::string file = {}; ///< where it was read; "" = built in
    std::string logo = {}; ///< bytes of the logo's file; "" = none
};

/// Whether a recipe's certificate.template names a file: it ends in ".json". All else is the name
/// of a built-in one.
bool isTemplateFile(const std::string &name);

/// A file that the recipe names relative to its own, `recipePath` ("" = none), is named by its
/// place from then on; for whoever reads a recipe and prints it.
void locateTemplate(const std::string &recipePath, Recipe &recipe);

/// The built-in template of that name, or the one in that file, with its logo beside it. Fails
/// (Usage) on a name that is not known (lists those that are) and as parseTemplate() with the
/// file's name, (FileUnreadable) where the file or its logo cannot be read or is too large, and
/// (Usage) where the logo is no PNG of at most 4000 x 4000 pixels and no SVG that stands by itself.
Result<ChosenTemplate> chooseTemplate(const std::string &name);

/// Languages of the document: the template's, or else the recipe's.
const std::vector<std::string> &documentLanguages(
    const ChosenTemplate &chosen, const Recipe &recipe);

/// Copies of a template's file and logo, as a run and an issued certificate keep them: names below
/// the folder, and bytes. The template names its logo by the copy's name. None of a built-in one.
std::map<std::string, std::string> keptTemplateFiles(const ChosenTemplate &chosen);

/// The recipe as it lies beside these copies: it names the template's copy.
Recipe withKeptTemplate(Recipe recipe, const ChosenTemplate &chosen);

} // namespace dyncal
