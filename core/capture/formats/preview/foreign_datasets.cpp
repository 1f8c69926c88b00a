// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/preview/foreign_datasets.h"

#include "core/capture/formats/foreign/mat73.h"

namespace dyncal {
namespace {

/// With fewer samples no start can be found (core/signal/start_detection.h).
constexpr Index kLeastOfWaveform = 64;

/// Readers accept short datasets by name, but the dialog must not offer them.
void withholdShort(ForeignChannels &channels, const std::string &path)
{
    if (channels.names.empty() || channels.samples >= kLeastOfWaveform)
        return;
    channels.names.clear();
    channels.whyNot = {DYNCAL_TEXT("core", "Dataset %1 has %2 values - not a waveform."),
        {path, std::to_string(channels.samples)}};
}

} // namespace

Result<std::vector<DatasetEntry>> listDatasets(const std::string &path, const JobControl &control)
{
    const Result<Hdf5File> file = openHdf5(path, kUsualExpansion, control);
    if (!file)
        return tl::unexpected(file.error());
    const bool matlab = isMat73(path);
    std::vector<DatasetEntry> entries;
    for (const ForeignDataset &dataset : datasetsOf(file->tree)) {
        ForeignChannels channels
            = matlab ? mat73ChannelsOf(dataset, path) : channelsOf(dataset, path);
        withholdShort(channels, dataset.path);
        const Hdf5Dataset &data = dataset.object->dataset;
        entries.push_back({dataset.path, data.typeText, data.shape, attributeTexts(*dataset.object),
            std::move(channels.names), std::move(channels.whyNot)});
    }
    return entries;
}

} // namespace dyncal
