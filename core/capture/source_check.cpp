// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/source_check.h"

#include "core/capture/capture_seal.h"

#include <filesystem>

namespace fs = std::filesystem;

namespace dyncal {
namespace {

bool isThere(const InputFile &input)
{
    const InputFile now = stampedInput(input.path, input.format);
    return now.bytes != 0 || now.changed_ns != 0;
}

/// The only shot that has samples of an input, from 1; 0 if there are several.
Index onlyShotOf(const CaptureSet &set, Index input)
{
    Index only = 0;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        if (!comesFrom(set.shots[i], input))
            continue;
        if (only != 0)
            return 0;
        only = static_cast<Index>(i) + 1;
    }
    return only;
}

Message sentenceOf(const InputFile &input, bool isMissing)
{
    if (isMissing)
        return {
            DYNCAL_TEXT("core",
                "%1 is no longer where it was opened: it was moved or removed, or its drive is gone. Put it back and read it again, or locate it; nothing is exported before."),
            {input.path}};
    return {
        DYNCAL_TEXT("core",
            "%1 was changed after it was opened, so what is shown may no longer be what it holds. Read it again; nothing is exported before."),
        {input.path}};
}

} // namespace

std::vector<ChangedSource> changedSources(const CaptureSet &set)
{
    std::vector<ChangedSource> changed;
    for (std::size_t i = 0; i < set.inputs.size(); ++i) {
        const InputFile &input = set.inputs[i];
        if (isUnchanged(input))
            continue;
        const bool isMissing = !isThere(input);
        changed.push_back({isMissing,
            {.id = "CAP-015",
                .severity = Severity::Block,
                .shot = onlyShotOf(set, static_cast<Index>(i)),
                .message = sentenceOf(input, isMissing)}});
    }
    return changed;
}

Result<void> checkSources(const CaptureSet &set)
{
    const std::vector<ChangedSource> changed = changedSources(set);
    if (changed.empty())
        return {};
    const Finding &first = changed.front().finding;
    return fail(ErrorKind::FileUnreadable, first.message, first.id, first.shot);
}

CaptureSet relocated(CaptureSet set, const std::string &folder)
{
    for (InputFile &input : set.inputs) {
        const fs::path other = fs::path(folder) / input.file;
        std::error_code problem;
        if (folder.empty() || isThere(input) || !fs::is_regular_file(other, problem))
            continue;
        input.path = other.string();
        if (!input.expectedSha256 && !input.sha256.empty())
            input.expectedSha256 = input.sha256;
    }
    return set;
}

} // namespace dyncal
