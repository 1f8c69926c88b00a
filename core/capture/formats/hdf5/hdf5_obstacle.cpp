// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_obstacle.h"

#include "core/capture/formats/bytes/expansion_budget.h"

namespace dyncal {
namespace {

Message sentenceOf(const Hdf5Dataset &dataset, const std::string &path, const std::string &name)
{
    switch (dataset.obstacle) {
    case Hdf5Obstacle::Elsewhere:
        return {
            DYNCAL_TEXT("core",
                "%1: the samples of channel %2 lie in another file (%3), which is not opened; copy them into this file, for example with h5repack."),
            {path, name, dataset.elsewhere}};
    case Hdf5Obstacle::Incomplete:
        return {
            DYNCAL_TEXT("core",
                "%1: channel %2 claims more samples than the file holds; the copy is incomplete or damaged, copy it again."),
            {path, name}};
    case Hdf5Obstacle::Filter:
        return {
            DYNCAL_TEXT("core",
                "%1: channel %2 is compressed with HDF5 filter %3, which is not installed here; save the file with deflate or without compression."),
            {path, name, std::to_string(dataset.missingFilter)}};
    case Hdf5Obstacle::LargeChunk:
        return {
            DYNCAL_TEXT("core",
                "%1: channel %2 is compressed in chunks of more than 64 MiB; save the file with smaller chunks or without compression."),
            {path, name}};
    case Hdf5Obstacle::TooLarge:
        return {
            DYNCAL_TEXT("core",
                "%1: channel %2 would make more than 4 GiB unpacked; save the file without compression."),
            {path, name}};
    case Hdf5Obstacle::OverBudget:
        return expansionSentence(
            path, Expanding::Channel, name, dataset.unpackedBytes, dataset.allowedBytes);
    case Hdf5Obstacle::None:
    case Hdf5Obstacle::NotNumbers:
    case Hdf5Obstacle::Shape:
        break;
    }
    return {
        DYNCAL_TEXT("core",
            "%1: channel %2 is no list of numbers; a channel is a one-dimensional dataset of integers or floating point numbers."),
        {path, name}};
}

} // namespace

tl::unexpected<Error> hdf5ObstacleError(
    const std::string &path, const std::string &name, const Hdf5Dataset &dataset)
{
    return fail(ErrorKind::FileUnreadable, sentenceOf(dataset, path, name), "CAP-018");
}

} // namespace dyncal
