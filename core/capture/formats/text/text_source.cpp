// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/text_source.h"

#include "core/base/text_encoding.h"
#include "core/capture/formats/text/text_bytes.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace dyncal {

TextSource::TextSource(std::string_view text)
    : m_text(text)
    , m_size(text.size())
{
}

TextSource::TextSource(FileText text)
    : m_kept(std::move(text))
    , m_text(m_kept->view())
    , m_size(m_text.size())
{
}

TextSource::TextSource(std::shared_ptr<const SampleFile> file, std::uint64_t skipped)
    : m_file(std::move(file))
    , m_skipped(skipped)
    , m_size(m_file->size() - skipped)
{
}

std::optional<std::string_view> TextSource::read(
    std::uint64_t begin, std::uint64_t end, std::vector<char> &buffer) const
{
    const auto count = static_cast<std::size_t>(end - begin);
    if (inMemory())
        return m_text.substr(static_cast<std::size_t>(begin), count);
    if (buffer.size() < count)
        buffer.resize(count);
    const auto target = std::as_writable_bytes(std::span(buffer));
    if (!m_file->read(m_skipped + begin, count, target.data()))
        return std::nullopt;
    return std::string_view(buffer.data(), count);
}

Result<TextSource> openText(const std::string &path)
{
    const auto file = SampleFile::open(path);
    std::array<char, 4> head{};
    const std::size_t count = file ? std::min<std::size_t>(head.size(), (*file)->size()) : 0;
    if (!file || !(*file)->read(0, count, std::as_writable_bytes(std::span(head)).data()))
        return unreadableText(path);
    if (const Result<void> fits = checkTextSize(path, (*file)->size()); !fits)
        return tl::unexpected(fits.error());
    const std::string_view begin(head.data(), count);
    if (byteOrderOf(begin) == ByteOrder::None)
        return TextSource(*file, begin.starts_with(kUtf8Mark) ? kUtf8Mark.size() : 0);
    return readTextFile(path).map([](FileText text) { return TextSource(std::move(text)); });
}

std::string_view LineBlocks::next(std::uint64_t end)
{
    constexpr std::uint64_t kBlock = 1 << 18; ///< stays in the cache from reading to parsing
    constexpr std::uint64_t kGrowth = 4;
    for (std::uint64_t bytes = m_source.inMemory() ? end : kBlock;; bytes *= kGrowth) {
        const std::uint64_t stop = std::min(m_position + bytes, end);
        const std::optional<std::string_view> text = m_source.read(m_position, stop, m_buffer);
        m_failed = !text;
        if (!text)
            return {};
        const std::size_t feed = stop == end ? text->size() - 1 : text->rfind('\n');
        if (text->empty())
            return {};
        if (feed == std::string_view::npos)
            continue; // within a long line
        m_position += feed + 1;
        return text->substr(0, feed + 1);
    }
}

} // namespace dyncal
