// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/atomic_file.h"

#include "core/base/writing/pending_file.h"

namespace dyncal {
namespace {

Result<void> writeWhole(const std::string &path, std::string_view bytes, const Existing &existing)
{
    Result<PendingFile> file = PendingFile::create(path, existing);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (const Result<void> written = file->write(bytes); !written)
        return written;
    return file->commit();
}

} // namespace

Result<void> writeFileAtomically(const std::string &path, std::string_view bytes)
{
    return writeWhole(path, bytes, {Existing::Rule::Replaced});
}

Result<void> replaceUnchangedFile(const std::string &path, std::string_view bytes,
    const std::optional<std::string> &expectedSha256)
{
    return writeWhole(path, bytes, {Existing::Rule::ReplacedIfUnchanged, expectedSha256});
}

} // namespace dyncal
