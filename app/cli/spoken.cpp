// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/spoken.h"

#include "ui/report/report_language.h"
#include "ui/text/filled_words.h"

#include <cstdlib>
#include <memory>
#include <string_view>

namespace dyncal {
namespace {

/// Null for English, which needs no translation.
std::unique_ptr<ReportLanguage> askedLanguage()
{
    const char *asked = std::getenv("DYNCAL_LANGUAGE");
    return asked && std::string_view(asked) == "sv" ? std::make_unique<ReportLanguage>("sv")
                                                    : nullptr;
}

} // namespace

std::string spoken(const Message &message)
{
    static const std::unique_ptr<ReportLanguage> language = askedLanguage();
    if (!language)
        return english(message);
    const auto translate = [](const char *text) { return language->translate("core", text); };
    const QChar mark = language->numbers().decimalPoint().front();
    return filledWords(message, translate, mark, ArgumentText::Brief).toStdString();
}

std::string spoken(const KeptMessage &message, const std::string &otherwise)
{
    return message.text.empty() ? otherwise : spoken(message.message());
}

} // namespace dyncal
