// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/tdms/tdms.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/support/memory_file.h"
#include "tests/support/tdms_writer.h"

#include <QTemporaryDir>

namespace dyncal::testing {

/// Reads bytes as a file; a folder for a file that is needed on disk.
class TdmsFolder
{
public:
    std::string write(const std::string &bytes) const
    {
        return testing::write(m_folder.filePath("record.tdms"),
            QByteArray(bytes.data(), static_cast<qsizetype>(bytes.size())));
    }

    Result<CaptureSet> read(const std::string &bytes) const
    {
        const MemoryFile file(bytes.data(), bytes.size());
        return readTdms(file.path(), {}, {});
    }

private:
    QTemporaryDir m_folder;
};

inline std::vector<double> rawValuesOf(const RawSamples &samples, Index begin, Index end)
{
    std::vector<double> values;
    samples.visitBlocks(begin, end, [&](auto block, Index) {
        for (const auto value : block)
            values.push_back(static_cast<double>(value));
    });
    return values;
}

inline std::vector<double> rawValuesOf(const Channel &channel)
{
    return rawValuesOf(channel.samples, 0, channel.samples.size());
}

inline std::vector<double> physicalValuesOf(const Channel &channel)
{
    const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
    return {values.begin(), values.end()};
}

/// Values of a channel of the first shot; empty if it is not there.
inline std::vector<double> valuesIn(const Result<CaptureSet> &set, const std::string &name)
{
    const Channel *channel = set ? channelNamed(set->shots.front(), name) : nullptr;
    return channel != nullptr ? rawValuesOf(*channel) : std::vector<double>{};
}

template <typename... Numbers>
std::vector<double> numbers(Numbers... values)
{
    return {static_cast<double>(values)...};
}

inline const Finding *findingWith(const Findings &findings, const std::string &id)
{
    const auto found = std::find_if(
        findings.begin(), findings.end(), [&](const Finding &finding) { return finding.id == id; });
    return found != findings.end() ? &*found : nullptr;
}

} // namespace dyncal::testing
