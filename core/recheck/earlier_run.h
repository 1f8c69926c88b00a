// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/recipe.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace dyncal {

/// A recording as results.json names it.
struct RecordedInput
{
    std::string file; ///< base name
    std::string sha256; ///< of its bytes
};

/// What a run left behind that it can be computed again from.
struct EarlierRun
{
    std::string folder;
    nlohmann::json results; ///< as parseResults() reads it
    Recipe recipe; ///< with the files that it names
    std::vector<RecordedInput> inputs; ///< in the order they were read
    std::vector<Message> remarks; ///< what of the folder is not as a run leaves it
};

inline constexpr const char *kResultsFile = "results.json";

/// A results.json as it is on disk.
struct EarlierResults
{
    std::string file; ///< its path
    nlohmann::json results; ///< as parseResults() reads it
    std::string sha256; ///< of its bytes
    std::vector<Message> remarks; ///< that it is not the file that written.json beside it lists
};

/// Reads a results.json, under whatever name, or the one of a folder. Fails (FileUnreadable) where
/// it is not there or cannot be read, (Usage) as parseResults() does.
Result<EarlierResults> readEarlierResults(const std::string &path);

/// Every folder that holds a results.json, the given one and all below it, hidden ones left out, in
/// natural order; links to folders are not followed. Fails (FileUnreadable) if it is no folder, and
/// if there is none.
Result<std::vector<std::string>> runFoldersBelow(const std::string &folder);

/// Reads the folder of a run. The recipe is the one that results.json holds, so that a missing or
/// other recipe.json changes nothing; files that it names are the copies that the run kept, else
/// those where it says, seen from the folder, with the hash that it states. Remarks: a results.json
/// that is not the one that written.json lists, a recipe.json that says something else, keys that
/// the recipe lacks, because they are newer. Fails (FileUnreadable) where results.json or such a
/// file is not there; (Usage) as parseResults() and parseRecipe() do, and where no recording is
/// named with its hash.
Result<EarlierRun> readEarlierRun(const std::string &folder);

} // namespace dyncal
