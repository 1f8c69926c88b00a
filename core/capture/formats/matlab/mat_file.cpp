// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Layout: The MathWorks, "MAT-File Format" (R2022b), chapters 1 (level 5) and 2 (level 4).

#include "core/capture/formats/matlab/mat_file.h"

#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"
#include "core/capture/formats/bytes/zlib_stream.h"
#include "core/capture/formats/matlab/mat_samples.h"

#include <array>

namespace dyncal {
namespace {

constexpr std::size_t kFileHeader = 128;
constexpr std::size_t kHeadBytes = 4096; ///< a matrix's flags, dimensions and name fit in there
constexpr std::uint32_t kMatrix = 14, kCompressed = 15;
constexpr std::size_t kVariables = 10000;
constexpr Index kDimensions = 32;
constexpr Index kLongest = Index(1) << 46; ///< numbers; keeps products of sizes in range

/// What a matrix says of itself before its numbers.
struct MatrixHead
{
    MatVariable variable;
    std::size_t dataAt = 0; ///< of the numbers, from the begin of the element's content
    std::uint64_t dataBytes = 0;
};

/// A tag: type and size of an element; small ones hold their content in the tag's second half.
struct Tag
{
    std::uint32_t type = 0, bytes = 0;
    bool small = false;
};

Tag tagOf(ByteReader &bytes)
{
    Tag tag;
    const auto word = bytes.next<std::uint32_t>();
    tag.small = word >> 16 != 0;
    tag.type = tag.small ? word & 0xFFFF : word;
    tag.bytes = tag.small ? word >> 16 : bytes.next<std::uint32_t>();
    return tag;
}

/// Moves past the element whose content begins here.
void skipContent(ByteReader &bytes, const Tag &tag)
{
    bytes.skip(tag.small ? 4 : (std::size_t{tag.bytes} + 7) / 8 * 8);
}

const char *kindOfClass(std::uint32_t code)
{
    constexpr std::array kKinds{"unknown class", "cell array", "struct", "object", "text",
        "sparse matrix", "", "", "", "", "", "", "", "", "", "", "function", "object"};
    return code < kKinds.size() ? kKinds[code] : kKinds[0];
}

/// Rows and columns; false if the dimensions cannot be.
bool takeDimensions(ByteReader &bytes, MatVariable &variable)
{
    const Tag tag = tagOf(bytes);
    const auto count = static_cast<Index>(tag.bytes / 4);
    if (tag.type != std::uint32_t(MatNumber::Int32) || count < 2 || count > kDimensions
        || (tag.small && tag.bytes > 4))
        return false;
    std::vector<Index> sizes;
    Index total = 1;
    for (Index i = 0; i < count; ++i) {
        const Index size = bytes.next<std::int32_t>();
        if (size < 0 || (size > 0 && total > kLongest / size))
            return false;
        total *= size;
        sizes.push_back(size);
    }
    if (count % 2 == 1)
        bytes.skip(4);
    variable.rows = sizes[0];
    variable.columns = sizes[1];
    if (count > 2 && total > 0 && total != sizes[0] * sizes[1] && variable.kind.empty())
        variable.kind = "array of " + std::to_string(count) + " dimensions";
    return true;
}

/// Reads flags, dimensions, name and the tag of the numbers; empty if they contradict each other.
std::optional<MatrixHead> headOf(std::span<const std::byte> content, std::endian order)
{
    ByteReader bytes(content, order);
    MatrixHead head;
    MatVariable &variable = head.variable;
    variable.order = order;
    const Tag flagsTag = tagOf(bytes);
    const auto flags = bytes.next<std::uint32_t>();
    bytes.skip(4);
    if (flagsTag.type != std::uint32_t(MatNumber::UInt32) || flagsTag.bytes != 8 || !bytes.ok())
        return {};
    constexpr std::uint32_t kComplex = 0x0800, kLogical = 0x0200;
    variable.kind = kindOfClass(flags & 0xFF);
    if (variable.kind.empty() && (flags & kComplex) != 0)
        variable.kind = "complex";
    if (variable.kind.empty() && (flags & kLogical) != 0)
        variable.kind = "logical";
    const bool opaque = (flags & 0xFF) == 17; // objects have another layout from here on
    if (!opaque && !takeDimensions(bytes, variable))
        return {};
    const Tag nameTag = tagOf(bytes);
    ByteReader name = bytes;
    skipContent(bytes, nameTag);
    if (!bytes.ok() || (nameTag.small && nameTag.bytes > 4))
        return {};
    variable.name = utf8Text(name.text(nameTag.bytes));
    if (!variable.isNumeric() || variable.size() == 0)
        return head;
    const Tag data = tagOf(bytes);
    variable.number = MatNumber{data.type};
    head.dataAt = bytes.position();
    head.dataBytes = data.bytes;
    const Index size = bytesOfMatNumber(variable.number);
    const bool fits = bytes.ok() && size > 0 && (!data.small || data.bytes <= 4)
        && head.dataBytes == static_cast<std::uint64_t>(variable.size() * size);
    return fits ? std::optional(head) : std::nullopt;
}

/// Whether these are the fields of a header of version 4 in this byte order.
bool isOldHeader(std::string_view head, std::endian order)
{
    ByteReader bytes(std::as_bytes(std::span(head)), order);
    const auto type = bytes.next<std::int32_t>();
    const auto rows = bytes.next<std::int32_t>();
    const auto columns = bytes.next<std::int32_t>();
    const auto imaginary = bytes.next<std::int32_t>();
    const auto nameBytes = bytes.next<std::int32_t>();
    const int machine = order == std::endian::little ? 0 : 1; // VAX and Cray are not read
    if (!bytes.ok() || type < 0 || type / 1000 != machine || type / 100 % 10 != 0
        || type / 10 % 10 > 5 || type % 10 > 2 || rows < 0 || columns < 0
        || (imaginary != 0 && imaginary != 1) || nameBytes < 2 || nameBytes > 64)
        return false;
    const std::string_view name = head.substr(20, static_cast<std::size_t>(nameBytes));
    const auto isWord = [](char c) {
        return c == '_' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z')
            || (c >= 'a' && c <= 'z');
    };
    return name.size() == static_cast<std::size_t>(nameBytes) && name.back() == '\0'
        && isWord(name.front()) && std::all_of(name.begin(), name.end() - 1, isWord);
}

class MatLister
{
public:
    MatLister(const std::string &path, std::shared_ptr<const SampleFile> file,
        ExpansionBudget &budget, const JobControl &control)
        : m_path(path)
        , m_file(std::move(file))
        , m_budget(budget)
        , m_control(control)
    {
    }

