// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/method_versions.h"

#include "core/pipeline/stage_table.h"

namespace dyncal {

std::string methodKey(std::string name)
{
    for (char &c : name)
        c = c == ' ' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
}

std::optional<StageId> stageOfMethod(std::string_view key)
{
    for (int i = 0; i < kStageCount; ++i)
        if (const auto id = static_cast<StageId>(i); methodKey(stageName(id)) == key)
            return id;
    return std::nullopt;
}

MethodVersions methodVersions()
{
    MethodVersions versions;
    for (int i = 0; i < kStageCount; ++i) {
        const Stage &stage = stageOf(static_cast<StageId>(i));
        versions[methodKey(stage.name)] = stage.method;
    }
    return versions;
}

} // namespace dyncal
