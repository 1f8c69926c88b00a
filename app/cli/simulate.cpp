// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/clock.h"
#include "app/base/interrupt.h"
#include "app/cli/capture_target.h"
#include "app/cli/console.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/number_text.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/synthesis/defect_kinds.h"
#include "core/synthesis/defects.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"

#include <charconv>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>
#include <system_error>

namespace dyncal {
namespace {

struct SimulateOptions
{
    std::string output;
    bool replace = false;
    std::string preset = "optic3";
    std::optional<double> f0_Hz;
    std::optional<double> zeta;
    std::string shots = "low,medium,high";
    std::vector<std::string> defects;
    SimulationSettings settings;
};

/// A typed f0 and zeta make a plain second-order sensor with the preset's sensitivity.
Result<SensorSpec> sensorOf(const SimulateOptions &options)
{
    Result<SensorSpec> sensor = sensorPreset(options.preset);
    if (!sensor || !options.f0_Hz)
        return sensor;
    SensorSpec custom;
    custom.name = "custom";
    custom.sensitivity_V_Pa = sensor->sensitivity_V_Pa;
    custom.modes = {{*options.f0_Hz, *options.zeta, 1.0}};
    return custom;
}

Result<std::vector<ShotLevel>> levelsOf(const std::string &list)
{
    std::vector<ShotLevel> levels;
    for (const std::string &word : CLI::detail::split(list, ',')) {
        const ShotLevel level = shotLevelFromName(word);
        if (level == ShotLevel::None)
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "--shots holds \"%1\"; it needs low, medium or high, separated by commas."),
                    {word}});
        levels.push_back(level);
    }
    return levels;
}

Result<SimulationSettings> settingsOf(const SimulateOptions &options)
{
    SimulationSettings settings = options.settings;
    const Result<SensorSpec> sensor = sensorOf(options);
    if (!sensor)
        return tl::unexpected<Error>(sensor.error());
    settings.sensor = *sensor;
    const Result<std::vector<ShotLevel>> levels = levelsOf(options.shots);
    if (!levels)
        return tl::unexpected<Error>(levels.error());
    settings.shots = *levels;
    for (const std::string &text : options.defects) {
        const Result<Defect> defect = parseDefect(text);
        if (!defect)
            return tl::unexpected<Error>(defect.error());
        settings.defects.push_back(*defect);
    }
    return settings;
}

/// What is wrong with a typed seed; empty if nothing. The parser's own conversion would turn a
/// number that is too large into the largest one.
std::string faultOfSeed(const std::string &text)
{
    std::uint64_t seed = 0;
    const char *end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, seed);
    if (error == std::errc() && rest == end)
        return {};
    return '"' + text + "\" is no seed, which is a whole number from 0 to "
        + std::to_string(std::numeric_limits<std::uint64_t>::max());
}

/// The table of kinds as `--defect help` prints it.
std::string defectHelp()
{
    std::ostringstream table;
    table << "KIND[=SIZE[:TIME]][@SHOT]; without a shot number all shots, or the middle one where"
             " one shot is meant.\n";
    for (const DefectDescription &description : defectDescriptions()) {
        std::string typed = description.name;
        if (description.size)
            typed += '=' + numberText(description.size->standard);
        if (description.time_s)
            typed += ':' + numberText(description.time_s->standard);
        table << '\n' << std::left << std::setw(20) << typed << description.meaning;
        if (description.size)
            table << " (" << numberText(description.size->lowest) << " to "
                  << numberText(description.size->highest) << ')';
    }
    return table.str();
}

/// Answers "help" with the table, before anything else is asked for: the parser prints what such an
/// exception holds and ends with exit code 0, as for --version.
std::string answerHelp(const std::string &text)
{
    if (text == "help")
        throw CLI::CallForVersion(defectHelp(), 0);
    return {};
}

/// One value of the truth, or a dash where the simulator states none.
std::string truthText(const ShotTruth &truth, const std::string &key, const char *unit)
{
    const auto found = truth.find(key);
    if (found == truth.end())
        return "-";
    return *unit != '\0' ? numberWithUnit(found->second, unit, 5) : numberText(found->second, 5);
}

