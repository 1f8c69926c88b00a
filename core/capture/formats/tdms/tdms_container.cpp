// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/tdms/tdms_container.h"

#include <algorithm>
#include <filesystem>
#include <unordered_map>
#include <unordered_set>

namespace dyncal {
namespace {

constexpr std::uint64_t kLeadInBytes = 28;
constexpr std::uint32_t kTag = 0x6D534454; // "TDSm"
constexpr std::uint32_t kIndexTag = 0x68534454; // "TDSh"
constexpr std::uint64_t kNotClosed = 0xFFFFFFFFFFFFFFFF;
constexpr std::size_t kMostKeptObjects = 1 << 16;

/// Bits of the table of contents.
constexpr std::uint32_t kMetaData = 1 << 1;
constexpr std::uint32_t kNewObjectList = 1 << 2;
constexpr std::uint32_t kRawData = 1 << 3;
constexpr std::uint32_t kInterleaved = 1 << 5;
constexpr std::uint32_t kBigEndian = 1 << 6;

using Unexpected = tl::unexpected<TdmsProblem>;

struct LeadIn
{
    std::uint32_t contents = 0;
    std::uint32_t version = 0;
    std::uint64_t next = 0; ///< segment, from the end of the lead-in
    std::uint64_t data = 0; ///< from the end of the lead-in

    bool has(std::uint32_t bit) const { return (contents & bit) != 0; }
};

/// Whether values of the type are samples; texts, time stamps and complex numbers are not.
bool isSampleType(TdmsType type)
{
    switch (type) {
    case TdmsType::Void:
    case TdmsType::String:
    case TdmsType::Timestamp:
    case TdmsType::Complex64:
    case TdmsType::Complex128:
    case TdmsType::DaqmxRaw:
        return false;
    default:
        return true;
    }
}

std::vector<TdmsStream> streamsOf(const TdmsRawIndex &index)
{
    if (!index.isDaqmx())
        return isSampleType(index.type) ? std::vector{TdmsStream{index.type, -1, 0, {}}}
                                        : std::vector<TdmsStream>{};
    std::vector<TdmsStream> streams;
    for (const TdmsScaler &scaler : index.scalers)
        streams.push_back({scaler.type, scaler.bit, scaler.scaleId, {}});
    const bool readable = std::all_of(streams.begin(), streams.end(),
        [](const TdmsStream &stream) { return isSampleType(stream.type); });
    return readable ? streams : std::vector<TdmsStream>{};
}

bool sameStreams(const std::vector<TdmsStream> &a, const std::vector<TdmsStream> &b)
{
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const TdmsStream &x, const TdmsStream &y) {
            return x.type == y.type && x.bit == y.bit && x.scaleId == y.scaleId;
        });
}

class ContainerReader
{
public:
    ContainerReader(
        std::shared_ptr<const SampleFile> file, const std::string &path, double maxExpansion)
        : m_path(path)
        , m_budget(file->size(), maxExpansion)
        , m_cursor(*file)
        , m_fileBytes(file->size())
        , m_workLeft(kWorkAtLeast + file->size() / kBytesPerWork)
    {
        m_contents.file = std::move(file);
    }

    Result<TdmsContents> read(const JobControl &control)
    {
        constexpr int kSegmentsPerCheck = 1024;
        for (int count = 0; !m_ended && m_position < m_fileBytes; ++count) {
            if (count % kSegmentsPerCheck == 0 && control.stopRequested())
                return fail(ErrorKind::Cancelled,
                    {DYNCAL_TEXT("core", "Reading %1 was cancelled."), {m_path}});
            const auto segment = readSegment();
            if (m_refused > 0)
                return m_budget.exceededBy(
                    m_path, Expanding::Pieces, std::to_string(m_refused / kBytesOfRun), m_refused);
            if (!segment) {
                if (count == 0)
                    return fail(ErrorKind::FileUnreadable, sentence(segment.error()), "CAP-018");
                m_contents.damage = sentence(segment.error());
                break;
            }
        }
        return std::move(m_contents);
    }

private:
    /// Limit on the channels and segments read in all, so that a small file cannot claim endless
    /// work. A real file needs less than one per byte of samples.
    static constexpr std::uint64_t kWorkAtLeast = 1'000'000;
    static constexpr std::uint64_t kBytesPerWork = 2;

    /// Lists grow by doubling, and a channel has its own.
    static constexpr std::uint64_t kBytesOfRun = 3 * (sizeof(TdmsRun) + sizeof(Index));

    Message sentence(const TdmsProblem &problem) const
    {
        Message message{problem.text, {m_path, std::to_string(m_position)}};
        message.arguments.insert(
            message.arguments.end(), problem.arguments.begin(), problem.arguments.end());
        return message;
    }

