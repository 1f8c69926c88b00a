// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/foreign/foreign_rate.h"

#include "core/base/ascii_text.h"
#include "core/base/number_text.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/hdf5/hdf5_columns.h"
#include "core/capture/formats/text/header_rate.h"
#include "core/capture/formats/text/time_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace dyncal {
namespace {

constexpr double kStepTolerance = 0.01; ///< of CAP-016

enum class RateWord { None, Rate, Interval };

/// Name without case, blanks and marks: "Sample_Rate" is "samplerate".
std::string bareWord(std::string_view name)
{
    std::string word = lowerCase(std::string(name));
    std::erase_if(word, [](char c) { return c == '_' || c == ' ' || c == '-' || c == '.'; });
    return word;
}

RateWord rateWord(std::string_view name)
{
    static constexpr std::array<std::string_view, 7> kRates{"samplerate", "samplingrate",
        "samplefrequency", "samplingfrequency", "samplefreq", "samplingfreq", "fs"};
    static constexpr std::array<std::string_view, 11> kIntervals{"dt", "deltat", "timestep",
        "timeincrement", "sampleinterval", "samplinginterval", "sampleperiod", "samplingperiod",
        "wfincrement", "xinc", "xincrement"};
    const std::string word = bareWord(name);
    if (std::find(kRates.begin(), kRates.end(), word) != kRates.end())
        return RateWord::Rate;
    const bool interval = std::find(kIntervals.begin(), kIntervals.end(), word) != kIntervals.end();
    return interval ? RateWord::Interval : RateWord::None;
}

/// "dt_us" is "dt" with the unit "us".
ColumnTitle nameAndUnit(const std::string &name)
{
    const std::size_t mark = name.find_last_of("_ ");
    if (rateWord(name) != RateWord::None || mark == std::string::npos)
        return {name, {}};
    const std::string unit = name.substr(mark + 1);
    const bool isUnit = hertzPerUnit(unit) || secondsPerUnit(unit);
    return isUnit ? ColumnTitle{name.substr(0, mark), unit} : ColumnTitle{name, {}};
}

/// Unit of an attribute, in an attribute beside it.
std::string unitBeside(const Hdf5Object &object, const std::string &name)
{
    std::vector<std::string> places{name + "_unit", name + "_units"};
    if (bareWord(name) == "xinc")
        places.push_back("XUnits");
    if (bareWord(name) == "wfincrement")
        places.push_back("wf_xunit_string");
    for (const std::string &place : places) {
        const auto unit = object.attributes.find(place);
        if (unit != object.attributes.end() && unit->second.kind == Hdf5ValueKind::Text)
            return unit->second.text;
    }
    return {};
}

/// A number, or a text that is a number and a unit ("100 MHz").
struct Quantity
{
    double value = 0.0;
    std::string unit;
};

std::optional<Quantity> quantityOf(const Hdf5Object &object, const std::string &name)
{
    if (const std::optional<double> number = numberAttribute(object, name))
        return Quantity{*number, unitBeside(object, name)};
    const std::string text = textAttribute(object, name).value_or("");
    const std::size_t blank = text.find(' ');
    if (blank == std::string::npos)
        return std::nullopt;
    const std::optional<double> number = parseNumber(text.substr(0, blank));
    return number ? std::optional(Quantity{*number, text.substr(blank + 1)}) : std::nullopt;
}

std::vector<StatedRate> ratesInAttributes(const Hdf5Object &object)
{
    std::vector<StatedRate> rates;
    for (const auto &[name, value] : object.attributes) {
        if (rateWord(nameAndUnit(name).name) == RateWord::None)
            continue;
        const std::optional<Quantity> quantity = quantityOf(object, name);
        const std::optional<StatedRate> rate
            = quantity ? statedRate(name, quantity->value, quantity->unit) : std::nullopt;
        if (rate)
            rates.push_back(*rate);
    }
    return rates;
}

/// Seconds per unit of a dataset of times; 1 without a unit, empty if its unit is none of time.
std::optional<double> timeUnit(const ForeignDataset &dataset)
{
    std::string unit = withUnitSplit({dataset.name, {}}).unit;
    for (const char *name : {"units", "unit", "Units", "Unit"})
        unit = textAttribute(*dataset.object, name).value_or(unit);
    return unit.empty() ? std::optional(1.0) : secondsPerUnit(unit);
}

/// Time of the first sample, where the dataset or its group states it in seconds.
double statedStart_s(const ForeignDataset &dataset)
{
    for (const Hdf5Object *place : {dataset.object, dataset.groups.front()}) {
        for (const char *name : {"t0_s", "wf_start_offset", "XOrg"}) {
            const std::optional<double> start = numberAttribute(*place, name);
            const std::string unit = name == std::string_view("XOrg")
                ? textAttribute(*place, "XUnits").value_or("s")
                : "s";
            if (start && std::isfinite(*start) && secondsPerUnit(unit))
                return *start * *secondsPerUnit(unit);
        }
    }
    return 0.0;
}

/// Whether the times rise by equal steps along a straight line (see TimeAxis); steps may differ by
/// 1 %, and by the spacing of the numbers that hold them as long as that is at most half a step.
bool isUniform(const RawSamples &times, double first, double last)
{
    const double step = (last - first) / static_cast<double>(times.size() - 1);
    if (!(step > 0.0) || !std::isfinite(step))
        return false;
    const double digits = times.type() == SampleType::Float32 ? 0x1p-23 : 0x1p-52;
    const double spacing = 2.0 * digits * std::max(std::abs(first), std::abs(last));
    const double tolerance = kStepTolerance * step + (spacing <= 0.5 * step ? spacing : 0.0);
    const double mostDrift = kMostDrift_steps * step + spacing;
    double before = first - step;
    double line = 0.0; // steps from the first time on
    bool uniform = true;
    const bool read = times.visitBlocks(0, times.size(), [&](auto values, Index) {
        for (const auto value : values) {
            const auto time = static_cast<double>(value);
            uniform = uniform && std::abs(time - before - step) <= tolerance
                && std::abs(time - first - line * step) <= mostDrift;
            line += 1.0;
            before = time;
        }
        return uniform;
    });
    return read && uniform;
}

} // namespace

