// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/content_hash.h"
#include "core/base/json_text.h"
#include "registry/issued/bound_files.h"
#include "registry/issued/issued_files.h"

#include <map>
#include <string>

namespace dyncal::testing {

/// Files that fit each other as those of a real certificate do, without a calibration behind them.
inline std::map<std::string, std::string> madeCertificate(const CertificateRecord &record)
{
    using Json = nlohmann::json;
    const std::string number = std::to_string(record.number);
    const std::string sha256 = sha256Hex(std::string_view(record.job));
    const Json recipe{{"certificate", {{"fields", {{"certificate_number", number}}}}}};
    const Json results{{"schema", "dyncal-results/1"}, {"recipe", recipe},
        {"created_utc", record.reservedUtc},
        {"inputs", Json::array({{{"file", "shot.h5"}, {"sha256", sha256}}})}};
    const Json project{{"format", "dyncal-project"}, {"recipe", recipe},
        {"captures", Json::array({{{"path", "shot.h5"}, {"sha256", sha256}}})}};
    std::map<std::string, std::string> files{{"recipe.json", jsonText(recipe)},
        {"results.json", jsonText(results)}, {"project.dyncal", jsonText(project)}};
    const auto mark = [](const char *name, const std::string &value) {
        return std::string("<dyncal:").append(name) + '>' + value + "</dyncal:" + name + ">\n";
    };
    const std::map<std::string, std::string> hashes = hashesOf(files);
    files["certificate.pdf"] = "%PDF " + std::string(20000, 'x') + mark("number", number)
        + mark("head", record.head) + mark("results", hashes.at("results.json"))
        + mark("files", boundFilesHash(hashes));
    return files;
}

} // namespace dyncal::testing
