// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/cli/console.h"
#include "app/cli/registry_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "registry/cards/card_csv.h"
#include "registry/cards/card_json.h"
#include "registry/cards/card_register.h"
#include "registry/certificates/certificate_register.h"
#include "registry/store/trail_table.h"
#include "registry/trail/audit_file.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

namespace dyncal {
namespace {

struct RegistryOptions
{
    std::string registry, by, reason, kind, file;
    Index number = 0;
    bool json = false;
};

nlohmann::json jsonOf(const CertificateRecord &record)
{
    return nlohmann::json::parse(recordJson(record));
}

nlohmann::json jsonOf(const AuditEntry &entry)
{
    return entryJson(entry);
}

std::string lineOf(const CertificateRecord &record)
{
    std::string line = std::to_string(record.number) + "  " + certificateStateName(record.state)
        + "  " + (record.issuedUtc.empty() ? record.reservedUtc : record.issuedUtc);
    for (const std::string &text : {record.sensor, record.customer, record.reason})
        line += text.empty() ? "" : "  " + presentableInBrief(text);
    return line + '\n';
}

std::string lineOf(const AuditEntry &entry)
{
    std::string line = std::to_string(entry.sequence) + "  " + entry.utc;
    for (const std::string &text : {entry.who, entry.action, entry.object, entry.reason})
        line += text.empty() ? "" : "  " + presentableInBrief(text);
    return line + '\n';
}

template <typename Row>
std::string textOf(const std::vector<Row> &rows, bool json)
{
    nlohmann::json list = nlohmann::json::array();
    std::string lines;
    for (const Row &row : rows)
        if (json)
            list.push_back(jsonOf(row));
        else
            lines += lineOf(row);
    return json ? jsonText(list) : lines;
}

std::string textOf(const std::vector<Card> &cards, bool json)
{
    return json ? cardsJson(cards) : cardsCsv(cards);
}

/// Prints what `read` takes from the registry; nothing of it is made or changed.
template <typename Read>
int show(const RegistryOptions &options, const Read &read)
{
    Result<CertificateRegister> registry = CertificateRegister::openToRead(options.registry);
    if (!registry)
        return report(registry.error());
    const auto found = read(*registry);
    if (!found)
        return report(found.error());
    std::cout << textOf(*found, options.json);
    return static_cast<int>(ExitCode::Done);
}

int list(const RegistryOptions &options)
{
    return show(options, [](CertificateRegister &registry) { return registry.all(); });
}

int makeVoid(const RegistryOptions &options)
{
    const auto record
        = changedNow(options.registry, [&](CertificateRegister &registry, const std::string &utc) {
              return registry.markVoid(options.number, options.by, options.reason, utc);
          });
    if (!record)
        return report(record.error());
    std::cout << "Number " << record->number << " is void.\n";
    return static_cast<int>(ExitCode::Done);
}

/// The audit trail, or the entries about one certificate.
int listTrail(const RegistryOptions &options)
{
    return show(options, [&](CertificateRegister &registry) {
        return options.number > 0
            ? entriesOf(registry.database(), certificateObject(options.number))
            : allEntries(registry.database());
    });
}

int listCards(const RegistryOptions &options)
{
    return show(options,
        [&](CertificateRegister &registry) { return cardsOf(registry.database(), options.kind); });
}

int importCards(const RegistryOptions &options)
{
    const Result<std::string> now = currentUtc();
    std::ifstream in(options.file, std::ios::binary);
    if (!now || !in)
        return report(!now
                ? now.error()
                : Error{ErrorKind::FileUnreadable,
                    {DYNCAL_TEXT("core", "The file %1 does not exist."), {options.file}}, {}, 0});
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto cards = options.file.ends_with(".json") ? parseCardsJson(text, options.kind)
                                                       : parseCards(text, options.kind);
    if (!cards)
        return report(cards.error());
    Result<CertificateRegister> registry = CertificateRegister::open(options.registry);
    if (!registry)
        return report(registry.error());
    const auto changed = putCards(registry->database(), *cards, options.by, options.reason, *now);
    if (!changed)
        return report(changed.error());
    std::cout << *changed << " of " << cards->size() << " cards were new or changed.\n";
    return static_cast<int>(ExitCode::Done);
}

void addCards(CLI::App &verb, const std::shared_ptr<RegistryOptions> &options, VerbAction &action)
{
    const auto declare = [&](CLI::App *one) {
        one->add_option("kind", options->kind, "Which cards")
            ->required()
            ->check(CLI::IsMember({"laboratory", "customer", "sensor", "reference"}))
            ->type_name("laboratory|customer|sensor|reference");
        declareRegistry(*one, options->registry);
        return one;
    };
    CLI::App *shown = declare(verb.add_subcommand("cards", "Cards of a kind, as CSV"));
    shown->add_flag("--json", options->json, "As JSON");
    shown->callback([options, &action] { action = [options] { return listCards(*options); }; });
    CLI::App *taken = declare(verb.add_subcommand(
        "import", "Take cards from a file; those of the same name are changed"));
    taken
        ->add_option(
            "file", options->file, "A table with a column \"name\", or what cards --json prints")
        ->required()
        ->type_name("FILE.csv|FILE.json");
    declareReason(*taken, options->by, options->reason);
    taken->callback([options, &action] { action = [options] { return importCards(*options); }; });
}

} // namespace

void addRegistry(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<RegistryOptions>();
    CLI::App *verb
        = program.add_subcommand("registry", "The laboratory's registry of certificates");
    verb->require_subcommand(1);
    CLI::App *all = verb->add_subcommand("list", "Every number and what has become of it");
    declareRegistry(*all, options->registry);
    all->add_flag("--json", options->json, "As JSON");
    all->callback([options, &action] { action = [options] { return list(*options); }; });
    CLI::App *trail = verb->add_subcommand("trail", "The audit trail: who did what when, and why");
    trail->add_option("--number", options->number, "Only what is about this certificate")
        ->check(CLI::PositiveNumber)
        ->type_name("NUMBER");
    declareRegistry(*trail, options->registry);
    trail->add_flag("--json", options->json, "As JSON");
    trail->callback([options, &action] { action = [options] { return listTrail(*options); }; });
    CLI::App *none
        = verb->add_subcommand("void", "Give up a reserved number that will not be issued");
    none->add_option("number", options->number, "A reserved number")
        ->required()
        ->check(CLI::PositiveNumber)
        ->type_name("NUMBER");
    declareRegistry(*none, options->registry);
    declareReason(*none, options->by, options->reason);
    none->callback([options, &action] { action = [options] { return makeVoid(*options); }; });
    addCards(*verb, options, action);
    verb->footer("Example:\n  dyncal registry list\n"
                 "  dyncal registry import reference references.csv --reason \"list of 2026\"\n"
                 "  dyncal registry void 18 --by \"A. Berg\" --reason \"sensor broke\"");
}

} // namespace dyncal
