// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/correction/correction_run.h"

#include "core/base/content_hash.h"
#include "core/reference/reference_source.h"

#include <algorithm>
#include <filesystem>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// The results.json itself, where its folder was given.
std::string resultsFile(const std::string &given)
{
    std::error_code error;
    return fs::is_directory(given, error) ? (fs::path(given) / "results.json").string() : given;
}

/// The sample rate of the first DUT's channel; every included shot needs one.
Result<double> rateOf(const CaptureSet &set)
{
    std::optional<double> rate_Hz;
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        if (!set.shots[i].included)
            continue;
        const Channel *channel = set.shots[i].channelWithRole(ChannelRole::Dut);
        if (!channel)
            return fail(ErrorKind::DataBlocked,
                {DYNCAL_TEXT("core",
                     "Shot %1 has no channel of the DUT; name it (import.channels of a recipe)."),
                    {std::to_string(i + 1)}},
                "CAP-002", static_cast<Index>(i) + 1);
        rate_Hz = rate_Hz.value_or(channel->sampleRate_Hz);
    }
    return rate_Hz.value_or(0.0);
}

bool isOfDut(const Finding &finding, const CaptureSet &set)
{
    return std::ranges::any_of(set.shots, [&](const Shot &shot) {
        const Channel *channel = shot.channelWithRole(ChannelRole::Dut);
        return channel && shot.included && channel->name == finding.channel;
    });
}

Result<ShotPressure> correctShot(const Channel &channel, Index number,
    const CorrectionFilter &filter, const RecordOptions &options, const JobControl &control)
{
    return recordPressure(channel, number, filter, options, control)
        .map([&](const RecordPressure &record) {
            return ShotPressure{number, channel.name, record};
        });
}

Result<CorrectionOutcome> correctShots(CorrectionOutcome outcome, const CaptureSet &set,
    const RecordOptions &options, const JobControl &control)
{
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        if (!set.shots[i].included)
            continue;
        const JobControl part = control.part(i, set.shots.size());
        Result<ShotPressure> shot = correctShot(*set.shots[i].channelWithRole(ChannelRole::Dut),
            static_cast<Index>(i) + 1, outcome.filter, options, part);
        if (!shot)
            return tl::unexpected<Error>(shot.error());
        outcome.shots.push_back(std::move(*shot));
    }
    return outcome;
}

} // namespace

Result<CalibrationSource> calibrationOf(std::string text, const std::string &name)
{
    return calibratedResponse(text, name).map([&](CalibratedResponse calibration) {
        std::string sha256 = sha256Hex(text);
        return CalibrationSource{
            std::move(calibration), {}, name, std::move(sha256), std::move(text)};
    });
}

Result<CalibrationSource> calibrationAt(const std::string &path)
{
    const std::string file = resultsFile(path);
    const auto source = sourceAt("", file);
    if (!source)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 cannot be read as results of a calibration; give the folder or the results.json that dyncal run wrote."),
                {file}});
    return calibratedResponse(source->content, file).map([&](CalibratedResponse calibration) {
        return CalibrationSource{std::move(calibration), file, fs::path(file).filename().string(),
            source->sha256, source->content};
    });
}

bool areCorrectable(const Findings &findings, const CaptureSet &set)
{
    return std::ranges::none_of(findings, [&](const Finding &finding) {
        return finding.severity == Severity::Block
            || (finding.severity == Severity::Caution && finding.id == "CAP-007"
                && isOfDut(finding, set));
    });
}

Result<CorrectionOutcome> correctRecordings(const CalibrationSource &calibration,
    const CaptureSet &set, const CorrectionSettings &filter, const RecordOptions &options,
    const JobControl &control)
{
    Result<CorrectionFilter> designed = rateOf(set).and_then([&](double rate_Hz) {
        return designCorrection(calibration.says.response, rate_Hz, filter);
    });
    if (!designed)
        return tl::unexpected<Error>(designed.error());
    CorrectionOutcome outcome;
    outcome.calibration = calibration;
    outcome.recordings = set.inputs;
    outcome.filter = std::move(*designed);
    outcome.isBoundStated = options.beyond_Pa.has_value();
    return correctShots(std::move(outcome), set, options, control);
}

} // namespace dyncal
