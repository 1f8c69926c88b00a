// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/step_words.h"

#include "core/results/method_versions.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

/// The names of the stages (stage_table.cpp), and what is checked beside them.
constexpr std::array kSteps{DYNCAL_TEXT("core", "captures"), DYNCAL_TEXT("core", "arrivals"),
    DYNCAL_TEXT("core", "expected shock"), DYNCAL_TEXT("core", "window"),
    DYNCAL_TEXT("core", "spectrum"), DYNCAL_TEXT("core", "components"),
    DYNCAL_TEXT("core", "model input"), DYNCAL_TEXT("core", "decomposition"),
    DYNCAL_TEXT("core", "model"), DYNCAL_TEXT("core", "shock"),
    DYNCAL_TEXT("core", "reference transducer"), DYNCAL_TEXT("core", "response"),
    DYNCAL_TEXT("core", "checks"), DYNCAL_TEXT("core", "model assessment"),
    DYNCAL_TEXT("core", "uncertainty"), DYNCAL_TEXT("core", "comparison"),
    DYNCAL_TEXT("core", "evidence"), DYNCAL_TEXT("core", "Monte Carlo"),
    DYNCAL_TEXT("core", "Monte Carlo of the chain"), DYNCAL_TEXT("core", "reading"),
    DYNCAL_TEXT("core", "correction"), DYNCAL_TEXT("core", "certificate"),
    DYNCAL_TEXT("core", "coverage")};

} // namespace

Message stepWords(const std::string &step)
{
    const auto found
        = std::ranges::find_if(kSteps, [&](const char *words) { return methodKey(words) == step; });
    return found == kSteps.end() ? Message{"%1", {step}} : Message{*found, {}};
}

} // namespace dyncal
