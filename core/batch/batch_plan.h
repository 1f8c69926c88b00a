// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/kept_message.h"
#include "core/base/result.h"
#include "core/project/recipe.h"
#include "core/results/method_versions.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dyncal {

/// A file of a sensor as it was when the batch was planned.
struct PlannedFile
{
    std::string file; ///< base name
    std::string sha256;
    std::uintmax_t bytes = 0;

    bool operator==(const PlannedFile &) const = default;
};

/// One sensor of a batch: what is to be computed from what, and where it goes. All paths are
/// relative to the folder that the plan lies in, '/' between their parts, so that plan, recordings
/// and results may be moved or mounted elsewhere together.
struct PlannedSensor
{
    std::string id; ///< path below the root that was planned
    std::string source; ///< folder of its recordings, or the one file
    std::vector<PlannedFile> inputs; ///< all files of the source, in the order they are read in
    std::string recipe; ///< path; empty: the defaults
    std::string profile; ///< path; empty: none
    std::string recipeSha256; ///< of the recipe over the profile with every default (recipeJson)
    MethodVersions methods;
    std::string output; ///< folder of the sensor's own
    std::string obstacle; ///< why it cannot be calibrated; inputs and hashes are then missing
    KeptMessage said = {}; ///< the obstacle as it can be translated

    bool operator==(const PlannedSensor &) const = default;
};

using BatchPlan = std::vector<PlannedSensor>;

/// The sensor as one line of JSON, schema "dyncal-batch-plan/1", with LF.
std::string planLine(const PlannedSensor &sensor);

/// The sensors of a plan's text, one on each line that is not empty; `name` is the plan's for
/// messages. Fails (Usage), naming the line, on what is no such sensor, on a hash or path of an
/// impossible form (an output must lie below the plan), and where an id or output stands twice.
Result<BatchPlan> parsePlan(const std::string &text, const std::string &name);

/// The plan in a file; fails as parsePlan, and (FileUnreadable) where it cannot be read.
Result<BatchPlan> readPlan(const std::string &path);

/// What the sensor's results depend on, as one hash: names, order and content of its files, the
/// joined recipe, the versions of the methods. Equal keys mean equal results.json but for its time.
std::string sensorKey(const PlannedSensor &sensor);

/// What PlannedSensor::recipeSha256 is: the hash of every decision, that of the files it names too,
/// and of the template with its logo where it names a file (by its place, locateTemplate). Fails
/// as chooseTemplate where that cannot be read.
Result<std::string> hashOfRecipe(const Recipe &recipe);

/// The folder that the paths of a plan are relative to.
std::string folderOfPlan(const std::string &planPath);

} // namespace dyncal
