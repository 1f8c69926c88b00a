// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/text/core_text.h"

#include "core/base/message_places.h"
#include "ui/text/filled_words.h"
#include "ui/text/quantity_format.h"
#include "ui/text/recipe_labels.h"

#include <QCoreApplication>
#include <QLocale>

#include <string_view>

namespace dyncal {

namespace {

/// Numbers of a sentence, in the decimal mark of the language; a key that the sentence is about, by
/// its label. Everything else stays as it is: it is foreign.
std::vector<std::string> shownArguments(const Message &message)
{
    const bool namesKeys = std::string_view(message.text).starts_with("Recipe ");
    std::vector<std::string> shown = message.arguments;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (isVerbatimPlace(message.text, i))
            continue;
        std::string &argument = shown[i];
        const QString text = QString::fromStdString(argument);
        const QString label = namesKeys ? recipeLabel(text) : QString();
        argument = (label.isEmpty() ? inDecimalMark(text) : label).toStdString();
    }
    return shown;
}

} // namespace

QString translated(const Message &message)
{
    const QString text = withRecipeLabels(QCoreApplication::translate("core", message.text));
    const auto shown = [](const Message &sentence) { return translated(sentence).toStdString(); };
    return QString::fromStdString(withSentences(
        message, std::string("\n"), shown, [&](const std::vector<std::string> &within) {
            return fillPlaces(
                text.toStdString(), shownArguments(message), ArgumentText::Brief, within);
        }));
}

QString printed(const Message &message)
{
    return filledWords(
        message, [](const char *text) { return QCoreApplication::translate("core", text); },
        QLocale().decimalPoint().front());
}

} // namespace dyncal
