// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"

#include <optional>
#include <string>
#include <vector>

namespace dyncal {

/// What is taken for a sensor.
struct SensorSearch
{
    std::string root; ///< folder to look through
    bool eachFile = false; ///< every recording is a sensor; else every folder with recordings
    std::vector<std::string> settings; ///< paths of recipe and profile: never taken for recordings
};

/// A sensor found, or why something that lies there is none.
struct FoundSensor
{
    std::string id; ///< path below the root, '/' between its parts
    std::string source; ///< path, beginning with the root as given
    std::vector<std::string> files; ///< paths, in natural order
    std::string recipe; ///< path of the sensor's own recipe; empty: none
    std::optional<Message> obstacle = {}; ///< why it cannot be planned
};

/// Looks through all folders below the root, hidden ones left out, in natural order of the ids. A
/// recipe of a sensor's own lies in its folder as recipe.json; with `eachFile` beside the file as
/// NAME.recipe.json, NAME without its extension. Folders that hold nothing but settings or other
/// folders are no sensors; one that holds files of which none is a recording, recordings directly
/// in the root (without `eachFile`), links to folders and names that are no UTF-8 have an obstacle.
/// Fails (FileUnreadable) if the root is no folder that can be listed.
Result<std::vector<FoundSensor>> findSensors(const SensorSearch &search);

} // namespace dyncal