std::optional<StatedRate> statedRate(const std::string &name, double value, const std::string &unit)
{
    const ColumnTitle title = nameAndUnit(name);
    const RateWord word = rateWord(title.name);
    const std::string unitText = unit.empty() ? title.unit : unit;
    const bool isRate = word == RateWord::Rate;
    const std::optional<double> factor = unitText.empty() ? std::optional(1.0)
        : isRate                                          ? hertzPerUnit(unitText)
                                                          : secondsPerUnit(unitText);
    if (word == RateWord::None || !factor)
        return std::nullopt;
    const double rate_Hz = isRate ? value * *factor : 1.0 / (value * *factor);
    const double least_Hz = unitText.empty() ? kCredibleRate_Hz : 0.0;
    if (!std::isfinite(rate_Hz) || rate_Hz <= 0.0 || rate_Hz < least_Hz)
        return std::nullopt;
    return StatedRate{rate_Hz, name + " = " + numberText(value) + (unit.empty() ? "" : " " + unit)};
}

Result<TimingFinder> TimingFinder::make(
    const Hdf5File &file, const std::vector<ForeignDataset> &datasets, const JobControl &control)
{
    TimingFinder finder(file.path);
    if (const Result<void> done = finder.read(file, datasets, control); !done)
        return tl::unexpected(done.error());
    return finder;
}

Result<void> TimingFinder::read(
    const Hdf5File &file, const std::vector<ForeignDataset> &datasets, const JobControl &control)
{
    std::vector<Hdf5Wish> wishes;
    std::vector<const ForeignDataset *> wanted;
    for (const ForeignDataset &dataset : datasets) {
        const Hdf5Dataset &data = dataset.object->dataset;
        const bool single
            = data.elements() == 1 && rateWord(nameAndUnit(dataset.name).name) != RateWord::None;
        const bool times = data.elements() >= 2 && isTimeTitle({dataset.name, {}})
            && channelsOf(dataset, file.path).names.size() == 1;
        if (data.obstacle != Hdf5Obstacle::None || (!single && !times))
            continue;
        const Index axis = times ? channelsOf(dataset, file.path).sampleAxis : 0;
        wishes.push_back({&data, dataset.object->address, dataset.path, axis});
        wanted.push_back(&dataset);
    }
    const auto columns = hdf5Columns(file, wishes, control);
    if (!columns)
        return tl::unexpected(columns.error());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const ForeignDataset &dataset = *wanted[i];
        const RawSamples &samples = (*columns)[i].front();
        if (samples.size() == 1) {
            const std::string unit = textAttribute(*dataset.object, "units").value_or("");
            if (const auto rate = statedRate(dataset.name, samples.at(0), unit))
                m_scalars[dataset.groups.front()].push_back(*rate);
        } else if (const std::optional<double> unit = timeUnit(dataset)) {
            const double first = samples.at(0);
            const double last = samples.at(samples.size() - 1);
            const double span_s = (last - first) * *unit;
            m_axes.push_back({&dataset, samples.size(), isUniform(samples, first, last),
                static_cast<double>(samples.size() - 1) / span_s, first * *unit});
        }
    }
    return {};
}

