// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/verified.h"

#include "app/cli/findings_json.h"
#include "app/cli/spoken.h"

#include "core/base/foreign_text.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

using Status = Verified::Status;

int codeOf(const Verified &one)
{
    switch (one.status) {
    case Status::Valid:
        return one.remarks.empty() ? 0 : 1;
    case Status::Unsigned:
    case Status::UnknownSigner:
    case Status::Expired:
        return 1;
    case Status::Changed:
    case Status::Missing:
        return 2;
    case Status::Unreadable:
        break;
    }
    return 3;
}

nlohmann::json jsonOf(const Verified &one)
{
    nlohmann::json remarks = nlohmann::json::array();
    for (const Message &remark : one.remarks)
        remarks.push_back(spoken(remark));
    nlohmann::json json{{"file", one.file}, {"kind", one.kind}, {"status", statusName(one.status)},
        {"remarks", remarks}, {"state", textOrNull(one.state)},
        {"chain",
            {{"entries", one.entries}, {"head", textOrNull(one.head)},
                {"anchored", one.anchored}}}};
    json["signer"] = textOrNull(one.signer);
    json["signed_utc"] = textOrNull(one.signedUtc);
    json["stamped_utc"] = textOrNull(one.stampedUtc);
    json["number"] = one.number > 0 ? nlohmann::json(one.number) : nlohmann::json();
    json["first_difference"]
        = one.firstDifference ? nlohmann::json(spoken(*one.firstDifference)) : nlohmann::json();
    return json;
}

std::string wordsOf(const Verified &one)
{
    if (one.firstDifference)
        return spoken(*one.firstDifference);
    std::string words = one.number > 0 ? "certificate " + std::to_string(one.number) + ", " : "";
    words += (one.state.empty() ? "" : one.state + ", ") + statusName(one.status);
    if (!one.signer.empty())
        words += ", signed by " + presentable(one.signer)
            + (one.signedUtc.empty() ? "" : " at " + one.signedUtc)
            + (one.stampedUtc.empty() ? "" : ", time stamp " + one.stampedUtc);
    if (one.kind == "registry")
        words += "; " + std::to_string(one.entries) + " entries of the audit trail, "
            + std::to_string(one.anchored) + " of them up to the last issued certificate";
    return words;
}

} // namespace

const char *statusName(Verified::Status status)
{
    constexpr std::array<const char *, 7> kNames{
        "valid", "unsigned", "changed", "missing", "unreadable", "unknown-signer", "expired"};
    return kNames[static_cast<std::size_t>(status)];
}

int exitCodeOf(const std::vector<Verified> &all)
{
    int worst = 0;
    for (const Verified &one : all)
        worst = std::max(worst, codeOf(one));
    return worst;
}

nlohmann::json verifiedJson(const std::vector<Verified> &all)
{
    nlohmann::json list = nlohmann::json::array();
    for (const Verified &one : all)
        list.push_back(jsonOf(one));
    return list;
}

std::string verifiedText(const std::vector<Verified> &all)
{
    std::string text;
    for (const Verified &one : all) {
        text += presentable(one.file) + ": " + wordsOf(one) + '\n';
        for (const Message &remark : one.remarks)
            text += "  " + spoken(remark) + '\n';
    }
    return text;
}

} // namespace dyncal
