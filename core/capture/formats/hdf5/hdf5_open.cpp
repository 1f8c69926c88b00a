// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_open.h"

#include "core/base/guarded_run.h"
#include "core/capture/formats/hdf5/hdf5_describe.h"
#include "core/capture/formats/hdf5/hdf5_helper.h"

#include <sys/stat.h>

#include <algorithm>

namespace dyncal {
namespace {

constexpr std::string_view kSignature("\x89HDF\r\n\x1a\n", 8);

tl::unexpected<Error> notHdf5(const std::string &path)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 cannot be opened as HDF5: it is incomplete, damaged or in use by another program; copy it again or close the other program."),
            {path}},
        "CAP-018");
}

/// Distinguishes a file from another one that took its place.
struct FileIdentity
{
    dev_t device = 0;
    ino_t node = 0;
    off_t bytes = 0;

    bool operator==(const FileIdentity &) const = default;
};

FileIdentity identityOf(const std::string &path)
{
    struct stat status
    {
    };
    if (::stat(path.c_str(), &status) != 0)
        return {};
    return {status.st_dev, status.st_ino, status.st_size};
}

/// No tree if the file cannot be opened.
Result<std::optional<Hdf5Tree>> describeAside(const std::string &path, Hdf5Depth depth,
    const ExpansionBudget &budget, const JobControl &control)
{
    const GuardedLimits limits{
        std::min(budget.allowed(), kDescribingLimits.memoryBytes), kDescribingLimits.time};
    std::vector<std::byte> received;
    const auto describe = [&](GuardedOutput &output) {
        if (const std::optional<Hdf5Tree> tree = describeHdf5(path, depth, budget))
            output.write(packed(*tree));
    };
    const auto receive = [&](std::span<const std::byte> bytes) {
        received.insert(received.end(), bytes.begin(), bytes.end());
        return received.size() <= limits.memoryBytes;
    };
    const Result<void> done = runHdf5Helper(path, describe, receive, limits, control);
    if (!done)
        return tl::unexpected(done.error());
    return unpackedTree(received);
}

} // namespace

Result<Hdf5File> openHdf5(const std::string &path, double maxExpansion, const JobControl &control)
{
    const FileIdentity before = identityOf(path);
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    const auto budget = std::make_shared<ExpansionBudget>((*file)->size(), maxExpansion);
    Result<std::optional<Hdf5Tree>> tree
        = describeAside(path, Hdf5Depth::Everything, *budget, control);
    if (!tree)
        return tl::unexpected(tree.error());
    if (!*tree || !(identityOf(path) == before) || !(*file)->unchanged())
        return notHdf5(path);
    if ((*tree)->tooManyBytes > 0)
        return budget->exceededBy(path, Expanding::Objects, std::to_string((*tree)->objects.size()),
            (*tree)->tooManyBytes * kDescriptionCopies);
    return Hdf5File{path, *file, std::move(**tree), budget};
}

Hdf5Attributes hdf5RootAttributes(const std::string &path)
{
    const auto tree = describeAside(path, Hdf5Depth::RootAttributes, ExpansionBudget(0), {});
    return tree && *tree ? (*tree)->objects.front().attributes : Hdf5Attributes();
}

bool hasHdf5Signature(std::string_view head)
{
    for (std::size_t offset = 0; offset < head.size(); offset = offset == 0 ? 512 : 2 * offset) {
        if (head.substr(offset).starts_with(kSignature))
            return true;
    }
    return false;
}

} // namespace dyncal
