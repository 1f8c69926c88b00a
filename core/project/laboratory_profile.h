// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/project/json_codec.h"
#include "core/project/recipe_sections.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// Internal to core/project: a laboratory's profile as it was read. `sections` is a part of a
/// recipe; without a mark it is a profile of the first kind, a recipe without name and version.
struct LaboratoryProfile
{
    Json sections;
    std::optional<ProfileMark> mark;
    Json demands = nullptr; ///< what must hold before a certificate is issued; no part of a recipe
};

/// Takes a profile's JSON text apart. `path` names it in sentences. Fails (Usage) on malformed JSON
/// and where it holds anything but what is the same for every calibration of a laboratory: import,
/// checks and, with the schema dyncal-profile/1, the tube in "shock", "budget", "correlations" and
/// "cmc" in "uncertainty", "chain", and what it demands of a certificate ("issue", true or false
/// "second_name"). Other values are not looked at.
Result<LaboratoryProfile> laboratoryProfile(const std::string &text, const std::string &path);

/// Whether a second person must review what is issued under the profile.
bool demandsSecondName(const ProfileMark &mark);

/// Whether a document says which file states the chain's response; the file is beside it.
bool namesChain(const Json &document);

/// Puts one document over another as putOver(), with what a laboratory states line by line
/// (uncertainty.budget by quantity, .correlations by the pair, .cmc by what it is of): a line below
/// stays unless `upper` has its name. A chain's file of `upper` takes the place of all of the chain
/// below.
void joinRecipes(Json &lower, const Json &upper);

/// The sections "profile" of a recipe, null without one.
Field<Recipe> profileSection();

/// The keys ("shock.driven_length_m", "uncertainty.budget{t1_k}") whose values in `recipe`, the
/// whole of it as JSON, differ from the profile's; empty without one.
std::vector<std::string> changedFromProfile(const ProfileMark &mark, const Json &recipe);

} // namespace dyncal
