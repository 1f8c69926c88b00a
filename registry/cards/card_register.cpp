// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/cards/card_register.h"

#include "core/base/foreign_text.h"
#include "registry/store/registry_schema.h"
#include "registry/store/trail_table.h"

#include <filesystem>

namespace dyncal {
namespace {

Result<std::vector<Card>> selected(
    RegistryDatabase &database, const QString &where, const std::vector<QVariant> &values)
{
    const auto rows
        = database.run("SELECT kind, name, record FROM cards " + where + " ORDER BY name", values);
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    std::vector<Card> cards;
    for (const auto &row : *rows) {
        const auto fields = parseCardFields(row[2].toString().toStdString());
        if (!fields)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "The registry %1 holds a row that is no card; see dyncal verify, and take a copy from before."),
                    {database.address().shown()}});
        cards.push_back(
            {row[0].toString().toStdString(), row[1].toString().toStdString(), *fields});
    }
    return cards;
}

/// Whether it changed anything.
Result<bool> putCard(RegistryDatabase &database, Card card, AuditEntry entry)
{
    card.name = presentable(card.name); // as the database keeps it
    const Result<std::optional<Card>> before = findCard(database, card.kind, card.name);
    if (!before)
        return tl::unexpected<Error>(before.error());
    entry.object = cardObject(card);
    entry.action = *before ? "changed" : "added";
    entry.before = *before ? cardJson(**before) : "";
    entry.after = cardJson(card);
    if (entry.before == entry.after)
        return false;
    const Result<AuditEntry> added = appendEntry(database, entry);
    if (!added)
        return tl::unexpected<Error>(added.error());
    const auto text = [](const std::string &value) { return QString::fromStdString(value); };
    return database
        .run("INSERT INTO cards (kind, name, record, entry) VALUES (?, ?, ?, ?) "
             "ON CONFLICT (kind, name) DO UPDATE SET record = excluded.record, "
             "entry = excluded.entry",
            {text(card.kind), text(card.name), text(added->after),
                static_cast<qint64>(added->sequence)})
        .map([](const auto &) { return true; });
}

} // namespace

Result<std::vector<Card>> cardsOf(RegistryDatabase &database, const std::string &kind)
{
    return selected(database, "WHERE kind = ?", {QString::fromStdString(kind)});
}

Result<std::optional<Card>> findCard(
    RegistryDatabase &database, const std::string &kind, const std::string &name)
{
    return selected(database, "WHERE kind = ? AND name = ?",
        {QString::fromStdString(kind), QString::fromStdString(name)})
        .map([](const std::vector<Card> &found) {
            return found.empty() ? std::nullopt : std::optional(found.front());
        });
}

Result<std::vector<Card>> cardsAt(const std::string &text)
{
    const Result<RegistryAddress> address = registryAddress(text);
    if (!address)
        return tl::unexpected<Error>(address.error());
    std::error_code unknown;
    if (!address->isServer() && !std::filesystem::exists(address->file, unknown))
        return std::vector<Card>();
    Result<RegistryDatabase> database = RegistryDatabase::open(*address, RegistryAccess::Read);
    if (!database)
        return tl::unexpected<Error>(database.error());
    const Result<int> version = schemaVersion(*database);
    if (version && *version == 0)
        return std::vector<Card>();
    if (const Result<void> ready = checkSchema(*database); !ready)
        return tl::unexpected<Error>(ready.error());
    return selected(*database, "", {});
}

Result<Index> putCards(RegistryDatabase &database, const std::vector<Card> &cards,
    const std::string &who, const std::string &reason, const std::string &utc)
{
    Index changed = 0;
    const Result<void> done = database.transaction([&]() -> Result<void> {
        for (const Card &card : cards) {
            const AuditEntry entry
                = {.utc = utc, .who = who, .reason = reason, .program = programText()};
            const Result<bool> put = putCard(database, card, entry);
            if (!put)
                return tl::unexpected<Error>(put.error());
            changed += *put ? 1 : 0;
        }
        return {};
    });
    return done ? Result<Index>(changed) : tl::unexpected<Error>(done.error());
}

} // namespace dyncal
