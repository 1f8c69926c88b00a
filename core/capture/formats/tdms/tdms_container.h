// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/capture/formats/bytes/expansion_budget.h"
#include "core/capture/formats/tdms/tdms_layout.h"

#include <memory>
#include <vector>

namespace dyncal {

/// Everything a TDMS file holds, without its samples.
struct TdmsContents
{
    std::shared_ptr<const SampleFile> file;
    std::vector<TdmsObject> objects; ///< as they first appear; the file itself is among them
    bool endsEarly = false; ///< cut off, or not closed by the program that wrote it
    std::optional<Message> damage; ///< why the file was not read to its end
    std::optional<std::uint32_t> unknownVersion;

    const TdmsObject *root() const;
    const TdmsObject *group(const std::string &name) const;
};

/// Reads lead-ins and metadata of all segments; of the samples only the positions. Nothing is used
/// of a damaged segment or of those after it. Fails (CAP-018) if the first segment is damaged or
/// there is none or their places take more memory than the file's size times `maxExpansion`
/// (ExpansionBudget), (CAP-001) if it is no TDMS file or only the index of one.
Result<TdmsContents> readTdmsContents(
    const std::string &path, const JobControl &control, double maxExpansion = kUsualExpansion);

} // namespace dyncal