    Result<std::vector<MatVariable>> list()
    {
        const std::vector<std::byte> head = bytesAt(*m_file, 0, kFileHeader);
        const std::string_view text(reinterpret_cast<const char *>(head.data()), head.size());
        const int version = matVersion(text);
        if (version == 0)
            return endsInHeader(m_path);
        if (version == 5)
            m_order = text.ends_with("IM") ? std::endian::little : std::endian::big;
        m_position = version == 5 ? kFileHeader : 0;
        while (m_position < m_file->size()) {
            if (m_control.stopRequested())
                return fail(ErrorKind::Cancelled,
                    {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
            m_control.report(static_cast<double>(m_position) / static_cast<double>(m_file->size()));
            if (m_variables.size() >= kVariables)
                return impossibleField(m_path, "number of variables", "more than 10000");
            const Result<void> added = version == 5 ? addElement() : addOldMatrix();
            if (!added)
                return tl::unexpected(added.error());
        }
        if (const Result<void> expanded = expandAll(); !expanded)
            return tl::unexpected(expanded.error());
        return std::move(m_variables);
    }

private:
    /// A compressed element whose numbers are wanted.
    struct Compressed
    {
        std::uint64_t content;
        std::uint32_t size;
        std::size_t dataAt; ///< in what it expands to
        std::uint64_t dataBytes;
        std::size_t variable; ///< position in the list
    };

    tl::unexpected<Error> cut() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 ends within its variable number %2, so it is likely an incomplete copy; copy it again."),
                {m_path, std::to_string(m_variables.size() + 1)}},
            "CAP-018");
    }

