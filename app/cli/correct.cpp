// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/capture/capture_check.h"
#include "core/correction/correction_files.h"
#include "core/reference/reference_source.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

struct CorrectOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    std::string results;
    std::string output;
    CorrectionSettings filter;
    std::string lowPass = lowPassName(LowPassKind::Gaussian);
    std::vector<double> window_s;
    std::vector<double> quiet_s;
    std::optional<double> beyond_Pa;
};

/// The results.json itself, where its folder was given.
std::string resultsFile(const std::string &given)
{
    std::error_code error;
    return fs::is_directory(given, error) ? (fs::path(given) / "results.json").string() : given;
}

/// Two times, the earlier first.
Result<std::optional<Interval>> intervalOf(const char *option, const std::vector<double> &times_s)
{
    if (times_s.empty())
        return std::optional<Interval>();
    if (times_s.size() == 2 && times_s[0] < times_s[1])
        return std::optional(Interval{times_s[0], times_s[1]});
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core", "%1 needs two times in seconds, the earlier first: %1 BEGIN,END."),
            {option}});
}

Result<RecordOptions> recordOptions(const CorrectOptions &options)
{
    const auto window = intervalOf("--window", options.window_s);
    const auto quiet = intervalOf("--quiet", options.quiet_s);
    if (!window || !quiet)
        return tl::unexpected<Error>(window ? quiet.error() : window.error());
    if (options.beyond_Pa && !(*options.beyond_Pa >= 0.0 && std::isfinite(*options.beyond_Pa)))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "--beyond is %1; it needs a pressure of at least 0, in Pa."),
                {numberText(*options.beyond_Pa)}});
    return RecordOptions{*window, *quiet, options.beyond_Pa};
}

/// Fills in what the results say; fails where they cannot be read.
Result<CorrectionOutcome> withCalibration(const std::string &path)
{
    const auto source = sourceAt("", path);
    if (!source)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 cannot be read as results of a calibration; give the folder or the results.json that dyncal run wrote."),
                {path}});
    return calibratedResponse(source->content, path)
        .map([&](const CalibratedResponse &calibration) {
            CorrectionOutcome outcome;
            outcome.calibration = calibration;
            outcome.calibrationFile = fs::path(path).filename().string();
            outcome.calibrationSha256 = source->sha256;
            return outcome;
        });
}

/// The first sample rate of a DUT's channel; 0 where there is none.
double rateOf(const CaptureSet &set)
{
    for (const Shot &shot : set.shots)
        if (const Channel *channel = shot.channelWithRole(ChannelRole::Dut);
            channel && shot.included)
            return channel->sampleRate_Hz;
    return 0.0;
}

Result<ShotPressure> correctShot(
    const Shot &shot, Index number, const CorrectionFilter &filter, const RecordOptions &options)
{
    const Channel *channel = shot.channelWithRole(ChannelRole::Dut);
    if (!channel)
        return fail(ErrorKind::DataBlocked,
            {DYNCAL_TEXT("core",
                 "Shot %1 has no channel of the DUT; name it (import.channels of a recipe)."),
                {std::to_string(number)}},
            "CAP-002", number);
    return recordPressure(*channel, number, filter, options).map([&](const RecordPressure &record) {
        return ShotPressure{number, channel->name, record};
    });
}

/// Every included shot, with progress on stderr.
Result<void> correctShots(
    CorrectionOutcome &outcome, const CaptureSet &set, const RecordOptions &options)
{
    ProgressLine progress("Correcting");
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        if (interruptToken().stop_requested())
            return fail(ErrorKind::Cancelled, {});
        if (!set.shots[i].included)
            continue;
        Result<ShotPressure> shot
            = correctShot(set.shots[i], static_cast<Index>(i) + 1, outcome.filter, options);
        if (!shot)
            return tl::unexpected<Error>(shot.error());
        outcome.shots.push_back(std::move(*shot));
    }
    return {};
}

void printCorrection(const CorrectionOutcome &outcome, const std::vector<std::string> &paths)
{
    const CorrectionFilter &filter = outcome.filter;
    std::cout << "Band                    0 to " << numberWithUnit(filter.lowPass.band_Hz, "Hz")
              << ", nothing beyond " << numberWithUnit(filter.lowPass.edge_Hz, "Hz") << '\n'
              << "Filter                  " << filter.taps.size() << " taps, delay "
              << numberWithUnit(filter.delay_s(), "s") << '\n';
    for (const ShotPressure &shot : outcome.shots) {
        const CorrectedPressure &pressure = shot.record.pressure;
        Index largest = 0;
        pressure.pressure_Pa.cwiseAbs().maxCoeff(&largest);
        std::cout << "Shot " << shot.shot << "                  largest "
                  << numberWithUnit(pressure.pressure_Pa[largest], "Pa") << " (U = "
                  << numberWithUnit(pressure.k[largest] * pressure.u_Pa[largest], "Pa", 2)
                  << ", k = " << numberText(pressure.k[largest], 3) << ")\n";
    }
    std::cout << "Written:\n";
    for (const std::string &path : paths)
        std::cout << "  " << presentable(path) << '\n';
}

