// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/certificates/certificate_record.h"

#include "core/base/json_text.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

using Json = nlohmann::json;

constexpr std::array<const char *, 6> kStates{
    "reserved", "issued", "amended", "replaced", "withdrawn", "void"};

constexpr std::pair<const char *, std::string CertificateRecord::*> kTexts[]{
    {"job", &CertificateRecord::job}, {"job_sha256", &CertificateRecord::jobSha256},
    {"reserved_utc", &CertificateRecord::reservedUtc},
    {"issued_utc", &CertificateRecord::issuedUtc}, {"by", &CertificateRecord::by},
    {"reviewed_by", &CertificateRecord::reviewedBy}, {"sensor", &CertificateRecord::sensor},
    {"customer", &CertificateRecord::customer}, {"reason", &CertificateRecord::reason},
    {"head", &CertificateRecord::head}};
constexpr std::pair<const char *, Index CertificateRecord::*> kNumbers[]{
    {"number", &CertificateRecord::number}, {"amends", &CertificateRecord::amends},
    {"replaced_by", &CertificateRecord::replacedBy}};

} // namespace

const char *certificateStateName(CertificateState state)
{
    return kStates[static_cast<std::size_t>(state)];
}

std::optional<CertificateState> certificateState(const std::string &name)
{
    const auto found = std::ranges::find(kStates, name);
    return found == kStates.end()
        ? std::nullopt
        : std::optional(static_cast<CertificateState>(found - kStates.begin()));
}

bool isInForce(CertificateState state)
{
    return state == CertificateState::Issued || state == CertificateState::Amended;
}

std::string certificateObject(Index number)
{
    return "certificate " + std::to_string(number);
}

std::string recordJson(const CertificateRecord &record)
{
    Json json{{"state", certificateStateName(record.state)}, {"files", record.files}};
    for (const auto &[key, member] : kTexts)
        json[key] = record.*member;
    for (const auto &[key, member] : kNumbers)
        json[key] = record.*member;
    std::string text = jsonLine(json);
    text.pop_back(); // the line break
    return text;
}

std::optional<CertificateRecord> parseRecord(const std::string &text)
{
    try {
        const Json json = Json::parse(text);
        CertificateRecord record;
        for (const auto &[key, member] : kTexts)
            record.*member = json.at(key).get<std::string>();
        for (const auto &[key, member] : kNumbers)
            record.*member = json.at(key).get<Index>();
        record.files = json.at("files").get<std::map<std::string, std::string>>();
        const auto state = certificateState(json.at("state").get<std::string>());
        if (!state)
            return std::nullopt;
        record.state = *state;
        return record;
    } catch (const Json::exception &) {
        return std::nullopt;
    }
}

} // namespace dyncal
