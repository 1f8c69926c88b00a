// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/capture_test_support.h"

#include <QByteArray>
#include <QList>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace dyncal::testing {

/// Times are printed as decimals: 1/step has a few roundings on top.
inline constexpr double kRateAllowance = 1e-9;

inline std::vector<double> valuesOf(const Channel &channel)
{
    std::vector<double> values;
    for (Index i = 0; i < channel.samples.size(); ++i)
        values.push_back(channel.samples.at(i));
    return values;
}

inline bool near(double a, double b, double relative)
{
    return std::abs(a - b) <= relative * std::abs(b);
}

inline ImportSettings withColumns(std::map<std::string, Index> columns)
{
    ImportSettings settings;
    settings.columns = std::move(columns);
    return settings;
}

/// Rows "k * step, sin, k^2" written with any separator and decimal mark.
inline QByteArray table(int rows, double step, const QByteArray &separator, char decimal)
{
    QByteArray text;
    for (int k = 0; k < rows; ++k) {
        const QList<double> cells{k * step, std::sin(0.1 * k), 0.5 * k * k};
        QByteArray line;
        for (const double cell : cells)
            line += (line.isEmpty() ? QByteArray() : separator) + QByteArray::number(cell, 'g', 17);
        text += line.replace('.', decimal) + "\n";
    }
    return text;
}

} // namespace dyncal::testing
