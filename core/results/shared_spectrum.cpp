// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/shared_spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// Bins of different shots closer than this (relative) are the same frequency.
constexpr double kSameFrequency = 1e-9;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// All frequencies above 0 of all spectra, ascending, each once.
std::vector<double> allFrequencies(const std::vector<PowerSpectrum> &spectra)
{
    std::vector<double> all;
    for (const PowerSpectrum &spectrum : spectra)
        std::copy_if(spectrum.frequency_Hz.begin(), spectrum.frequency_Hz.end(),
            std::back_inserter(all), [](double f) { return f > 0.0; });
    std::sort(all.begin(), all.end());
    const auto same = [](double a, double b) { return b - a <= kSameFrequency * b; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
}

/// Lower edges of the cells: half way between neighbours, or log-spaced.
std::vector<double> lowerEdges(const std::vector<double> &frequencies, Index count)
{
    std::vector<double> edges;
    if (static_cast<Index>(frequencies.size()) <= count) {
        for (const double f : frequencies)
            edges.push_back(f * (1.0 - 10.0 * kSameFrequency));
        return edges;
    }
    const double first = frequencies.front() * (1.0 - 10.0 * kSameFrequency);
    const double ratio = frequencies.back() / first;
    for (Index i = 0; i < count; ++i)
        edges.push_back(
            first * std::pow(ratio, static_cast<double>(i) / static_cast<double>(count)));
    return edges;
}

} // namespace

SharedSpectrum sharedSpectrum(const std::vector<PowerSpectrum> &spectra, Index count)
{
    const std::vector<double> edges = lowerEdges(allFrequencies(spectra), count);
    const auto cells = static_cast<Index>(edges.size());
    Eigen::VectorXd frequency = Eigen::VectorXd::Constant(cells, kNone);
    Eigen::VectorXd largest = Eigen::VectorXd::Constant(cells, -1.0);
    Eigen::MatrixXd psd
        = Eigen::MatrixXd::Constant(cells, static_cast<Index>(spectra.size()), kNone);
    for (Index shot = 0; shot < psd.cols(); ++shot) {
        const PowerSpectrum &spectrum = spectra[static_cast<std::size_t>(shot)];
        for (Index bin = 0; bin < spectrum.psd.size(); ++bin) {
            const double f = spectrum.frequency_Hz[bin];
            const double value = spectrum.psd[bin];
            if (!(f > 0.0) || !std::isfinite(value))
                continue;
            const Index cell = std::upper_bound(edges.begin(), edges.end(), f) - edges.begin() - 1;
            if (!(psd(cell, shot) >= value)) // also true for NaN, the initial value
                psd(cell, shot) = value;
            if (value > largest[cell]) {
                largest[cell] = value;
                frequency[cell] = f;
            }
        }
    }
    std::vector<Index> used;
    for (Index cell = 0; cell < cells; ++cell) {
        if (std::isfinite(frequency[cell]))
            used.push_back(cell);
    }
    SharedSpectrum shared{frequency(used), {}};
    for (Index shot = 0; shot < psd.cols(); ++shot)
        shared.psd.emplace_back(psd.col(shot)(used));
    return shared;
}

} // namespace dyncal
