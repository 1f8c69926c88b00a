// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/model_analysis/marked_frequencies.h"

#include "core/model_analysis/model_response.h"
#include "core/model_analysis/stated_characteristics.h"
#include "core/realization/model/model_assessment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

using MarkedFrequency = std::pair<double, RowMark>;

void addEdge(const StatedValue &edge, RowMark mark, std::vector<MarkedFrequency> &marks)
{
    if (edge.value)
        marks.emplace_back(*edge.value, mark);
}

bool isInBand(double f_Hz, const ResponseResult &result)
{
    return f_Hz >= result.fLow_Hz && f_Hz <= result.fHigh_Hz;
}

void addPeak(const SensorModel &model, ResponseTreatment treatment, const ResponseResult &result,
    std::vector<MarkedFrequency> &marks)
{
    const auto sensor = sensorResonance(&model, nullptr);
    const auto peak = sensor
        ? resonancePeak(model, treatment, sensor->frequency_Hz, sensor->dampingRatio)
        : std::nullopt;
    if (peak && isInBand(peak->frequency_Hz, result))
        marks.emplace_back(peak->frequency_Hz, RowMark::Resonance);
}

void take(const std::vector<MarkedFrequency> &marks, ResponseResult &result)
{
    result.frequency_Hz.resize(static_cast<Index>(marks.size()));
    result.marks.clear();
    for (const auto &[frequency_Hz, mark] : marks) {
        result.frequency_Hz[static_cast<Index>(result.marks.size())] = frequency_Hz;
        result.marks.push_back(mark);
    }
}

} // namespace

std::optional<ResonancePeak> resonancePeak(
    const SensorModel &model, ResponseTreatment treatment, double f0_Hz, double zeta)
{
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kRounds = 80;
    constexpr double kInside = 1.0 - 1e-6; // of the range: at its end |S| goes on rising
    if (!(zeta < std::numbers::sqrt2 / 2.0))
        return std::nullopt;
    const auto gain = [&](double f_Hz) {
        return std::abs(modelResponse(model, treatment, f_Hz) / model.level());
    };
    const double centre_Hz = f0_Hz * std::sqrt(1.0 - 2.0 * zeta * zeta);
    const double reach_Hz = std::min(0.5 * centre_Hz, zeta * f0_Hz);
    double low = centre_Hz - reach_Hz;
    double high = centre_Hz + reach_Hz;
    for (int i = 0; i < kRounds; ++i) {
        const double left = high - kGolden * (high - low);
        const double right = low + kGolden * (high - low);
        const bool isRising = gain(left) < gain(right);
        (isRising ? low : high) = isRising ? left : right;
    }
    const double top_Hz = 0.5 * (low + high);
    if (std::abs(top_Hz - centre_Hz) > kInside * reach_Hz)
        return std::nullopt;
    return ResonancePeak{top_Hz, gain(top_Hz)};
}

void markFrequencies(const SensorModel &model, ResponseTreatment treatment,
    const std::vector<KnownSensitivity> &known, ResponseResult &result)
{
    const StatedCharacteristics stated = statedCharacteristics(result);
    std::vector<MarkedFrequency> marks{
        {result.fLow_Hz, RowMark::LowEnd}, {result.fHigh_Hz, RowMark::HighEnd}};
    if (!result.isWithoutChain) { // edges and resonance are those of sensor and chain together
        addEdge(stated.within5percent_Hz, RowMark::Within5percent, marks);
        addEdge(stated.within10percent_Hz, RowMark::Within10percent, marks);
        addEdge(stated.minus3dB_Hz, RowMark::Minus3dB, marks);
        addPeak(model, treatment, result, marks);
    }
    for (const KnownSensitivity &other : known)
        if (isInBand(other.frequency_Hz, result))
            marks.emplace_back(other.frequency_Hz, RowMark::Known);
    std::ranges::sort(marks);
    marks.erase(std::unique(marks.begin(), marks.end()), marks.end()); // two may state the same
    take(marks, result);
}

} // namespace dyncal