void printTruth(const SimulatedCapture &capture)
{
    std::cout << "Shot  Level   f0           zeta      Step         Velocity     Sensitivity\n";
    for (std::size_t i = 0; i < capture.truth.size() && i < capture.set.shots.size(); ++i) {
        const ShotTruth &truth = capture.truth[i];
        std::cout << std::left << std::setw(6) << i + 1 << std::setw(8)
                  << shotLevelName(capture.set.shots[i].level) << std::setw(13)
                  << truthText(truth, "f0_Hz", "Hz") << std::setw(10)
                  << truthText(truth, "zeta", "") << std::setw(13)
                  << truthText(truth, "step_Pa", "Pa") << std::setw(13)
                  << truthText(truth, "velocity_m_s", "m/s")
                  << truthText(truth, "sensitivity", "V/Pa") << '\n';
    }
}

int simulate(const SimulateOptions &options)
{
    const Result<std::string> created = currentUtc();
    if (!created)
        return report(created.error());
    const Result<SimulationSettings> settings = settingsOf(options);
    if (!settings)
        return report(settings.error());
    const CaptureTarget target{options.output, options.replace};
    if (const Result<void> free = checkCaptureTarget(target, {}); !free)
        return report(free.error());
    ProgressLine progress("Simulating");
    const JobControl control{interruptToken(), progress.sink()};
    const Result<SimulatedCapture> capture = simulateShots(*settings, control);
    if (!capture)
        return report(capture.error());
    const std::string title = "Simulated sensor " + settings->sensor.name;
    if (const Result<void> written
        = writeHdf5Capture(capture->set, target, *created, title, capture->truth, control);
        !written)
        return report(written.error());
    std::cout << "Wrote " << presentable(options.output) << ": " << title << ", "
              << capture->set.shots.size() << " shots, seed " << settings->seed << '\n';
    printTruth(*capture);
    return static_cast<int>(ExitCode::Done);
}

} // namespace

void addSimulate(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<SimulateOptions>();
    CLI::App *verb = program.add_subcommand("simulate", "Write a capture of a simulated sensor");
    verb->add_option("-o,--output", options->output, "Capture to write (.h5)")
        ->required()
        ->type_name("CAPTURE");
    verb->add_flag("--replace", options->replace, "Replace a file of this name");
    verb->add_option("--preset", options->preset, "Sensor: piezo, optic1, optic2, optic3, optic4")
        ->capture_default_str();
    CLI::Option *f0 = verb->add_option(
        "--f0-hz", options->f0_Hz, "Natural frequency of a second-order sensor instead");
    CLI::Option *zeta = verb->add_option("--zeta", options->zeta, "Its damping ratio")->needs(f0);
    f0->needs(zeta);
    verb->add_option("--shots", options->shots, "Levels, separated by commas")
        ->capture_default_str();
    SimulationSettings &settings = options->settings;
    verb->add_option("--sample-rate-hz", settings.sampleRate_Hz, "Sample rate in hertz")
        ->capture_default_str();
    verb->add_option("--duration-s", settings.duration_s, "Length of each record in seconds")
        ->capture_default_str();
    verb->add_option("--noise", settings.noise,
            "Standard deviation of the noise as a fraction of each shot's step")
        ->capture_default_str();
    verb->add_option("--bits", settings.bits, "Resolution of the converter")->capture_default_str();
    verb->add_option("--seed", settings.seed, "Seed of the noise")
        ->check(faultOfSeed)
        ->capture_default_str();
    verb->add_option("--defect", options->defects,
            "A fault put in on purpose, e.g. clip, clip@2 (shot 2) or heat=0.05; may be repeated; help lists all kinds")
        ->allow_extra_args(false)
        ->check(answerHelp, "")
        ->type_name("KIND[=SIZE[:TIME]][@SHOT]");
    verb->footer("Example:\n  dyncal simulate -o example.h5 --preset optic3 --seed 7\n"
                 "  dyncal simulate -o clipped.h5 --defect clip@2\n"
                 "  dyncal simulate -o heated.h5 --preset piezo --defect heat=0.05:1e-4");
    verb->callback([options, &action] { action = [options] { return simulate(*options); }; });
}

} // namespace dyncal
