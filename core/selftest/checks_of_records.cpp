// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/checks_of_records.h"

#include "core/base/constants.h"
#include "core/base/content_hash.h"
#include "core/capture/capture_check.h"
#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/capture/import_rules.h"
#include "core/capture/opening/capture_open.h"
#include "core/selftest/known_records.h"
#include "core/selftest/passing_folder.h"
#include "core/signal/record_starts.h"

#include <algorithm>
#include <fstream>

namespace dyncal {
namespace {

/// A count of 1000 of the DUT by -2 (0.5 + 0.25 count)/4.
double importedValue(DataChange &change)
{
    Channel channel
        = knownChannel("DUT", ChannelRole::Other, Eigen::VectorXd::Constant(64, 1000.0), 1e6);
    channel.polynomial = {change(0.5), change(0.25)};
    ImportSettings settings;
    settings.channels["DUT"] = "dut";
    ChannelImport &detail = settings.channelDetails["DUT"];
    detail.scale = change(2.0);
    detail.gain = change(4.0);
    detail.polarity = -1;
    const auto set = applyImportSettings(knownSet({channel}), settings);
    if (!set)
        return kUnknown;
    const Channel *dut = set->shots.front().channelWithRole(ChannelRole::Dut);
    return dut ? physicalValues(*dut, 0, 1)[0] : kUnknown;
}

/// Shots cut at the rail of the converter, of two.
double saturatedShots(DataChange &change)
{
    CaptureSet set = knownSet({});
    set.shots.push_back(set.shots.front());
    for (std::size_t i = 0; i < 2; ++i) {
        std::vector<std::int16_t> counts(1000, 0);
        for (std::size_t k = 500; k < counts.size(); ++k)
            counts[k] = static_cast<std::int16_t>(i == 0 ? 8191 : 4000 + k % 7);
        Channel channel = knownChannel("DUT", ChannelRole::Dut, {}, 1e6);
        channel.samples = RawSamples(std::move(counts));
        channel.polynomial = {0.0, change(1.0)}; // its counts are whole numbers
        channel.adcMin = -8192.0;
        channel.adcMax = 8191.0;
        set.shots[i].channels.push_back(std::move(channel));
    }
    const Findings findings = checkCaptures(set);
    return static_cast<double>(std::ranges::count(findings, "CAP-007", &Finding::id));
}

double startOfSharpStep(DataChange &change)
{
    const Eigen::VectorXd values = change(sharpStep(4000, 1234, 1.0, 2.0));
    const auto start = detectStart(knownChannel("DUT", ChannelRole::Dut, values, 1e6));
    return start ? static_cast<double>(start->sample) : kUnknown;
}

/// A ramp of 1 per sample from sample 100 on crosses 37.25 a quarter behind sample 137.
double crossingOfRamp(DataChange &change)
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero(400);
    for (Index k = 100; k < values.size(); ++k)
        values[k] = change(static_cast<double>(k - 100));
    const Channel channel = knownChannel("side", ChannelRole::DrivenSide, values, 1.0);
    return crossingTime_s(channel, change(37.25), 0).value_or(kUnknown);
}

/// Of the samples of a capture that was written, read back and sealed: how many differ.
double samplesLost(DataChange &change)
{
    CaptureSet set = shockRecords();
    for (Channel &channel : set.shots.front().channels) {
        const Eigen::VectorXd values = change(physicalValues(channel, 0, channel.samples.size()));
        channel.samples = RawSamples(std::vector<double>(values.begin(), values.end()));
        channel.sensorId = channel.name;
    }
    const PassingFolder folder;
    const std::string path = folder.file("selftest.h5");
    if (!writeHdf5Capture(set, {path}, "2000-01-01T00:00:00Z", "self-test"))
        return kUnknown;
    const auto read = readCapture(path, {});
    if (!read || read->shots.size() != 1 || read->shots.front().channels.size() != 3)
        return kUnknown;
    Index lost = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel &before = set.shots.front().channels[c],
                      &after = read->shots.front().channels[c];
        const Index count = before.samples.size();
        if (after.samples.size() != count || after.sha256 != sha256OfSamples(before.samples))
            return kUnknown;
        lost
            += (physicalValues(after, 0, count).array() != physicalValues(before, 0, count).array())
                   .count();
    }
    return static_cast<double>(lost);
}

/// A table with decimal commas: its last value. It is text, so that there is no number to change.
double valueInTable(DataChange &)
{
    const PassingFolder folder;
    const std::string path = folder.file("selftest.csv");
    std::ofstream table(path);
    table << "time;DUT\n";
    for (int k = 0; k < 100; ++k)
        table << "0,0" << k / 10 << k % 10 << ";" << (k < 50 ? "0,25" : "1,75") << "\n";
    table.close();
    const auto read = readCapture(path, {});
    if (!read || read->shots.empty() || read->shots.front().channels.empty())
        return kUnknown;
    const Channel &channel = read->shots.front().channels.back();
    return channel.samples.size() == 100 ? physicalValues(channel, 99, 1)[0] : kUnknown;
}

/// Likewise of a text. Of the 64 digits of SHA-256 of "abc" those that are wrong.
double wrongDigitsOfHash(DataChange &)
{
    const std::string known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    const std::string found = sha256Hex(std::string_view("abc"));
    Index wrong = 0;
    for (std::size_t i = 0; i < known.size(); ++i)
        wrong += i < found.size() && found[i] == known[i] ? 0 : 1;
    return static_cast<double>(wrong);
}

} // namespace

std::vector<CheckSpec> checksOfRecords()
{
    const Message construction{DYNCAL_TEXT("core", "by construction"), {}};
    return {{"captures",
                {DYNCAL_TEXT("core", "value of one count by polynomial, gain and polarity"), {}},
                construction, -2.0 * 250.5 / 4.0, 1e-12, importedValue},
        {"captures", {DYNCAL_TEXT("core", "saturated shots found, of one"), {}}, construction, 1.0,
            0.1, saturatedShots},
        {"arrivals", {DYNCAL_TEXT("core", "sample at which a step begins"), {}}, construction,
            1234.0, 0.1, startOfSharpStep},
        {"arrivals", {DYNCAL_TEXT("core", "where a ramp crosses a level, in samples"), {}},
            construction, 137.25, 1e-9, crossingOfRamp},
        {kReadingStep,
            {DYNCAL_TEXT("core", "samples that a capture loses, written and read back"), {}},
            construction, 0.0, 0.1, samplesLost},
        {kReadingStep, {DYNCAL_TEXT("core", "value in a table with decimal commas"), {}},
            construction, 1.75, 1e-15, valueInTable},
        {kReadingStep, {DYNCAL_TEXT("core", "wrong digits of the SHA-256 of \"abc\""), {}},
            {DYNCAL_TEXT("core", "FIPS 180-4, example"), {}}, 0.0, 0.1, wrongDigitsOfHash}};
}

} // namespace dyncal
