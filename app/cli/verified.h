// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"
#include "core/base/message.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What `dyncal verify` found of one file or folder.
struct Verified
{
    enum class Status { Valid, Unsigned, Changed, Missing, Unreadable, UnknownSigner, Expired };

    std::string file; ///< as given, or found below it
    std::string kind; ///< "certificate", "registry", "project", "recording", "file"
    Status status = Status::Valid;
    std::optional<Message> firstDifference = {};
    std::vector<Message> remarks = {};
    Index number = 0; ///< of a certificate; 0: of none
    std::string state = {}; ///< by the registry; empty: not known
    Index entries = 0; ///< of the audit trail
    Index anchored = 0; ///< of these, how many a certificate stands for
    std::string head = {};
    std::string signer = {}; ///< empty: not signed, or changed
    std::string signedUtc = {}; ///< as the signature states it
    std::string stampedUtc = {}; ///< by a time stamp that counts
};

/// "valid", ...: the words of --json.
const char *statusName(Verified::Status status);

/// 0 valid; 1 valid with remarks; 2 changed or contradicting; 3 unreadable.
int exitCodeOf(const std::vector<Verified> &all);

/// The array of --json (docs/registry.md).
nlohmann::json verifiedJson(const std::vector<Verified> &all);

/// For people: a line each, with its remarks below it.
std::string verifiedText(const std::vector<Verified> &all);

} // namespace dyncal
