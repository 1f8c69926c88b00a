// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_describe.h"

#include "core/capture/formats/hdf5/hdf5_attributes.h"
#include "core/capture/formats/hdf5/hdf5_dataset.h"
#include "core/capture/natural_order.h"

#include <algorithm>
#include <deque>

namespace dyncal {
namespace {

constexpr std::size_t kMaxObjects = 20'000;
constexpr std::size_t kMaxLinks = 200'000; ///< of one group
constexpr int kMaxDepth = 64;
constexpr hsize_t kMaxAttributes = 1024; ///< of one object

struct FoundLink
{
    std::string name;
    std::optional<haddr_t> address; ///< of hard links
};

struct FoundLinks
{
    DescribedBytes &bytes;
    std::vector<FoundLink> links = {};
};

herr_t collectLink(hid_t, const char *name, const H5L_info_t *info, void *data)
{
    auto &found = *static_cast<FoundLinks *>(data);
    const bool hard = info->type == H5L_TYPE_HARD;
    found.links.push_back({name, hard ? std::optional(info->u.address) : std::nullopt});
    found.bytes.count += sizeof(FoundLink) + found.links.back().name.size();
    if (found.bytes.tooMany())
        return 1; // ends the walk; the caller sees why
    return found.links.size() < kMaxLinks ? 0 : -1;
}

/// Members of a group: in order of creation where the file knows it, otherwise in natural order.
std::optional<std::vector<FoundLink>> linksOf(hid_t group, DescribedBytes &bytes)
{
    FoundLinks found{bytes};
    const Hdf5Handle creation(H5Gget_create_plist(group), &H5Pclose);
    unsigned int order = 0;
    const bool tracked = creation.valid() && H5Pget_link_creation_order(creation.id(), &order) >= 0
        && (order & H5P_CRT_ORDER_TRACKED) != 0;
    const H5_index_t index = tracked ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
    if (H5Literate(group, index, H5_ITER_INC, nullptr, &collectLink, &found) < 0)
        return std::nullopt;
    if (!tracked)
        std::sort(found.links.begin(), found.links.end(),
            [](const FoundLink &a, const FoundLink &b) { return naturalLess(a.name, b.name); });
    return std::move(found.links);
}

/// Walks the file breadth first; every object is described once, however many links lead to it.
class TreeMaker
{
public:
    TreeMaker(hid_t file, const ExpansionBudget &budget)
        : m_file(file)
    {
        m_described.most = budget.allowed() / kDescriptionCopies;
        m_facts.allowedBytes = budget.allowed();
        H5Fget_filesize(file, &m_facts.bytes);
        const Hdf5Handle creation(H5Fget_create_plist(file), &H5Pclose);
        H5Pget_userblock(creation.id(), &m_facts.userBlockBytes);
    }

    std::optional<Hdf5Tree> make(Hdf5Depth depth)
    {
        H5O_info_t root;
        if (H5Oget_info2(m_file, &root, H5O_INFO_BASIC) < 0 || add(root.addr, 0) != 0)
            return std::nullopt;
        while (goesOn() && depth == Hdf5Depth::Everything && !m_groups.empty()) {
            const Group group = m_groups.front();
            m_groups.pop_front();
            readLinks(group);
        }
        m_tree.tooManyBytes = m_described.tooMany() ? m_described.count : 0;
        return m_damaged ? std::nullopt : std::optional(std::move(m_tree));
    }

private:
    struct Group
    {
        Index object;
        int depth;
    };

    bool goesOn() const { return !m_damaged && !m_described.tooMany(); }

    Hdf5Object &object(Index position)
    {
        return m_tree.objects[static_cast<std::size_t>(position)];
    }

    /// Position of the object at this address, described now if it is new.
    Index add(haddr_t address, int depth)
    {
        if (const auto known = m_positions.find(address); known != m_positions.end())
            return known->second;
        const Hdf5Handle opened(H5Oopen_by_addr(m_file, address), &H5Oclose);
        const H5I_type_t kind = opened.valid() ? H5Iget_type(opened.id()) : H5I_BADID;
        m_damaged = m_damaged || !opened.valid();
        const bool usable = (kind == H5I_GROUP || kind == H5I_DATASET) && depth <= kMaxDepth
            && m_tree.objects.size() < kMaxObjects;
        const Index position = usable ? std::ssize(m_tree.objects) : Hdf5Link::kNotRead;
        m_positions[address] = position;
        if (!usable)
            return position;
        m_described.count += sizeof(Hdf5Object);
        m_tree.objects.push_back(described(opened.id(), kind, address));
        if (kind == H5I_GROUP)
            m_groups.push_back({position, depth});
        return position;
    }

    Hdf5Object described(hid_t opened, H5I_type_t kind, haddr_t address)
    {
        Hdf5Object result;
        result.address = address;
        H5O_info_t info;
        const bool counted = H5Oget_info2(opened, &info, H5O_INFO_NUM_ATTRS) >= 0;
        result.tooManyAttributes = !counted || info.num_attrs > kMaxAttributes;
        if (!result.tooManyAttributes)
            result.attributes = readAttributes(opened, m_described);
        result.isDataset = kind == H5I_DATASET;
        if (result.isDataset == 0)
            return result;
        std::optional<Hdf5Dataset> dataset = describeDataset(opened, m_facts);
        m_damaged = m_damaged || !dataset;
        result.dataset = dataset.value_or(Hdf5Dataset());
        m_described.count += result.dataset.blockOffsets.size() * sizeof(std::uint64_t);
        return result;
    }

    void readLinks(const Group &group)
    {
        const Hdf5Handle opened(H5Oopen_by_addr(m_file, object(group.object).address), &H5Oclose);
        const auto links = opened.valid() ? linksOf(opened.id(), m_described) : std::nullopt;
        m_damaged = m_damaged || !links;
        for (const FoundLink &link : links.value_or(std::vector<FoundLink>())) {
            if (!goesOn())
                return;
            const Index target
                = link.address ? add(*link.address, group.depth + 1) : Hdf5Link::kElsewhere;
            object(group.object).links.push_back({link.name, target});
        }
    }

    hid_t m_file;
    Hdf5FileFacts m_facts;
    DescribedBytes m_described;
    bool m_damaged = false;
    Hdf5Tree m_tree;
    std::map<haddr_t, Index> m_positions;
    std::deque<Group> m_groups;
};

} // namespace

Hdf5Handle openHdf5File(const std::string &path, std::size_t cacheBytes)
{
    constexpr std::size_t kCacheSlots = 10'007; // a prime, about 100 times the chunks that fit
    constexpr double kPreemption = 0.75; // the library's default
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    const std::size_t slots = cacheBytes > 0 ? kCacheSlots : 1; // each dataset has its own
    H5Pset_cache(access.id(), 0, slots, cacheBytes, kPreemption);
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()), &H5Fclose};
}

std::optional<Hdf5Tree> describeHdf5(
    const std::string &path, Hdf5Depth depth, const ExpansionBudget &budget)
{
    const Hdf5Handle file = openHdf5File(path, 0); // no chunk is read
    return file.valid() ? describeHdf5(file.id(), depth, budget) : std::nullopt;
}

std::optional<Hdf5Tree> describeHdf5(hid_t file, Hdf5Depth depth, const ExpansionBudget &budget)
{
    return TreeMaker(file, budget).make(depth);
}

} // namespace dyncal
