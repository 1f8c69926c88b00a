// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "core/project/recipe.h"
#include "core/results/method_versions.h"
#include "tests/support/scratch_folder.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Results of a run as the tests of core/recheck need them: written down, not computed.
namespace dyncal::testing {

using EarlierJson = nlohmann::json;

inline EarlierJson characteristic(
    const std::string &quantity, double value, double u, double k, const std::string &unit = "Hz")
{
    return {{"quantity", quantity}, {"value", value}, {"u", u}, {"k", k}, {"unit", unit}};
}

/// f0, sensitivity, one level, one shot with its shock, three rows of S(f); everything with u.
inline EarlierJson earlierResults()
{
    EarlierJson root{{"schema", "dyncal-results/1"}, {"created_utc", "2026-01-01T00:00:00Z"},
        {"software",
            {{"name", "dyncal"}, {"version", "0.1.0"}, {"build", "abc"},
                {"method", methodVersions()}}},
        {"recipe", EarlierJson::parse(recipeJson(Recipe()))}, {"error", nullptr},
        {"findings", EarlierJson::array()}};
    root["characteristics"] = {characteristic("f0_hz", 318e3, 10.0, 2.0),
        characteristic("damping_ratio", 0.02, 1e-4, 1.96, "1")};
    root["sensitivity"] = {{"value", 5e-6}, {"u", 5e-8}, {"k", 2.0}, {"unit", "V/Pa"},
        {"linearity_per_pa", 1e-9}, {"u_linearity_per_pa", 2e-9},
        {"per_level", {{{"level", "low"}, {"value", 5.1e-6}, {"u", 6e-8}, {"k", 2.1}}}}};
    root["shots"] = {{{"shot", 1}, {"sensitivity", 5.1e-6}, {"sensitivity_unit", "V/Pa"},
        {"u_sensitivity", 6e-8}, {"k_sensitivity", 2.2}}};
    root["shock"] = {{{"shot", 1}, {"velocity_m_s", 430.0}, {"u_velocity_m_s", 0.8},
        {"velocity_k", 2.0}, {"mach", 1.25}, {"u_mach", 0.002}, {"p2_pa", 168e3},
        {"u_p2_pa", 700.0}, {"p5_pa", 269e3}, {"u_p5_pa", 2e3}, {"step_pa", 168e3},
        {"u_step_pa", 2e3}, {"step_k", 2.3}}};
    root["response"] = {{"frequency_hz", {1e3, 1e4, 1e5}}, {"magnitude", {5e-6, 5.1e-6, 5.5e-6}},
        {"u_magnitude", {5e-8, 5e-8, 6e-8}}, {"k_magnitude", {2.0, 2.0, 2.5}},
        {"phase_rad", {0.0, -0.1, -3.1}}, {"u_phase_rad", {0.01, 0.01, 0.02}},
        {"k_phase", {2.0, 2.0, 2.0}}, {"u_contains_step", true}, {"unit", "V/Pa"}};
    return root;
}

/// A text table, which the readers recognise; another content for every `seed`.
inline std::string recordingBytes(int seed)
{
    std::string text = "time,dut\n";
    for (int i = 0; i < 40; ++i)
        text += std::to_string(i) + "e-6," + std::to_string(i < 20 ? 0 : seed + i % 3) + '\n';
    return text;
}

/// Names the recordings in the results.
inline EarlierJson withInputs(
    EarlierJson root, const std::vector<std::pair<std::string, std::string>> &nameAndBytes)
{
    root["inputs"] = EarlierJson::array();
    for (const auto &[name, bytes] : nameAndBytes)
        root["inputs"].push_back({{"file", name}, {"sha256", sha256Hex(std::string_view(bytes))}});
    return root;
}

/// Writes a file below the scratch folder, with its folders.
inline std::string put(const ScratchFolder &scratch, const std::string &name, std::string_view text)
{
    std::filesystem::create_directories(std::filesystem::path(scratch.file(name)).parent_path());
    return scratch.write(name, text.data(), text.size());
}

/// Writes results.json into a folder below; the folder's path.
inline std::string putResults(
    const ScratchFolder &scratch, const std::string &folder, const EarlierJson &root)
{
    put(scratch, folder + "/results.json", jsonText(root));
    return scratch.file(folder);
}

} // namespace dyncal::testing
