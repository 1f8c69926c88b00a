// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/correction_files.h"

#include "core/base/json_text.h"
#include "core/base/version.h"
#include "core/capture/capture_seal.h"
#include "core/correction/filter_files.h"
#include "core/results/csv_table.h"
#include "core/results/json_record.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

constexpr const char *kSummaryOfCorrection = "correction.json";
constexpr const char *kCalibrationOfCorrection = "calibration.json";
constexpr std::string_view kPressureFile = "pressure_shot_";
constexpr std::size_t kDigitsOfShot = 3;

/// "pressure_shot_001.csv"
std::string pressureFile(Index shot)
{
    std::string number = std::to_string(shot);
    number.insert(0, kDigitsOfShot - std::min(kDigitsOfShot, number.size()), '0');
    return std::string(kPressureFile) + number + ".csv";
}

bool isPressureFile(const std::string &name)
{
    constexpr std::size_t kMostDigitsOfShot = 9;
    constexpr std::string_view kEnd = ".csv";
    if (!name.starts_with(kPressureFile) || !name.ends_with(kEnd)
        || name.size() > kPressureFile.size() + kMostDigitsOfShot + kEnd.size())
        return false;
    const std::string number
        = name.substr(kPressureFile.size(), name.size() - kPressureFile.size() - kEnd.size());
    return std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; })
        && name == pressureFile(std::atoll(number.c_str()));
}

bool isCorrectionName(const std::string &name)
{
    return name == kSummaryOfCorrection || name == kCalibrationOfCorrection || isPressureFile(name)
        || std::ranges::find(filterFileNames(), name) != filterFileNames().end();
}

Eigen::VectorXd timesOf(const CorrectedPressure &pressure)
{
    const Index last = pressure.pressure_Pa.size() - 1;
    return pressure.time_s
        + Eigen::VectorXd::LinSpaced(last + 1, 0.0, static_cast<double>(last)).array()
        / pressure.rate_Hz;
}

std::string pressureCsv(const CorrectedPressure &pressure)
{
    CsvTable table;
    table.add("time_s", timesOf(pressure));
    table.add("pressure_pa", pressure.pressure_Pa);
    table.add("u_pressure_pa", pressure.u_Pa);
    table.add("k_pressure", pressure.k);
    table.add("u_response_pa", pressure.u_response_Pa);
    table.add("bound_beyond_band_pa", pressure.bound_Pa);
    return table.text();
}

JsonRecord::Json shotOfCorrection(const ShotPressure &shot)
{
    const char *none = "Not finite.";
    const CorrectedPressure &pressure = shot.record.pressure;
    Index largest = 0;
    pressure.pressure_Pa.cwiseAbs().maxCoeff(&largest);
    JsonRecord record;
    record.set("shot", shot.shot);
    record.set("channel", shot.channel);
    record.set("file", pressureFile(shot.shot));
    record.set("samples", pressure.pressure_Pa.size());
    record.number("time_s", pressure.time_s, none);
    record.set("quiet_s", {shot.record.quiet_s.begin, shot.record.quiet_s.end});
    record.number("level", shot.record.level, none);
    record.number("noise_sd", shot.record.noiseSd, none);
    record.number("u_noise_pa", pressure.u_noise_Pa, none);
    record.number("largest_pa", pressure.pressure_Pa[largest], none);
    record.number("u_largest_pa", pressure.u_Pa[largest], none);
    record.number("k_largest", pressure.k[largest], none);
    record.number("at_s", timesOf(pressure)[largest], none);
    record.number("largest_bound_beyond_band_pa", pressure.bound_Pa.maxCoeff(), none);
    return record.take();
}

JsonRecord::Json recordingsOfCorrection(const std::vector<InputFile> &inputs)
{
    JsonRecord::Json list = JsonRecord::Json::array();
    for (const InputFile &input : inputs)
        list.push_back({{"file", input.file}, {"sha256", input.sha256}, {"format", input.format}});
    return list;
}

