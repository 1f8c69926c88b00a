// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/foreign/foreign_hdf5.h"
#include "tests/core/capture/capture_test_support.h"
#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"

#include <QTemporaryDir>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace dyncal::testing {

inline constexpr Index kSamples = 5000;

/// Value of sample i; kept by every type that is at least `bits` wide.
inline double valueAt(Index i, bool isSigned, int bits)
{
    const Index range = Index(1) << std::min(bits, 31);
    const Index value = (i * 7919 + i * i) % range;
    return static_cast<double>(isSigned ? value - range / 2 : value);
}

inline std::vector<double> valuesOf(bool isSigned, int bits, Index count = kSamples)
{
    std::vector<double> values;
    for (Index i = 0; i < count; ++i)
        values.push_back(valueAt(i, isSigned, bits));
    return values;
}

inline std::vector<double> physical(const Channel &channel)
{
    const Eigen::VectorXd values = physicalValues(channel, 0, channel.samples.size());
    return {values.begin(), values.end()};
}

inline std::vector<std::string> namesOf(const Result<CaptureSet> &set)
{
    std::vector<std::string> names;
    if (set) {
        for (const Channel &channel : set->shots.at(0).channels)
            names.push_back(channel.name);
    }
    return names;
}

using Names = std::vector<std::string>;

/// A folder with a file that a test makes and reads.
class ForeignFile
{
protected:
    std::string path(const char *name = "f.h5") const
    {
        return m_folder.filePath(name).toStdString();
    }

    Result<CaptureSet> readMade(const std::function<void(const Hdf5TestFile &)> &make,
        const ImportSettings &settings = {}) const
    {
        {
            const Hdf5TestFile file(path());
            make(file);
        }
        return readForeignHdf5(path(), settings, {});
    }

    static void ramp(const Hdf5TestFile &file, const std::string &name, Index count = 1000)
    {
        file.doubles(name, valuesOf(true, 16, count));
    }

    static std::vector<double> times(Index count, double first, double step)
    {
        std::vector<double> values;
        for (Index i = 0; i < count; ++i)
            values.push_back(first + static_cast<double>(i) * step);
        return values;
    }

    QTemporaryDir m_folder;
};

} // namespace dyncal::testing