    /// Moves m_position to the end of the segment.
    tl::expected<void, TdmsProblem> readSegment()
    {
        LeadIn lead;
        if (auto known = readLeadIn(lead); !known || m_ended)
            return known;
        const std::uint64_t begin = m_position + kLeadInBytes;
        const std::uint64_t room = m_fileBytes - begin;
        const bool open = lead.next == kNotClosed || lead.next > room;
        m_contents.endsEarly = m_contents.endsEarly || open;
        m_ended = open;
        if (lead.data > std::min(lead.next, room)) {
            if (lead.data > room && open)
                return {}; // the file ends within the metadata
            return Unexpected(
                {DYNCAL_TEXT("core",
                     "%1 is damaged: the samples of the segment at byte %2 would begin behind its end."),
                    {}});
        }
        if (lead.has(kMetaData)) {
            m_cursor.limit(begin + lead.data);
            if (auto applied = readMetadata(lead.has(kNewObjectList)); !applied)
                return applied;
        }
        if (lead.has(kRawData)) {
            if (auto placed = placeData(lead, begin, open ? room : lead.next); !placed)
                return placed;
        }
        m_position = begin + (open ? room : lead.next);
        return {};
    }

    tl::expected<void, TdmsProblem> readLeadIn(LeadIn &lead)
    {
        m_cursor.limit(m_fileBytes);
        m_cursor.moveTo(m_position);
        m_cursor.setByteOrder(std::endian::little);
        std::uint32_t tag = 0;
        if (m_fileBytes - m_position < kLeadInBytes) {
            m_contents.endsEarly = true;
            m_ended = true;
            return {};
        }
        m_cursor.number(tag);
        m_cursor.number(lead.contents);
        m_cursor.setByteOrder(lead.has(kBigEndian) ? std::endian::big : std::endian::little);
        m_cursor.number(lead.version);
        m_cursor.number(lead.next);
        if (!m_cursor.number(lead.data) || tag != kTag)
            return Unexpected(
                {DYNCAL_TEXT("core",
                     "%1 is damaged: at byte %2, where a segment should begin, there is none."),
                    {}});
        constexpr std::uint32_t kVersion1 = 4712;
        constexpr std::uint32_t kVersion2 = 4713;
        if (lead.version != kVersion1 && lead.version != kVersion2)
            m_contents.unknownVersion = lead.version;
        return {};
    }

    tl::expected<void, TdmsProblem> readMetadata(bool newList)
    {
        auto entries = readTdmsObjects(m_cursor);
        if (!entries)
            return Unexpected(entries.error());
        if (auto valid = checkEntries(*entries); !valid)
            return valid;
        if (newList) {
            for (const std::size_t id : m_list)
                m_listed[id] = 0;
            m_list.clear();
        }
        for (TdmsObjectEntry &entry : *entries)
            apply(std::move(entry));
        m_dataChanged = true;
        return {};
    }

    /// Nothing of a segment is used before all of it is checked.
    tl::expected<void, TdmsProblem> checkEntries(const std::vector<TdmsObjectEntry> &entries) const
    {
        if (m_contents.objects.size() + entries.size() > 2 * kMostKeptObjects)
            return Unexpected(
                {DYNCAL_TEXT("core",
                     "%1 is damaged: up to byte %2 it names more channels than any recording has."),
                    {}});
        std::unordered_set<std::string_view> paths;
        for (const TdmsObjectEntry &entry : entries) {
            if (!paths.insert(entry.path).second)
                return Unexpected({DYNCAL_TEXT("core",
                                       "%1 is damaged: the segment at byte %2 describes %3 twice."),
                    {entry.path}});
            const auto known = m_ids.find(entry.path);
            const TdmsObject *object
                = known != m_ids.end() ? &m_contents.objects[known->second] : nullptr;
            if (object == nullptr && !parseTdmsPath(entry.path))
                return Unexpected(
                    {DYNCAL_TEXT("core",
                         "%1 is damaged: the segment at byte %2 has an object with the name %3, which is no path."),
                        {entry.path}});
            const bool had = object != nullptr && object->index;
            if (entry.kind == TdmsIndexKind::AsBefore && !had)
                return Unexpected(
                    {DYNCAL_TEXT("core",
                         "%1 is damaged: the segment at byte %2 says that the data of %3 are as before, but there were none."),
                        {entry.path}});
            if (entry.kind == TdmsIndexKind::Given && had
                && (object->type != entry.index.type
                    || !sameStreams(object->streams, streamsOf(entry.index))))
                return Unexpected(
                    {DYNCAL_TEXT("core",
                         "%1: the samples of %3 change their type in the segment at byte %2; such a record cannot be read as one."),
                        {entry.path}});
        }
        return {};
    }

    std::size_t idOf(const std::string &path)
    {
        const auto [place, isNew] = m_ids.try_emplace(path, m_contents.objects.size());
        if (isNew) {
            m_contents.objects.emplace_back().path = *parseTdmsPath(path);
            m_listed.push_back(0);
            m_hasData.push_back(0);
        }
        return place->second;
    }