/// What whoever reads the numbers must know.
JsonRecord::Json assumptionsOf(const CorrectionOutcome &outcome)
{
    return {"The pressure is relative to that before it, as the level there is taken off.",
        outcome.isBoundStated
            ? "bound_beyond_band_pa was stated by the customer."
            : "Beyond the band the pressure has, within 1/band_hz of each sample, no more than in the upper half of the band; a front that is steeper than the band needs a stated bound.",
        "Below f_low_hz the response is that of the level at the onset.",
        "A pure delay of the sensor is not known: times are those of its own onset.",
        "The recording holds nothing above half its sample rate, and it was made with the chain that the calibration is of."};
}

std::string summaryJson(const CorrectionOutcome &outcome)
{
    JsonRecord root;
    root.set("schema", "dyncal-correction/1");
    root.set("software", std::string("dyncal ") + versionText());
    root.set("calibration",
        {{"file", outcome.calibration.file}, {"sha256", outcome.calibration.sha256},
            {"created_utc", outcome.calibration.says.createdUtc},
            {"cautions", outcome.calibration.says.cautions}});
    root.set("inputs", recordingsOfCorrection(outcome.recordings));
    root.number("f_low_hz", outcome.calibration.says.fLow_Hz, "Not stated.");
    root.number("band_hz", outcome.filter.lowPass.band_Hz, "Not finite.");
    root.number("edge_hz", outcome.filter.lowPass.edge_Hz, "Not finite.");
    root.set("coverage", kCoverageOfPressure);
    root.set("assumptions", assumptionsOf(outcome));
    JsonRecord::Json shots = JsonRecord::Json::array();
    for (const ShotPressure &shot : outcome.shots)
        shots.push_back(shotOfCorrection(shot));
    root.set("shots", std::move(shots));
    return jsonText(root.take());
}

std::vector<FilterFile> filesOfCorrection(const CorrectionOutcome &outcome)
{
    std::vector<FilterFile> files{{kSummaryOfCorrection, summaryJson(outcome)},
        {kCalibrationOfCorrection, outcome.calibration.text}};
    for (const ShotPressure &shot : outcome.shots)
        files.push_back({pressureFile(shot.shot), pressureCsv(shot.record.pressure)});
    for (FilterFile &file : filterFiles(outcome.filter))
        files.push_back(std::move(file));
    return files;
}

} // namespace

FolderRequest correctionFolder(
    const std::string &folder, const CaptureSet &set, std::vector<std::string> others)
{
    std::vector<std::string> names = filterFileNames();
    names.insert(names.end(), {kSummaryOfCorrection, kCalibrationOfCorrection});
    std::vector<std::string> recordings;
    for (const InputFile &input : set.inputs)
        recordings.push_back(input.path);
    for (std::size_t i = 0; i < set.shots.size(); ++i)
        names.push_back(pressureFile(static_cast<Index>(i) + 1));
    return {folder, "correct", isCorrectionName, std::move(names), std::move(recordings),
        std::move(others), isCorrectionName, [set] { return checkStillWhole(set); }};
}

Result<std::vector<std::string>> writeCorrection(
    const CorrectionOutcome &outcome, FolderWrite &folder, const JobControl &control)
{
    const std::vector<FilterFile> written = filesOfCorrection(outcome);
    std::vector<FolderFile> files;
    std::vector<std::string> paths;
    for (const FilterFile &file : written) {
        files.push_back({file.name, file.bytes});
        paths.push_back((std::filesystem::path(folder.folder()) / file.name).string());
    }
    return folder.commit(files, control).map([&] { return paths; });
}

Findings findingsOf(const CorrectionOutcome &outcome)
{
    Findings findings;
    for (const ShotPressure &shot : outcome.shots)
        findings.insert(findings.end(), shot.record.findings.begin(), shot.record.findings.end());
    return findings;
}

} // namespace dyncal
