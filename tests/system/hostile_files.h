// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/results/mat_writer.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"
#include "tests/support/tdms_writer.h"

#include <QByteArray>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

/// Files in which every text field of their format holds a given text.
namespace dyncal::test {

constexpr int kRows = 300;
constexpr const char *kCreated = "2026-01-31T12:00:00Z";

inline double signalAt(int row)
{
    return (row < kRows / 3 ? 0.0 : 1.0) + 1e-3 * std::sin(12.9898 * row * row);
}

inline std::vector<double> signalValues()
{
    std::vector<double> values;
    for (int row = 0; row < kRows; ++row)
        values.push_back(signalAt(row));
    return values;
}

/// The text as a name that a link or a file can have.
inline std::string asName(std::string text)
{
    std::erase(text, '\0');
    std::ranges::replace(text, '/', '|');
    return text.substr(0, 200);
}

inline QByteArray csv(const QByteArray &text)
{
    QByteArray table = "# " + text + "\ntime [s]," + text + " [V]," + text + "\n";
    for (int row = 0; row < kRows; ++row)
        table += QByteArray::number(1e-6 * row, 'g', 9) + ',' + QByteArray::number(signalAt(row))
            + ",0.5\n";
    return table;
}

inline QByteArray lvm(const QByteArray &text)
{
    QByteArray file = "LabVIEW Measurement\t\r\nWriter_Version\t2\r\nSeparator\tTab\r\n"
                      "Multi_Headings\tYes\r\nX_Columns\tNo\r\nOperator\t"
        + text + "\r\nProject\t" + text
        + "\r\n***End_of_Header***\t\r\n\t\r\nChannels\t1\r\nSamples\t" + QByteArray::number(kRows)
        + "\r\nY_Unit_Label\t" + text
        + "\r\nX0\t0.0\r\nDelta_X\t1.0E-6\r\n***End_of_Header***\t\r\nX_Value\t" + text
        + "\tComment\r\n";
    for (int row = 0; row < kRows; ++row)
        file
            += '\t' + QByteArray::number(signalAt(row), 'f', 6) + (row ? "" : '\t' + text) + "\r\n";
    return file;
}

inline QByteArray tdms(const std::string &text)
{
    std::string quoted = text;
    for (std::size_t at = quoted.find('\''); at != std::string::npos;
         at = quoted.find('\'', at + 2))
        quoted.insert(at, 1, '\'');
    testing::TdmsSegment segment;
    segment.object("/").property("name", text.c_str()).property(text, text.c_str());
    segment.object("/'" + quoted + "'").property("comment", text.c_str());
    segment.channel<double>("/'" + quoted + "'/'" + quoted + "'", kRows)
        .property("wf_increment", 1e-6)
        .property("unit_string", text.c_str())
        .property(text, text.c_str());
    for (int row = 0; row < kRows; ++row)
        segment.data().add(signalAt(row));
    return QByteArray::fromStdString(segment.bytes());
}

inline void writeForeignHdf5(const std::string &path, const std::string &text)
{
    const testing::Hdf5TestFile file(path);
    const std::string name = asName(text);
    const std::string data = "/" + name + "/" + name;
    file.doubles(data, signalValues());
    file.number(data, "sample_rate_hz", 1e6);
    file.text(data, "units", text);
    file.text(data, name, text);
    file.text("/", name, text);
}

inline QByteArray mat(const std::string &text)
{
    MatWriter writer;
    const std::vector<double> values = signalValues();
    writer.add(text.substr(0, 60),
        Eigen::MatrixXd(Eigen::Map<const Eigen::VectorXd>(values.data(), kRows)));
    writer.add("sample_rate_hz", 1e6);
    return QByteArray::fromStdString(writer.bytes());
}

/// A valid capture in which every text is this one.
inline Result<void> writeCapture(const std::string &path, const std::string &text)
{
    SimulationSettings settings;
    settings.shots = {ShotLevel::Low};
    settings.sampleRate_Hz = 2e7;
    settings.duration_s = 0.005;
    const auto sensor = sensorPreset("optic3");
    if (!sensor)
        return tl::unexpected(sensor.error());
    settings.sensor = *sensor;
    auto made = simulateShots(settings);
    if (!made)
        return tl::unexpected(made.error());
    CaptureSet &set = made->set;
    set.tube[asName(text)] = text;
    set.instruments[asName(text)]["model"] = text;
    for (Shot &shot : set.shots) {
        shot.label = text;
        shot.notes["comment"] = text;
        for (Channel &channel : shot.channels) {
            channel.name = text + (channel.role == ChannelRole::Dut ? "" : " 2");
            channel.sensorId = text;
            channel.quantity = text;
        }
    }
    set.sensors[asName(text)]["serial"] = text;
    return writeHdf5Capture(set, {path, true}, kCreated, text);
}

inline QByteArray jsonBytes(const nlohmann::json &json)
{
    return QByteArray::fromStdString(
        json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

inline QByteArray recipe(const std::string &text)
{
    return jsonBytes({{"import", {{"exclude", nlohmann::json::array()}}},
        {"uncertainty", {{"monte_carlo_trials", 100}}},
        {"certificate",
            {{"fields",
                {{"customer", text}, {"remarks", text + "\nsecond line"}, {"number", text},
                    {"laboratory", text}}}}},
        {"acknowledge", {{{"finding", "SHK-001"}, {"shot", 1}, {"reason", text}}}}});
}

/// A value that no measurement gives, where it stands, and a sample interval that may be as odd.
struct OddNumbers
{
    double value = 0.0;
    const char *where = "none";
    double interval_s = 1e-6;
};

/// Two channels of TDMS, "dut" and "side", with a step and these numbers.
inline QByteArray tdms(const OddNumbers &odd)
{
    constexpr int kLong = 3000;
    const std::string_view where = odd.where;
    const auto holds = [&](bool dut, int row) {
        if (!dut)
            return where == "side";
        return where == "all" || (where == "first" && row < kLong / 3)
            || (where == "tail" && row > kLong / 2) || (where == "one" && row == kLong / 2);
    };
    testing::TdmsSegment segment;
    segment.object("/'g'");
    for (const char *name : {"/'g'/'dut'", "/'g'/'side'"})
        segment.channel<double>(name, kLong)
            .property("wf_increment", odd.interval_s)
            .property("unit_string", "V");
    for (const bool dut : {true, false})
        for (int row = 0; row < kLong; ++row) {
            const double usual
                = (row < (dut ? 1000 : 980) ? 0.0 : 1.0) + 1e-3 * std::sin(12.9898 * row * row);
            segment.data().add(holds(dut, row) ? odd.value : usual);
        }
    return QByteArray::fromStdString(segment.bytes());
}

} // namespace dyncal::test
