// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/document_languages.h"

namespace dyncal {

const std::vector<std::string> &documentLanguageCodes()
{
    static const std::vector<std::string> codes{"en", "sv", "de"};
    return codes;
}

Codec<std::vector<std::string>> documentLanguageList()
{
    constexpr std::size_t kMost = 2; // side by side
    Codec<std::vector<std::string>> codec = list(oneOf(documentLanguageCodes()), 1);
    codec.read = [read = codec.read](const JsonAt &at) -> Result<std::vector<std::string>> {
        if (at.value.is_array() && at.value.size() > kMost)
            return mismatch(at, "a list of one language, or of two that stand side by side");
        return read(at);
    };
    return codec;
}

} // namespace dyncal
