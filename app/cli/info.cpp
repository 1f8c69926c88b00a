// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/interrupt.h"
#include "app/cli/console.h"
#include "app/cli/findings_json.h"
#include "app/cli/recipe_options.h"
#include "app/cli/verbs.h"

#include "core/base/foreign_text.h"
#include "core/base/json_text.h"
#include "core/base/number_text.h"
#include "core/capture/opening/capture_open.h"
#include "core/capture/opening/content_statement.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <memory>

namespace dyncal {
namespace {

using Json = nlohmann::json;

struct InfoOptions
{
    std::vector<std::string> files;
    RecipeOptions recipe;
    bool json = false;
};

/// "int16": how one sample is kept.
std::string typeName(SampleType type)
{
    static constexpr std::array kNames{
        "int16", "int32", "float32", "float64", "int8", "uint8", "uint16"}; // as SampleType
    return kNames[static_cast<std::size_t>(type)];
}

Json orNull(bool known, const Json &value)
{
    return known ? value : Json(nullptr);
}

Json channelJson(const Channel &channel)
{
    const bool timed = channel.sampleRate_Hz > 0.0;
    return {{"name", channel.name}, {"role", channelRoleName(channel.role)},
        {"sample_rate_hz", orNull(timed, channel.sampleRate_Hz)},
        {"samples", channel.samples.size()}, {"type", typeName(channel.samples.type())},
        {"t0_s", channel.t0_s}, {"unit", channel.unit}, {"quantity", channel.quantity},
        {"duration_s", timed ? Json(channel.duration_s()) : Json(nullptr)},
        {"adc_bits", orNull(channel.adcBits > 0, channel.adcBits)}, {"sensor", channel.sensorId},
        {"sha256", channel.sha256}};
}

Json shotJson(const CaptureSet &set, std::size_t i)
{
    const Shot &shot = set.shots[i];
    Json channels = Json::array();
    for (const Channel &channel : shot.channels)
        channels.push_back(channelJson(channel));
    return {{"shot", i + 1}, {"label", shot.label}, {"level", shotLevelName(shot.level)},
        {"file", set.inputs.at(static_cast<std::size_t>(shot.input)).file},
        {"included", shot.included}, {"channels", std::move(channels)}};
}

bool isCapture(const InputFile &input)
{
    return input.format == "dyncal-capture";
}

/// The content hash that each input states: empty for other formats, and for captures without one,
/// in which a changed label is not noticed.
Result<std::vector<std::string>> contentHashes(const CaptureSet &set)
{
    std::vector<std::string> captures;
    for (const InputFile &input : set.inputs) {
        if (isCapture(input))
            captures.push_back(input.path);
    }
    const Result<std::vector<std::string>> stated = statedContentHashes(captures);
    if (!stated)
        return stated;
    std::vector<std::string> hashes;
    for (std::size_t next = 0; const InputFile &input : set.inputs)
        hashes.push_back(isCapture(input) ? (*stated)[next++] : std::string());
    return hashes;
}

Json infoJson(const CaptureSet &set, const std::vector<std::string> &hashes)
{
    Json files = Json::array();
    for (std::size_t i = 0; i < set.inputs.size(); ++i) {
        const InputFile &input = set.inputs[i];
        files.push_back({{"file", input.file}, {"format", input.format}, {"sha256", input.sha256},
            {"content_sha256", orNull(!hashes[i].empty(), hashes[i])}});
    }
    Json shots = Json::array();
    for (std::size_t i = 0; i < set.shots.size(); ++i)
        shots.push_back(shotJson(set, i));
    return {{"schema", "dyncal-info/1"}, {"files", std::move(files)}, {"shots", std::move(shots)},
        {"tube", set.tube}, {"sensors", set.sensors}, {"instruments", set.instruments},
        {"findings", findingsJson(set.findings)}};
}

void printAttributes(const std::string &title, const Attributes &attributes)
{
    if (attributes.empty())
        return;
    std::cout << presentableInBrief(title) << ":\n";
    for (const auto &[key, value] : attributes)
        std::cout << "  " << presentableInBrief(key) << " = " << presentableInBrief(value) << '\n';
}

/// "int16", with the converter's bits where they are known: "int16/14".
std::string precisionText(const Channel &channel)
{
    return typeName(channel.samples.type())
        + (channel.adcBits > 0 ? "/" + std::to_string(channel.adcBits) : std::string());
}

void printChannel(const Channel &channel, std::size_t nameWidth)
{
    const bool timed = channel.sampleRate_Hz > 0.0;
    std::cout << "    " << std::left << std::setw(static_cast<int>(nameWidth) + 2)
              << presentableInBrief(channel.name) << std::setw(13) << channelRoleName(channel.role)
              << std::right << std::setw(10)
              << (timed ? numberWithUnit(channel.sampleRate_Hz, "Hz") : "rate ?") << std::setw(12)
              << channel.samples.size() << " samples  " << std::setw(9)
              << (timed ? numberWithUnit(channel.duration_s(), "s") : "?") << "  from "
              << std::setw(9) << numberWithUnit(channel.t0_s, "s") << "  " << std::setw(8)
              << precisionText(channel) << "  "
              << (channel.unit.empty() ? "unit ?" : presentableInBrief(channel.unit)) << '\n';
}

void printShots(const CaptureSet &set)
{
    std::size_t width = 0;
    for (const Shot &shot : set.shots) {
        for (const Channel &channel : shot.channels)
            width = std::max(width, presentableInBrief(channel.name).size());
    }
    for (std::size_t i = 0; i < set.shots.size(); ++i) {
        const Shot &shot = set.shots[i];
        std::cout << "Shot " << i + 1;
        if (!shot.label.empty())
            std::cout << " \"" << presentableInBrief(shot.label) << '"';
        if (shot.level != ShotLevel::None)
            std::cout << ", level " << shotLevelName(shot.level);
        std::cout << ", "
                  << presentableInBrief(set.inputs.at(static_cast<std::size_t>(shot.input)).file)
                  << (shot.included ? "\n" : ", excluded\n");
        for (const Channel &channel : shot.channels)
            printChannel(channel, width);
    }
}

void printInfo(const CaptureSet &set, const std::vector<std::string> &hashes)
{
    for (std::size_t i = 0; i < set.inputs.size(); ++i) {
        const InputFile &input = set.inputs[i];
        std::cout << presentableInBrief(input.file) << ": " << input.format << ", sha256 "
                  << input.sha256
                  << (isCapture(input) && hashes[i].empty() ? ", no content hash\n" : "\n");
    }
    printShots(set);
    printAttributes("Tube", set.tube);
    for (const auto &[id, attributes] : set.sensors)
        printAttributes("Sensor " + id, attributes);
    for (const auto &[id, attributes] : set.instruments)
        printAttributes("Instrument " + id, attributes);
}

int info(const InfoOptions &options)
{
    const Result<Recipe> recipe = options.recipe.read();
    if (!recipe)
        return report(recipe.error());
    ProgressLine progress("Reading");
    const Result<CaptureSet> set
        = readCaptures(options.files, recipe->import, {interruptToken(), progress.sink()});
    if (!set)
        return report(set.error());
    const Result<std::vector<std::string>> hashes = contentHashes(*set);
    if (!hashes)
        return report(hashes.error());
    if (options.json)
        std::cout << jsonText(infoJson(*set, *hashes));
    else
        printInfo(*set, *hashes);
    reportFindings(set->findings);
    return static_cast<int>(exitCodeOf(set->findings));
}

} // namespace

void addInfo(CLI::App &program, VerbAction &action)
{
    const auto options = std::make_shared<InfoOptions>();
    CLI::App *verb
        = program.add_subcommand("info", "Show what files hold: shots, channels, rates, units");
    verb->add_option("files", options->files, "Captures, or folders of captures")
        ->required()
        ->type_name("FILE");
    options->recipe.declare(*verb);
    verb->add_flag("--json", options->json, "As JSON");
    verb->footer("Example:\n  dyncal info example.h5\n  dyncal info --json shots/");
    verb->callback([options, &action] { action = [options] { return info(*options); }; });
}

} // namespace dyncal
