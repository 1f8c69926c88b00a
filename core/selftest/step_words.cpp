// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/step_words.h"

#include "core/pipeline/stage_table.h"
#include "core/results/method_versions.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dyncal {
namespace {

/// What is checked beside the stages of the method.
constexpr std::array kBesideTheStages{DYNCAL_TEXT("core", "reading"),
    DYNCAL_TEXT("core", "correction"), DYNCAL_TEXT("core", "certificate"),
    DYNCAL_TEXT("core", "coverage")};

} // namespace

Message stepWords(const std::string &step)
{
    if (const std::optional<StageId> stage = stageOfMethod(step))
        return {stageName(*stage), {}};
    const auto found = std::ranges::find(kBesideTheStages, std::string_view(step),
        [](const char *words) { return std::string_view(words); });
    return found == kBesideTheStages.end() ? Message{"%1", {step}} : Message{*found, {}};
}

} // namespace dyncal
