// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/base/writing/folder_write.h"
#include "registry/certificates/certificate_register.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace dyncal {

inline constexpr const char *kManifest = "manifest.json";
inline constexpr const char *kAuditFile = "audit.jsonl";
inline constexpr const char *kFrozenProject = "project.dyncal";
inline constexpr const char *kIssuedPdf = "certificate.pdf";
/// The sensor's history as a table, where the certificate states it.
inline constexpr const char *kHistoryFile = "history.csv";

/// What manifest.json of an issued folder says (schema "dyncal-manifest/1").
struct IssuedManifest
{
    Index number = 0;
    Index amends = 0;
    std::string jobSha256;
    std::string utc; ///< of the reservation, which the certificate states
    std::string head; ///< of the audit trail before issuing
    std::map<std::string, std::string> files; ///< SHA-256 by name, all but itself and written.json

    bool operator==(const IssuedManifest &) const = default;
};

std::string manifestText(const IssuedManifest &manifest);
/// Empty where it is none, or not byte for byte as manifestText() writes it.
std::optional<IssuedManifest> parseManifest(const std::string &text);
/// The one in a folder; empty also where there is no such file.
std::optional<IssuedManifest> readManifest(const std::string &folder);

/// SHA-256 by name, of files' bytes by name.
std::map<std::string, std::string> hashesOf(const std::map<std::string, std::string> &files);

/// Whether an issued folder may hold a file of this name (relative).
bool isIssuedName(const std::string &name);

/// Writes DIR/NUMBER/ for a reserved number: the files, the trail as audit.jsonl, manifest.json and
/// written.json, as one transaction. What a killed program left of the same number is replaced.
/// Returns the SHA-256 of every file by its name, as the registry keeps them. Fails (Usage) where
/// something else has that name, and as FolderWrite does; nothing changed then. `mayCommit`: asked
/// when all is staged.
Result<std::map<std::string, std::string>> writeIssuedFolder(const std::string &folder,
    const ReservedNumber &reserved, const std::map<std::string, std::string> &files,
    const std::vector<std::string> &recordings, const std::function<Result<void>()> &mayCommit = {},
    const JobControl &control = {});

/// "DIR/17"
std::string issuedFolder(const std::string &folder, Index number);

} // namespace dyncal
