// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/console.h"
#include "app/cli/history_reading.h"
#include "app/cli/history_text.h"
#include "app/cli/registry_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/writing/atomic_file.h"

#include <filesystem>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

namespace fs = std::filesystem;

/// Frequencies that may be asked for.
constexpr double kLowest_Hz = 1e-6, kHighest_Hz = 1e12;

struct HistoryOptions
{
    std::vector<std::string> paths;
    std::string sensor;
    std::vector<double> at_Hz;
    std::string output; ///< empty: no file is written
    std::string registry;
    bool inForce = false, sensors = false, json = false;
};

/// Never over what it is made from.
Result<void> writeCsv(const HistoryOptions &options, const std::vector<std::string> &files,
    const SensorHistory &history)
{
    if (options.output.empty())
        return {};
    std::error_code unknown;
    for (const std::string &file : files)
        if (fs::equivalent(file, options.output, unknown))
            return fail(ErrorKind::Usage,
                {DYNCAL_TEXT("core",
                     "%1 holds results that the history is made from; write it under another name."),
                    {options.output}});
    return writeFileAtomically(options.output, historyCsv(history));
}

ExitCode exitCodeOf(const SensorHistory &history, const std::vector<UnreadResults> &unread)
{
    if (!unread.empty())
        return ExitCode::FileUnreadable;
    return history.isConspicuous() ? ExitCode::DoneWithCautions : ExitCode::Done;
}

std::string sensorsText(const std::vector<CalibrationCount> &sensors)
{
    std::string text;
    for (const CalibrationCount &one : sensors)
        text += presentableInBrief(one.serial) + "  " + std::to_string(one.calibrations) + '\n';
    return text;
}

int listSensors(const HistoryOptions &options, const ReadCalibrations &read)
{
    const std::vector<CalibrationCount> sensors = sensorsOf(read.all);
    std::cout << (options.json ? sensorsJson(sensors, read.unread) : sensorsText(sensors));
    return static_cast<int>(read.unread.empty() ? ExitCode::Done : ExitCode::FileUnreadable);
}

int answer(
    const HistoryOptions &options, const std::vector<std::string> &files, ReadCalibrations read)
{
    Result<SensorCalibrations> sensor = calibrationsOfSensor(std::move(read.all), options.sensor);
    if (!sensor)
        return report(sensor.error());
    const SensorHistory history = sensorHistory(std::move(*sensor), options.at_Hz);
    if (const Result<void> written = writeCsv(options, files, history); !written)
        return report(written.error());
    std::cout << (options.json ? historyJson(history, read.unread) : historyText(history));
    if (!options.json && !options.output.empty())
        std::cout << "\nWritten:\n  " << presentable(options.output) << '\n';
    return static_cast<int>(exitCodeOf(history, read.unread));
}

int history(const HistoryOptions &options)
{
    const Result<std::vector<std::string>> files = resultsFilesOf(options.paths);
    if (!files)
        return report(files.error());
    Result<ReadCalibrations> read = readCalibrations(*files);
    if (!read)
        return report(read.error());
    if (read->all.empty())
        return static_cast<int>(ExitCode::FileUnreadable); // each was told
    if (options.sensors)
        return listSensors(options, *read);
    if (options.inForce)
        if (const Result<void> asked = lookUpStates(options.registry, read->all); !asked)
            return report(asked.error());
    return answer(options, *files, std::move(*read));
}

} // namespace

void addHistory(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<HistoryOptions>();
    CLI::App *verb = program.add_subcommand(
        "history", "What earlier calibrations of a sensor say, over time, with E_n and limits");
    verb->add_option("paths", options->paths,
            "results.json, certificates (DCC), folders of dyncal run or of certificates, or above such")
        ->required()
        ->type_name("FILE|FOLDER");
    verb->add_option(
            "--sensor", options->sensor, "Its serial number; needed where there are several")
        ->type_name("SERIAL");
    verb->add_option("--at", options->at_Hz, "Frequencies of S(f) to follow, in Hz")
        ->delimiter(',')
        ->check(CLI::Range(kLowest_Hz, kHighest_Hz))
        ->type_name("F_HZ,...");
    verb->add_option("-o,--output", options->output, "Write a table of all values")
        ->type_name("HISTORY.csv");
    verb->add_flag("--in-force", options->inForce,
        "Leave out certificates that the registry says are withdrawn or replaced");
    declareRegistry(*verb, options->registry);
    verb->add_flag(
        "--sensors", options->sensors, "Only list the sensors that there are results of");
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer(
        "Exit codes: 0 done, 1 an E_n above 1 or a value beyond the warning limits, 3 a file cannot be\nread, or is neither a results.json nor a DCC.\n\n"
        "Example:\n  dyncal history certificates --sensor 4711 --at 1000,10000 -o history.csv\n"
        "  dyncal history 2024/results.json 2025/results.json 2026/results.json --json\n"
        "  dyncal history certificates bought-in/2023.xml --sensor 4711");
    verb->callback([options, &action] { action = [options] { return history(*options); }; });
}

} // namespace dyncal
