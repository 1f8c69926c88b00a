// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/file_samples.h"
#include "core/capture/formats/text/text_bytes.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dyncal {

/// A text in memory, or in a file that is read piece by piece on demand.
class TextSource
{
public:
    explicit TextSource(std::string_view text); ///< which outlives this object
    explicit TextSource(FileText text);
    /// The file after its first `skipped` bytes.
    TextSource(std::shared_ptr<const SampleFile> file, std::uint64_t skipped);

    std::uint64_t size() const { return m_size; }
    bool inMemory() const { return m_file == nullptr; }

    /// Text [begin, end), in memory or read into `buffer`. Empty if the file changed meanwhile or
    /// cannot be read any more.
    std::optional<std::string_view> read(
        std::uint64_t begin, std::uint64_t end, std::vector<char> &buffer) const;

private:
    std::optional<FileText> m_kept;
    std::string_view m_text;
    std::shared_ptr<const SampleFile> m_file;
    std::uint64_t m_skipped = 0;
    std::uint64_t m_size = 0;
};

/// A text file with as little of it in memory as possible: pieces of single-byte text or UTF-8, all
/// of UTF-16. A byte order mark is left out. Fails as readTextFile.
Result<TextSource> openText(const std::string &path);

/// A text as blocks of whole lines, of which one is held at a time.
class LineBlocks
{
public:
    explicit LineBlocks(const TextSource &source, std::uint64_t begin = 0)
        : m_source(source)
        , m_position(begin)
    {
    }

    /// The lines after the last block and before `end`, which is the beginning of a line or the end
    /// of the text. Empty there, or if the text cannot be read any more.
    std::string_view next(std::uint64_t end);

    std::uint64_t position() const { return m_position; } ///< after the last block
    void moveTo(std::uint64_t position) { m_position = position; }
    bool failed() const { return m_failed; }

private:
    const TextSource &m_source;
    std::uint64_t m_position;
    bool m_failed = false;
    std::vector<char> m_buffer;
};

} // namespace dyncal
