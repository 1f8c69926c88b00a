// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/trail/audit_file.h"

#include "core/base/content_hash.h"
#include "core/base/json_text.h"

#include <sstream>

namespace dyncal {
namespace {

using Json = nlohmann::json;

/// The texts of an open line, by their keys.
constexpr std::pair<const char *, std::string AuditEntry::*> kTexts[]{{"utc", &AuditEntry::utc},
    {"who", &AuditEntry::who}, {"action", &AuditEntry::action}, {"object", &AuditEntry::object},
    {"before", &AuditEntry::before}, {"after", &AuditEntry::after}, {"reason", &AuditEntry::reason},
    {"program", &AuditEntry::program}};

std::optional<std::string> textOf(const Json &line, const char *key)
{
    const auto found = line.find(key);
    return found != line.end() && found->is_string() ? std::optional(found->get<std::string>())
                                                     : std::nullopt;
}

std::optional<AuditEntry> openEntry(const Json &json, const AuditLine &line)
{
    AuditEntry entry;
    for (const auto &[key, member] : kTexts) {
        const auto text = textOf(json, key);
        if (!text)
            return std::nullopt;
        entry.*member = *text;
    }
    entry.sequence = line.sequence;
    entry.previous = line.previous;
    entry.sha256 = line.sha256;
    return entry;
}

/// Empty where it is no line of such a file; one with other keys or in another form is none.
std::optional<AuditLine> lineOf(const std::string &text)
{
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("sequence") || !json["sequence"].is_number_integer())
        return std::nullopt;
    const auto previous = textOf(json, "previous");
    const auto content = textOf(json, "content_sha256");
    const auto hash = textOf(json, "sha256");
    if (!previous || !content || !hash || jsonLine(json) != text + '\n')
        return std::nullopt;
    AuditLine line{json["sequence"].get<Index>(), *previous, *content, *hash, {}};
    constexpr std::size_t kKeysOfClosed = 4;
    if (json.size() == kKeysOfClosed)
        return line;
    line.entry = openEntry(json, line);
    return line.entry && json.size() == kKeysOfClosed + std::size(kTexts) ? std::optional(line)
                                                                          : std::nullopt;
}

} // namespace

Json entryJson(const AuditEntry &entry)
{
    Json json{{"sequence", entry.sequence}, {"previous", entry.previous}, {"sha256", entry.sha256}};
    for (const auto &[key, member] : kTexts)
        json[key] = entry.*member;
    return json;
}

std::string auditText(const std::vector<AuditEntry> &entries, const std::string &object)
{
    std::string text;
    for (const AuditEntry &entry : entries) {
        Json line = entryJson(entry);
        if (entry.object != object)
            for (const auto &[key, member] : kTexts)
                line.erase(key);
        line["content_sha256"] = contentSha256(entry);
        text += jsonLine(line);
    }
    return text;
}

Result<std::vector<AuditLine>> parseAudit(const std::string &text)
{
    std::vector<AuditLine> lines;
    std::istringstream in(text);
    for (std::string one; std::getline(in, one);) {
        const std::optional<AuditLine> line = in.eof() ? std::nullopt : lineOf(one);
        if (!line)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "Line %1 of audit.jsonl is no entry of an audit trail; take an unchanged copy."),
                    {std::to_string(lines.size() + 1)}});
        lines.push_back(*line);
    }
    return lines;
}

std::optional<Index> firstBrokenLine(const std::vector<AuditLine> &lines)
{
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const AuditLine &line = lines[i];
        const bool follows = i == 0
            || (line.previous == lines[i - 1].sha256 && line.sequence == lines[i - 1].sequence + 1);
        const bool isWhole = line.sha256 == entrySha256(line.previous, line.sequence, line.content)
            && (!line.entry || contentSha256(*line.entry) == line.content);
        if (!follows || !isWhole)
            return static_cast<Index>(i) + 1;
    }
    return std::nullopt;
}

} // namespace dyncal
