// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/result.h"
#include "core/capture/capture_set.h"
#include "tests/support/file_bytes.h"
#include "tests/support/measured_data.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace dyncal::testing {

/// The folder of recordings; empty if it is missing.
inline QString recordingsFolder()
{
    return QDir(QString::fromStdString(dataFolder().string())).canonicalPath();
}

/// Where QTemporaryDir is to be made by tests that write thousands of files: in memory if possible.
inline QString quickTemplate()
{
    const QString memory = QFileInfo("/dev/shm").isWritable() ? "/dev/shm" : QDir::tempPath();
    return memory + "/dyncal-XXXXXX";
}

inline std::string write(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
    return path.toStdString();
}

/// Runs a script with the system's Python (numpy, h5py); false if that is not there.
inline bool runPython(const QString &script, const QStringList &arguments)
{
    QProcess python;
    python.start("/usr/bin/python3", QStringList{"-c", script} + arguments);
    return python.waitForFinished(120000) && python.exitCode() == 0;
}

inline bool hasFinding(const Findings &findings, const std::string &id)
{
    return std::any_of(
        findings.begin(), findings.end(), [&](const Finding &finding) { return finding.id == id; });
}

template <typename T>
std::string sentence(const Result<T> &result)
{
    return result ? std::string() : english(result.error().message);
}

template <typename T>
std::string findingId(const Result<T> &result)
{
    return result ? std::string() : result.error().findingId;
}

inline bool contains(const std::string &text, const std::string &part)
{
    return text.find(part) != std::string::npos;
}

inline const Channel *channelNamed(const Shot &shot, const std::string &name)
{
    const auto found = std::find_if(shot.channels.begin(), shot.channels.end(),
        [&](const Channel &channel) { return channel.name == name; });
    return found != shot.channels.end() ? &*found : nullptr;
}

/// One shot with one DUT channel of these samples.
inline Shot shotOf(RawSamples::Counts counts, double sampleRate_Hz = 1e6)
{
    Shot shot;
    Channel channel;
    channel.name = "DUT";
    channel.role = ChannelRole::Dut;
    channel.samples = RawSamples(std::move(counts));
    channel.sampleRate_Hz = sampleRate_Hz;
    shot.channels.push_back(std::move(channel));
    return shot;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

} // namespace dyncal::testing
