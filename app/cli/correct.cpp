// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/calibration.h"
#include "app/cli/console.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/correction/correction_run.h"
#include "core/pipeline/early_stages.h"

#include <iostream>
#include <memory>

namespace dyncal {
namespace {

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
    for (const std::string &id : outcome.calibration.says.cautions)
        ids += (ids.empty() ? "" : ", ") + presentableInBrief(id);
    if (!ids.empty())
        std::cerr << "The calibration has cautions, which hold for the correction too: " << ids
                  << ".\n";
    reportFindings(findings);
    const ExitCode code = exitCodeOf(findings);
    return static_cast<int>(
        code == ExitCode::Done && !ids.empty() ? ExitCode::DoneWithCautions : code);
}

int refuseRecordings(const Findings &findings)
{
    reportFindings(findings);
    std::cerr << "Nothing was corrected: the recordings do not hold the pressure (above).\n";
    return static_cast<int>(ExitCode::Blocked);
}

/// With progress on stderr.
Result<CorrectionOutcome> corrected(const CalibrationSource &calibration, const CaptureSet &set,
    const CorrectionSettings &filter, const RecordOptions &options)
{
    ProgressLine progress("Correcting");
    return correctRecordings(
        calibration, set, filter, options, {interruptToken(), progress.sink()});
}

int correct(const CorrectOptions &options)
{
    const Result<RecordOptions> ofRecords = recordOptions(options);
    if (!ofRecords)
        return report(ofRecords.error());
    const Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return report(recipe.error());
    const Result<CalibrationSource> calibration = calibrationAt(options.results);
    if (!calibration)
        return report(calibration.error());
    const Result<CaptureSet> set = readForCalibration(options.files, *recipe);
    if (!set)
        return report(set.error());
    std::vector<std::string> others = options.recipe.files();
    others.push_back(calibration->path);
    Result<FolderWrite> folder
        = FolderWrite::begin(correctionFolder(options.output, *set, std::move(others)));
    if (!folder)
        return report(folder.error());
    const Result<PreparedCaptures> prepared = prepareCaptures(*set, *recipe);
    if (!prepared)
        return report(prepared.error());
    if (!areCorrectable(prepared->findings, prepared->set))
        return refuseRecordings(prepared->findings);
    const Result<CorrectionOutcome> outcome
        = corrected(*calibration, prepared->set, options.filter, *ofRecords);
    if (!outcome)
        return report(outcome.error());
    const auto paths = writeCorrection(*outcome, *folder, {interruptToken(), {}});
    if (!paths)
        return report(paths.error());
    printCorrection(*outcome, *paths);
    Findings findings = prepared->findings;
    for (const Finding &finding : findingsOf(*outcome))
        findings.push_back(finding);
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