/// Cautions of the calibration, then those of the recordings; the exit code.
int concludeCorrection(const CorrectionOutcome &outcome, const Findings &findings)
{
    std::string ids;
    for (const std::string &id : outcome.calibration.cautions)
        ids += (ids.empty() ? "" : ", ") + presentableInBrief(id);
    if (!ids.empty())
        std::cerr << "The calibration has cautions, which hold for the correction too: " << ids
                  << ".\n";
    reportFindings(findings);
    const ExitCode code = exitCodeOf(findings);
    return static_cast<int>(
        code == ExitCode::Done && !ids.empty() ? ExitCode::DoneWithCautions : code);
}

bool isOfDut(const Finding &finding, const CaptureSet &set)
{
    return std::ranges::any_of(set.shots, [&](const Shot &shot) {
        const Channel *channel = shot.channelWithRole(ChannelRole::Dut);
        return channel && shot.included && channel->name == finding.channel;
    });
}

/// A record that left the converter's range, or that cannot be trusted otherwise, has no pressure.
bool areCorrectable(const Findings &findings, const CaptureSet &set)
{
    return std::ranges::none_of(findings, [&](const Finding &finding) {
        return finding.severity == Severity::Block
            || (finding.severity == Severity::Caution && finding.id == "CAP-007"
                && isOfDut(finding, set));
    });
}

int refuseRecordings(const Findings &findings)
{
    reportFindings(findings);
    std::cerr << "Nothing was corrected: the recordings do not hold the pressure (above).\n";
    return static_cast<int>(ExitCode::Blocked);
}

int correct(const CorrectOptions &options)
{
    const std::string results = resultsFile(options.results);
    const Result<RecordOptions> ofRecords = recordOptions(options);
    if (!ofRecords)
        return report(ofRecords.error());
    const Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return report(recipe.error());
    Result<CorrectionOutcome> outcome = withCalibration(results);
    if (!outcome)
        return report(outcome.error());
    const Result<CaptureSet> set = readForCalibration(options.files, *recipe);
    if (!set)
        return report(set.error());
    std::vector<std::string> others = options.recipe.files();
    others.push_back(results);
    Result<FolderWrite> folder
        = FolderWrite::begin(correctionFolder(options.output, *set, std::move(others)));
    if (!folder)
        return report(folder.error());
    const Findings findings = checkCaptures(*set, recipe->checks);
    if (!areCorrectable(findings, *set))
        return refuseRecordings(findings);
    Result<CorrectionFilter> filter
        = designCorrection(outcome->calibration.response, rateOf(*set), options.filter);
    if (!filter)
        return report(filter.error());
    outcome->filter = std::move(*filter);
    outcome->recordings = set->inputs;
    outcome->isBoundStated = options.beyond_Pa.has_value();
    if (const Result<void> corrected = correctShots(*outcome, *set, *ofRecords); !corrected)
        return report(corrected.error());
    const auto paths = writeCorrection(*outcome, *folder, {interruptToken(), {}});
    if (!paths)
        return report(paths.error());
    printCorrection(*outcome, *paths);
    return concludeCorrection(*outcome, findings);
}

void declareFilter(CLI::App &verb, CorrectOptions &options)
{
    verb.add_option("--band", options.filter.band_Hz, "Up to which the pressure is wanted")
        ->type_name("HZ");
    verb.add_option("--edge", options.filter.edge_Hz, "Beyond which nothing is left (1.5 band)")
        ->type_name("HZ");
    verb.add_option("--delay", options.filter.delay_s, "Of the filter (the shortest possible)")
        ->type_name("S");
    verb.add_option("--low-pass", options.lowPass, "Its form")
        ->check(
            CLI::IsMember({lowPassName(LowPassKind::Gaussian), lowPassName(LowPassKind::TwoPole)}))
        ->type_name("gaussian|two-pole");
}

void declareRecord(CLI::App &verb, CorrectOptions &options)
{
    verb.add_option("--window", options.window_s, "What to correct (the whole recording)")
        ->delimiter(',')
        ->type_name("BEGIN,END");
    verb.add_option("--quiet", options.quiet_s, "Without pressure (before the start)")
        ->delimiter(',')
        ->type_name("BEGIN,END");
    verb.add_option("--beyond", options.beyond_Pa,
            "What the pressure has beyond the band at most (from the recording)")
        ->type_name("PA");
}

} // namespace

void addCorrect(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<CorrectOptions>();
    CLI::App *verb = program.add_subcommand(
        "correct", "The pressure behind recordings, by a calibration of their sensor");
    verb->add_option("files", options->files, "Recordings of the sensor, or folders of them")
        ->required()
        ->type_name("FILE");
    verb->add_option("--with", options->results, "Folder or results.json of dyncal run")
        ->required()
        ->type_name("RESULTS");
    options->recipe.declare(*verb);
    declareFilter(*verb, *options);
    declareRecord(*verb, *options);
    verb->add_option("-o,--output", options->output, "Folder to write to")
        ->required()
        ->type_name("DIR");
    verb->footer("Example:\n  dyncal correct blast.csv --with out --band 100000 -o pressure\n"
                 "  dyncal correct blast.h5 --with out/results.json --quiet 0,0.001 -o pressure");
    verb->callback([options, &action] {
        action = [options] {
            options->filter.lowPass = options->lowPass == lowPassName(LowPassKind::TwoPole)
                ? LowPassKind::TwoPole
                : LowPassKind::Gaussian;
            return correct(*options);
        };
    });
}

} // namespace dyncal
