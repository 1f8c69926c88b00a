// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/foreign/foreign_tree.h"

#include "core/capture/formats/hdf5/hdf5_obstacle.h"

#include <algorithm>

namespace dyncal {
namespace {

/// Walks the tree depth first, each object once, as links may make cycles. The description limits
/// the nesting (64 groups), so recursion is safe.
class Walk
{
public:
    explicit Walk(const Hdf5Tree &tree)
        : m_tree(tree)
        , m_seen(tree.objects.size(), false)
    {
        m_seen[0] = true;
        enter(tree.objects.front(), "", {&tree.objects.front()}, 0);
    }

    std::vector<ForeignDataset> datasets;

private:
    void enter(const Hdf5Object &group, const std::string &path,
        const std::vector<const Hdf5Object *> &groups, int depth)
    {
        constexpr int kDeepest = 1000; // no honest description gets there
        for (const Hdf5Link &link : group.links) {
            if (link.target < 0 || m_seen[static_cast<std::size_t>(link.target)])
                continue;
            m_seen[static_cast<std::size_t>(link.target)] = true;
            const Hdf5Object &object = m_tree.objects[static_cast<std::size_t>(link.target)];
            const std::string here = path + '/' + link.name;
            if (object.isDataset != 0) {
                datasets.push_back({here, link.name, &object, groups});
            } else if (depth < kDeepest) {
                std::vector<const Hdf5Object *> inner{&object};
                inner.insert(inner.end(), groups.begin(), groups.end());
                enter(object, here, inner, depth + 1);
            }
        }
    }

    const Hdf5Tree &m_tree;
    std::vector<bool> m_seen;
};

Message tooFew(const std::string &name)
{
    return {DYNCAL_TEXT("core", "%1 has fewer than two samples."), {name}};
}

} // namespace

std::vector<ForeignDataset> datasetsOf(const Hdf5Tree &tree)
{
    return Walk(tree).datasets;
}

Index linksNotFollowed(const Hdf5Tree &tree)
{
    Index count = 0;
    for (const Hdf5Object &object : tree.objects)
        count += std::count_if(object.links.begin(), object.links.end(),
            [](const Hdf5Link &link) { return link.target < 0; });
    return count;
}

ForeignChannels noChannels(Message why)
{
    ForeignChannels channels;
    channels.whyNot = std::move(why);
    return channels;
}

ForeignChannels channelsOf(const ForeignDataset &dataset, const std::string &file)
{
    const Hdf5Dataset &data = dataset.object->dataset;
    if (data.obstacle != Hdf5Obstacle::None)
        return noChannels(hdf5ObstacleError(file, dataset.path, data).value().message);
    if (dataset.object->tooManyAttributes != 0)
        return noChannels(
            {DYNCAL_TEXT("core",
                 "%1 has more than 1024 attributes, which were not read: its scale and unit are unknown."),
                {dataset.path}});
    ForeignChannels channels;
    if (data.shape.empty() || data.shape[0] > (std::uint64_t(1) << 48))
        return noChannels(tooFew(dataset.path));
    if (data.shape.size() == 1) {
        channels.samples = static_cast<Index>(data.shape[0]);
        channels.names = {dataset.path};
        return channels.samples >= 2 ? channels : noChannels(tooFew(dataset.path));
    }
    channels.sampleAxis
        = data.shape[0] < data.shape[1] && data.shape[0] <= kMaxTableColumns ? 1 : 0;
    const auto axis = static_cast<std::size_t>(channels.sampleAxis);
    if (data.shape[axis] < 2 || data.shape[1 - axis] == 0)
        return noChannels(tooFew(dataset.path));
    if (data.shape[1 - axis] > static_cast<std::uint64_t>(kMaxTableColumns))
        return noChannels(
            {DYNCAL_TEXT(
                 "core", "%1 is a table of %2 x %3 numbers; at most 64 columns become channels."),
                {dataset.path, std::to_string(data.shape[0]), std::to_string(data.shape[1])}});
    channels.samples = static_cast<Index>(data.shape[axis]);
    const std::uint64_t count = data.shape[1 - axis];
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::string column = std::to_string(i);
        const std::string suffix = axis == 0 ? "[:," + column + "]" : "[" + column + ",:]";
        channels.names.push_back(count == 1 ? dataset.path : dataset.path + suffix);
    }
    return channels;
}

} // namespace dyncal
