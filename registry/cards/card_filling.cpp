// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_filling.h"

#include <algorithm>
#include <functional>

namespace dyncal {
namespace {

bool isBlankText(const std::string &text)
{
    return text.find_first_not_of(" \t\r\n") == text.npos;
}

std::string fieldOf(const Recipe &recipe, const char *name)
{
    const auto found = recipe.certificate.fields.find(name);
    return found == recipe.certificate.fields.end() || isBlankText(found->second) ? std::string()
                                                                                  : found->second;
}

std::string fieldOf(const Card &card, const char *name)
{
    const auto found = card.fields.find(name);
    return found == card.fields.end() ? std::string() : found->second;
}

/// The only card of that kind for which this holds; null where there is none, or several.
const Card *theOnly(
    const std::vector<Card> &cards, const char *kind, const std::function<bool(const Card &)> &fits)
{
    const Card *only = nullptr;
    for (const Card &card : cards) {
        if (card.kind != kind || !fits(card))
            continue;
        if (only)
            return nullptr;
        only = &card;
    }
    return only;
}

void fill(const Card *card, Recipe &recipe)
{
    if (!card)
        return;
    for (const auto &[name, value] : card->fields)
        if (fieldOf(recipe, name.c_str()).empty())
            recipe.certificate.fields[name] = value;
}

void fillReference(const std::vector<Card> &cards, BudgetEntry &entry)
{
    if (!isBlankText(entry.certificate))
        return;
    const Card *reference = theOnly(cards, "reference",
        [&](const Card &card) { return fieldOf(card, "quantity") == entry.quantity; });
    if (!reference)
        return;
    entry.certificate = fieldOf(*reference, "certificate");
    if (entry.due.empty())
        entry.due = fieldOf(*reference, "due");
}

} // namespace

Recipe filledFromCards(Recipe recipe, const std::vector<Card> &cards)
{
    const std::string named = fieldOf(recipe, "laboratory");
    const Card *laboratory = theOnly(
        cards, "laboratory", [&](const Card &card) { return named.empty() || card.name == named; });
    if (laboratory && named.empty())
        recipe.certificate.fields["laboratory"] = laboratory->name;
    fill(laboratory, recipe);
    const std::string customer = fieldOf(recipe, "customer");
    fill(theOnly(cards, "customer", [&](const Card &card) { return card.name == customer; }),
        recipe);
    const std::string serial = fieldOf(recipe, "sensor_serial");
    if (!serial.empty())
        fill(theOnly(cards, "sensor",
                 [&](const Card &card) {
                     return card.name == serial || fieldOf(card, "sensor_serial") == serial;
                 }),
            recipe);
    for (BudgetEntry &entry : recipe.uncertainty.budget)
        fillReference(cards, entry);
    return recipe;
}

} // namespace dyncal