std::optional<StatedRate> TimingFinder::statedFor(
    const ForeignDataset &dataset, Findings &findings) const
{
    std::vector<const Hdf5Object *> places{dataset.object};
    places.insert(places.end(), dataset.groups.begin(), dataset.groups.end());
    for (const Hdf5Object *place : places) {
        std::vector<StatedRate> rates = ratesInAttributes(*place);
        if (const auto scalars = m_scalars.find(place); scalars != m_scalars.end())
            rates.insert(rates.end(), scalars->second.begin(), scalars->second.end());
        for (const StatedRate &rate : rates) {
            if (ratesAgree(rate.rate_Hz, rates.front().rate_Hz))
                continue;
            findings.push_back({.id = "CAP-003",
                .severity = Severity::Caution,
                .channel = dataset.path,
                .message
                = {DYNCAL_TEXT("core",
                       "%1: %2 has the sample rate stated twice, as %3 and as %4; give the right one."),
                    {m_path, dataset.path, rates.front().text, rate.text}},
                .value = rate.rate_Hz,
                .limit = rates.front().rate_Hz});
            return StatedRate{};
        }
        if (!rates.empty())
            return rates.front();
    }
    return std::nullopt;
}

const TimingFinder::Axis *TimingFinder::axisFor(const ForeignDataset &dataset, Index samples) const
{
    for (const Hdf5Object *group : dataset.groups) {
        for (const Axis &axis : m_axes) {
            if (axis.dataset->groups.front() == group && axis.samples == samples
                && axis.dataset->object != dataset.object)
                return &axis;
        }
    }
    return nullptr;
}

SampleTiming TimingFinder::timingOf(
    const ForeignDataset &dataset, Index samples, Findings &findings) const
{
    const std::optional<StatedRate> stated = statedFor(dataset, findings);
    const Axis *axis = axisFor(dataset, samples);
    if (axis == nullptr)
        return {stated ? stated->rate_Hz : 0.0, statedStart_s(dataset)};
    if (!axis->uniform) {
        findings.push_back({.id = "CAP-016",
            .severity = Severity::Caution,
            .channel = dataset.path,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: the times in %2 do not rise by equal steps, so the sample rate of %3 is unknown; state it, or resample the record."),
                {m_path, axis->dataset->path, dataset.path}}});
        return {};
    }
    if (!stated || ratesAgree(stated->rate_Hz, axis->rate_Hz)) {
        constexpr double kRounding = 1e-6; // what the digits of times explain
        const bool same
            = stated && std::abs(stated->rate_Hz - axis->rate_Hz) <= kRounding * stated->rate_Hz;
        return {same ? stated->rate_Hz : axis->rate_Hz, axis->first_s};
    }
    if (stated->rate_Hz > 0.0)
        findings.push_back({.id = "CAP-003",
            .severity = Severity::Caution,
            .channel = dataset.path,
            .message
            = {DYNCAL_TEXT("core",
                   "%1: %2 states %3, but the times in %4 give %5; give the right sample rate."),
                {m_path, dataset.path, stated->text, axis->dataset->path,
                    numberWithUnit(axis->rate_Hz, "Hz", 6)}},
            .value = axis->rate_Hz,
            .limit = stated->rate_Hz});
    return {0.0, axis->first_s};
}

bool TimingFinder::isTimes(const ForeignDataset &dataset) const
{
    return std::any_of(m_axes.begin(), m_axes.end(),
        [&](const Axis &axis) { return axis.dataset->object == dataset.object; });
}

} // namespace dyncal