    void apply(TdmsObjectEntry entry)
    {
        const std::size_t id = idOf(entry.path);
        TdmsObject &object = m_contents.objects[id];
        for (auto &[name, value] : entry.properties)
            object.properties.insert_or_assign(std::move(name), std::move(value));
        if (entry.kind == TdmsIndexKind::Given) {
            if (!object.index) {
                object.type = entry.index.type;
                object.streams = streamsOf(entry.index);
            }
            object.index = std::move(entry.index);
        }
        m_hasData[id] = entry.kind != TdmsIndexKind::NoData ? 1 : 0;
        if (m_listed[id] == 0) {
            m_listed[id] = 1;
            m_list.push_back(id);
        }
    }

    bool takeWork(std::size_t amount)
    {
        const bool enough = m_workLeft >= amount;
        m_workLeft -= enough ? amount : m_workLeft;
        return enough;
    }

    tl::expected<void, TdmsProblem> placeData(
        const LeadIn &lead, std::uint64_t begin, std::uint64_t bytes)
    {
        const std::size_t lookedAt = m_dataChanged ? m_list.size() : m_withData.size();
        if (!takeWork(lookedAt + 1))
            return Unexpected(
                {DYNCAL_TEXT("core",
                     "%1 is damaged: up to the segment at byte %2 it lists far more channels than it has samples."),
                    {}});
        if (m_dataChanged)
            m_withData = listedWithData();
        m_dataChanged = false;
        std::vector<TdmsObject *> objects;
        for (const std::size_t id : m_withData)
            objects.push_back(&m_contents.objects[id]);
        TdmsRegion region;
        region.begin = begin + lead.data;
        region.bytes = bytes - lead.data;
        region.declaredBytes = lead.next == kNotClosed ? region.bytes : lead.next - lead.data;
        region.interleaved = lead.has(kInterleaved);
        region.bigEndian = lead.has(kBigEndian);
        region.ended = m_ended;
        const std::size_t before = runsOf(objects);
        const auto placed = placeTdmsRegion(region, objects);
        const std::uint64_t places = (runsOf(objects) - before) * kBytesOfRun;
        m_refused = m_budget.take(places) ? 0 : m_budget.taken() + places;
        m_ended = m_ended || m_refused > 0;
        return placed;
    }

    static std::size_t runsOf(const std::vector<TdmsObject *> &objects)
    {
        std::size_t runs = 0;
        for (const TdmsObject *object : objects) {
            for (const TdmsStream &stream : object->streams)
                runs += stream.runs.runs().size();
        }
        return runs;
    }

    std::vector<std::size_t> listedWithData() const
    {
        std::vector<std::size_t> ids;
        std::copy_if(m_list.begin(), m_list.end(), std::back_inserter(ids),
            [this](std::size_t id) { return m_hasData[id] != 0; });
        return ids;
    }

    const std::string &m_path;
    ExpansionBudget m_budget;
    std::uint64_t m_refused = 0; ///< bytes beyond the budget
    TdmsContents m_contents;
    TdmsCursor m_cursor;
    std::uint64_t m_fileBytes;
    std::uint64_t m_workLeft;
    std::uint64_t m_position = 0; ///< of the segment being read
    bool m_ended = false;
    std::unordered_map<std::string, std::size_t> m_ids; ///< path -> object
    std::vector<std::size_t> m_list; ///< objects of the current list, in its order
    std::vector<char> m_listed; ///< by object
    std::vector<char> m_hasData; ///< by object, for the current list
    std::vector<std::size_t> m_withData; ///< of m_list
    bool m_dataChanged = false;
};

/// What the file is, by its first four bytes.
Result<void> checkTag(const SampleFile &file, const std::string &path)
{
    TdmsCursor cursor(file);
    std::uint32_t tag = 0;
    if (cursor.number(tag) && tag == kTag)
        return {};
    if (tag == kIndexTag)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 is only the index of a TDMS file and holds no samples; open %2, which belongs to it."),
                {path, std::filesystem::path(path).replace_extension(".tdms").filename().string()}},
            "CAP-001");
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "%1 is no TDMS file: it does not begin with \"TDSm\"."), {path}},
        "CAP-001");
}

} // namespace

const TdmsObject *TdmsContents::root() const
{
    const auto found = std::find_if(objects.begin(), objects.end(),
        [](const TdmsObject &object) { return object.path.level == TdmsLevel::File; });
    return found != objects.end() ? &*found : nullptr;
}

const TdmsObject *TdmsContents::group(const std::string &name) const
{
    const auto found = std::find_if(objects.begin(), objects.end(), [&](const TdmsObject &object) {
        return object.path.level == TdmsLevel::Group && object.path.group == name;
    });
    return found != objects.end() ? &*found : nullptr;
}

Result<TdmsContents> readTdmsContents(
    const std::string &path, const JobControl &control, double maxExpansion)
{
    Result<std::shared_ptr<const SampleFile>> file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    if (const Result<void> known = checkTag(**file, path); !known)
        return tl::unexpected(known.error());
    return ContainerReader(std::move(*file), path, maxExpansion).read(control);
}

} // namespace dyncal