    tl::unexpected<Error> damaged() const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is damaged: the header of its variable number %2 contradicts itself; copy the file again."),
                {m_path, std::to_string(m_variables.size() + 1)}},
            "CAP-018");
    }

    tl::unexpected<Error> badStream(std::size_t variable) const
    {
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is damaged: its compressed variable number %2 does not expand to what it declares; copy the file again."),
                {m_path, std::to_string(variable + 1)}},
            "CAP-018");
    }

    /// One element of version 5.
    Result<void> addElement()
    {
        const std::vector<std::byte> start = bytesAt(*m_file, m_position, 8);
        ByteReader bytes(start, m_order);
        const auto type = bytes.next<std::uint32_t>();
        const auto size = bytes.next<std::uint32_t>();
        const std::uint64_t content = m_position + 8;
        if (!bytes.ok() || size > m_file->size() - content)
            return cut();
        m_position = content + size;
        if (type == kCompressed)
            return addCompressed(content, size);
        if (type != kMatrix)
            return damaged();
        return addPlain(content, size);
    }

    Result<void> addPlain(std::uint64_t content, std::uint32_t size)
    {
        const std::vector<std::byte> raw
            = bytesAt(*m_file, content, std::min<std::size_t>(size, kHeadBytes));
        std::optional<MatrixHead> head = headOf(raw, m_order);
        if (!head || head->dataAt + head->dataBytes > size)
            return damaged();
        head->variable.offset = content + head->dataAt;
        add(std::move(head->variable));
        return {};
    }

    Result<void> addCompressed(std::uint64_t content, std::uint32_t size)
    {
        ZlibStream stream(m_file, content, size);
        std::vector<std::byte> raw(8 + kHeadBytes);
        raw.resize(stream.read(raw));
        ByteReader bytes(raw, m_order);
        const bool isMatrix = bytes.next<std::uint32_t>() == kMatrix;
        bytes.skip(4);
        if (!stream.ok() || !bytes.ok() || !isMatrix)
            return badStream(m_variables.size());
        const std::span<const std::byte> there = bytes.take(bytes.remaining());
        std::optional<MatrixHead> head = headOf(there, m_order);
        if (!head)
            return damaged();
        const bool numbers = head->dataBytes > 0;
        if (numbers && !m_budget.take(head->dataBytes)) {
            const Expanding what
                = m_budget.taken() > 0 ? Expanding::ChannelsUpTo : Expanding::Channel;
            return m_budget.exceededBy(
                m_path, what, head->variable.name, m_budget.taken() + head->dataBytes);
        }
        const std::size_t before = m_variables.size();
        add(std::move(head->variable));
        if (numbers && m_variables.size() > before)
            m_compressed.push_back({content, size, 8 + head->dataAt, head->dataBytes, before});
        return {};
    }

    /// Called when all variables are known to fit into the budget together.
    Result<void> expandAll()
    {
        for (const Compressed &place : m_compressed) {
            if (m_control.stopRequested())
                return fail(ErrorKind::Cancelled,
                    {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
            ZlibStream stream(m_file, place.content, place.size);
            std::vector<std::byte> head(place.dataAt);
            auto numbers = std::make_shared<std::vector<std::byte>>(
                static_cast<std::size_t>(place.dataBytes));
            std::array<std::byte, 64> padding{}; // at most that follows the numbers
            const bool whole
                = stream.read(head) == head.size() && stream.read(*numbers) == numbers->size();
            stream.read(padding);
            if (!whole || !stream.ok() || !stream.ended()) // the checksum comes after the last byte
                return badStream(place.variable);
            m_variables[place.variable].expanded = std::move(numbers);
        }
        return {};
    }

    void add(MatVariable variable)
    {
        const bool unnamed = variable.name.empty(); // MATLAB's own, not the user's
        const bool empty = variable.isNumeric() && variable.size() == 0;
        if (!unnamed && !empty)
            m_variables.push_back(std::move(variable));
    }

    /// One matrix of version 4, which has its byte order in every header.
    Result<void> addOldMatrix()
    {
        const std::vector<std::byte> head = bytesAt(*m_file, m_position, kHeadBytes);
        const std::string_view text(reinterpret_cast<const char *>(head.data()), head.size());
        if (head.size() < 20)
            return cut();
        const bool big = !isOldHeader(text, std::endian::little);
        if (big && !isOldHeader(text, std::endian::big))
            return damaged();
        ByteReader bytes(head, big ? std::endian::big : std::endian::little);
        const auto type = bytes.next<std::int32_t>();
        MatVariable variable;
        variable.order = big ? std::endian::big : std::endian::little;
        variable.rows = bytes.next<std::int32_t>();
        variable.columns = bytes.next<std::int32_t>();
        const bool complex = bytes.next<std::int32_t>() != 0;
        const auto nameBytes = static_cast<std::size_t>(bytes.next<std::int32_t>());
        variable.name = utf8Text(bytes.text(nameBytes));
        constexpr std::array kNumbers{MatNumber::Float64, MatNumber::Float32, MatNumber::Int32,
            MatNumber::Int16, MatNumber::UInt16, MatNumber::UInt8};
        constexpr std::array kKinds{"", "text", "sparse matrix"};
        variable.number = kNumbers[static_cast<std::size_t>(type / 10 % 10)];
        variable.kind = kKinds[static_cast<std::size_t>(type % 10)];
        if (complex && variable.kind.empty())
            variable.kind = "complex";
        variable.offset = m_position + bytes.position();
        const auto numbers = static_cast<std::uint64_t>(variable.size()); // below 2^62
        const std::uint64_t bytesEach
            = static_cast<std::uint64_t>(bytesOfMatNumber(variable.number)) * (complex ? 2 : 1);
        if (variable.offset > m_file->size()
            || numbers > (m_file->size() - variable.offset) / bytesEach)
            return cut();
        m_position = variable.offset + numbers * bytesEach;
        add(std::move(variable));
        return {};
    }

    const std::string &m_path;
    std::shared_ptr<const SampleFile> m_file;
    ExpansionBudget &m_budget;
    const JobControl &m_control;
    std::endian m_order = std::endian::little;
    std::uint64_t m_position = 0;
    std::vector<MatVariable> m_variables;
    std::vector<Compressed> m_compressed;
};

} // namespace

int matVersion(std::string_view head)
{
    const std::string_view end = head.substr(std::min<std::size_t>(head.size(), 124), 4);
    using std::string_view_literals::operator""sv;
    if (end == "\x00\x01IM"sv || end == "\x01\x00MI"sv)
        return 5;
    return isOldHeader(head, std::endian::little) || isOldHeader(head, std::endian::big) ? 4 : 0;
}

Result<std::vector<MatVariable>> listMatFile(const std::string &path,
    const std::shared_ptr<const SampleFile> &file, ExpansionBudget &budget,
    const JobControl &control)
{
    return MatLister(path, file, budget, control).list();
}

} // namespace dyncal
