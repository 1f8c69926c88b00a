// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/base/writing/write_claim.h"

#include <optional>
#include <string>
#include <string_view>

namespace dyncal {

/// What may have the name of a file that is written.
struct Existing
{
    enum class Rule {
        Refused, ///< nothing may have it: recordings are written once
        Replaced, ///< a regular file, or a link, which is replaced and not followed
        /// A regular file of this hash, or a link to one, which is replaced and not followed;
        /// nothing where no hash is given.
        ReplacedIfUnchanged,
    };
    Rule rule = Rule::Replaced;
    std::optional<std::string> sha256 = {};
};

/// A file being written beside its target: on disk under its name when commit() has succeeded, gone
/// without a trace otherwise, also after a crash once something is written into that folder again.
class PendingFile
{
public:
    /// Fails as WriteClaim::take does, and (Usage) where the target may not be replaced.
    static Result<PendingFile> create(const std::string &path, const Existing &existing);

    PendingFile(PendingFile &&) noexcept = default;
    PendingFile &operator=(PendingFile &&) = delete;
    ~PendingFile();

    /// A path that opens this very file, whatever happens to its name.
    std::string openPath() const;

    /// Fails (Internal) on a full disk and the like.
    Result<void> write(std::string_view bytes);

    /// Flushes the file, gives it its name and flushes the folder. Fails (Usage) if what has the
    /// name now may not be replaced.
    Result<void> commit();

private:
    PendingFile(std::string path, std::string name, Existing existing, WriteClaim claim);
    Result<void> checkTarget() const;
    mode_t firstMode() const;
    Result<void> keepMode() const;
    bool takeName() const;

    std::string m_path; ///< as given, for messages
    std::string m_name;
    Existing m_existing;
    std::optional<WriteClaim> m_claim;
    FileDescriptor m_file;
    bool m_exists = false;
};

} // namespace dyncal
