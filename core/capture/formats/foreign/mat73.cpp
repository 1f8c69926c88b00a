// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/foreign/mat73.h"

#include "core/capture/formats/foreign/foreign_hdf5.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace dyncal {
namespace {

constexpr std::size_t kHeadBytes = 520; ///< user block and HDF5 signature

bool isMat73Head(std::string_view head)
{
    constexpr std::size_t kVersionAt = 124; // 0x0200, in the byte order that follows it
    if (head.size() < kHeadBytes || !hasHdf5Signature(head.substr(0, kHeadBytes)))
        return false;
    const std::string_view version = head.substr(kVersionAt, 4);
    return head.starts_with("MATLAB 7.3 MAT-file") || version == std::string_view("\0\2IM", 4)
        || version == std::string_view("\2\0MI", 4);
}

bool isNumeric(const std::string &matlabClass)
{
    static constexpr std::array<std::string_view, 10> kClasses{"double", "single", "int8", "int16",
        "int32", "int64", "uint8", "uint16", "uint32", "uint64"};
    return std::find(kClasses.begin(), kClasses.end(), matlabClass) != kClasses.end();
}

/// "/x" is the variable x; below are fields of structures and contents of cells.
bool isVariable(const ForeignDataset &dataset)
{
    return dataset.groups.size() == 1;
}

/// Members of the root that are no matrices of real numbers, for the finding.
std::string otherVariables(const Hdf5File &file)
{
    std::string names;
    for (const Hdf5Link &link : file.root().links) {
        const Hdf5Object *object
            = link.target < 0 ? nullptr : &file.tree.objects[static_cast<std::size_t>(link.target)];
        const bool numeric = object != nullptr && object->isDataset != 0
            && object->dataset.obstacle != Hdf5Obstacle::NotNumbers
            && isNumeric(textAttribute(*object, "MATLAB_class").value_or(""));
        const bool ownTable = link.name.starts_with('#'); // "#refs#", "#subsystem#"
        if (!numeric && !ownTable)
            names.append(names.empty() ? "" : ", ").append(link.name);
    }
    return names;
}

} // namespace

int recogniseMat73(const std::string &, std::string_view head)
{
    constexpr int kCertain = 100;
    return isMat73Head(head) ? kCertain : 0;
}

bool isMat73(const std::string &path)
{
    std::string head(kHeadBytes, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return isMat73Head(head);
}

ForeignChannels mat73ChannelsOf(const ForeignDataset &variable, const std::string &file)
{
    if (!isVariable(variable))
        return noChannels(
            {DYNCAL_TEXT("core", "%1 is part of a structure or a cell."), {variable.path}});
    const std::string matlabClass
        = textAttribute(*variable.object, "MATLAB_class").value_or("without class");
    const bool special = variable.object->attributes.contains("MATLAB_empty")
        || variable.object->attributes.contains("MATLAB_sparse");
    if (!isNumeric(matlabClass) || special)
        return noChannels({DYNCAL_TEXT("core", "%1 (%2) is no full matrix of real numbers."),
            {variable.name, matlabClass}});
    ForeignChannels channels = channelsOf(variable, file);
    if (channels.names.size() == 1)
        channels.names = {variable.name};
    const bool columns = channels.sampleAxis == 1; // MATLAB's first dimension is HDF5's last
    for (std::size_t i = 0; channels.names.size() > 1 && i < channels.names.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        channels.names[i] = variable.name + (columns ? "(:," + number + ")" : "(" + number + ",:)");
    }
    return channels;
}

Result<CaptureSet> readMat73(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const Result<Hdf5File> file = openHdf5(path, settings.maxExpansion, control);
    if (!file)
        return tl::unexpected(file.error());
    return readMat73(*file, settings, control);
}

Result<CaptureSet> readMat73(
    const Hdf5File &file, const ImportSettings &settings, const JobControl &control)
{
    std::vector<ForeignDataset> variables = datasetsOf(file.tree);
    std::erase_if(variables, [](const ForeignDataset &dataset) { return !isVariable(dataset); });
    std::vector<ChannelCandidate> candidates;
    for (const ForeignDataset &variable : variables)
        candidates.push_back(candidateOf(variable, mat73ChannelsOf(variable, file.path)));
    Result<CaptureSet> set = readCandidates(file, variables, candidates, settings, control);
    const std::string others = otherVariables(file);
    if (set && !others.empty())
        set->findings.push_back({.id = "CAP-026",
            .severity = Severity::Info,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: %2 is no matrix of numbers (a structure, cell, text or the like) and was left out."),
                {file.path, others}}});
    return set;
}

} // namespace dyncal
