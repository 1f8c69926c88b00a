// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/matlab/mat.h"

#include "core/base/number_text.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/matlab/mat_file.h"
#include "core/capture/formats/matlab/mat_samples.h"
#include "core/capture/formats/matlab/mat_time.h"

#include <algorithm>
#include <set>

namespace dyncal {
namespace {

constexpr Index kFewValues = 8; ///< shorter ones are tables, if there are longer ones
constexpr Index kWide = 256; ///< channels of one matrix
constexpr std::size_t kChannels = 4096;
constexpr std::size_t kNamesShown = 10;

/// A matrix seen as channels side by side: time runs along its longer side.
struct Signals
{
    MatVariable *variable = nullptr;
    Index channels = 0, length = 0;
    Index channelStep = 0, sampleStep = 0; ///< from number to number in the file
};

Signals signalsOf(MatVariable &variable)
{
    if (variable.rows >= variable.columns)
        return {&variable, variable.columns, variable.rows, variable.rows, 1};
    return {&variable, variable.rows, variable.columns, 1, variable.rows};
}

class MatReader
{
public:
    MatReader(const std::string &path, const ImportSettings &settings, const JobControl &control,
        std::shared_ptr<const SampleFile> file)
        : m_path(path)
        , m_control(control)
        , m_file(std::move(file))
        , m_budget(m_file->size(), settings.maxExpansion)
        , m_time(path, settings.sampleRate_Hz)
    {
    }

    Result<CaptureSet> read()
    {
        Result<std::vector<MatVariable>> variables
            = listMatFile(m_path, m_file, m_budget, m_control);
        if (!variables)
            return tl::unexpected(variables.error());
        Index longest = 0;
        for (MatVariable &variable : *variables) {
            const Result<Index> length = sort(variable);
            if (!length)
                return tl::unexpected(length.error());
            longest = std::max(longest, *length);
        }
        for (const Signals &signal : m_signals) {
            if (signal.length < kFewValues && longest >= kFewValues)
                leaveOut(signal.variable->name, "few values");
            else if (signal.channels > kWide)
                leaveOut(signal.variable->name, "more than 256 columns");
            else if (const Result<void> added = addChannels(signal); !added)
                return tl::unexpected(added.error());
        }
        return finish();
    }

private:
    /// Sorts a variable into its list; returns the length if it is a signal.
    Result<Index> sort(MatVariable &variable)
    {
        if (!variable.isNumeric()) {
            leaveOut(variable.name, variable.kind);
            return 0;
        }
        const Signals signal = signalsOf(variable);
        if (signal.length == 1) {
            if (const auto value = matSamples(m_file, variable, 0, 1, 1))
                m_time.addScalar(variable.name, value->at(0));
            return 0;
        }
        if (signal.channels == 1 && m_time.isTimeName(variable.name)) {
            if (const Result<void> room = makeRoom(variable); !room)
                return tl::unexpected(room.error());
            if (const auto times = samplesOf(signal, 0))
                m_time.addVector(variable.name, *times);
            dropExpanded(variable, 0);
            return signal.length;
        }
        m_signals.push_back(signal);
        return signal.length;
    }

    /// Compressed numbers exist twice while they become samples.
    Result<void> makeRoom(const MatVariable &variable)
    {
        if (!variable.expanded || m_budget.take(largestCopy(variable)))
            return {};
        return m_budget.exceededBy(
            m_path, Expanding::Channel, variable.name, m_budget.taken() + largestCopy(variable));
    }

    static std::uint64_t largestCopy(const MatVariable &variable)
    {
        return static_cast<std::uint64_t>(variable.size()) * sizeof(double);
    }

    /// Only the samples are kept, with so many bytes.
    void dropExpanded(MatVariable &variable, std::uint64_t keptBytes)
    {
        if (!variable.expanded)
            return;
        m_budget.giveBack(variable.expanded->size() + largestCopy(variable));
        m_budget.take(keptBytes);
        variable.expanded.reset();
    }

    std::optional<RawSamples> samplesOf(const Signals &signal, Index channel) const
    {
        return matSamples(m_file, *signal.variable, channel * signal.channelStep, signal.sampleStep,
            signal.length);
    }

    Result<void> addChannels(const Signals &signal)
    {
        if (const Result<void> room = makeRoom(*signal.variable); !room)
            return room;
        std::vector<RawSamples> samples;
        std::uint64_t keptBytes = 0;
        for (Index c = 0; c < signal.channels; ++c) {
            std::optional<RawSamples> one = samplesOf(signal, c);
            if (!one)
                return fail(ErrorKind::FileUnreadable,
                    {DYNCAL_TEXT("core",
                         "%1: the 64-bit integers of %2 are too long to be kept exactly; save them as double."),
                        {m_path, signal.variable->name}},
                    "CAP-001");
            keptBytes += static_cast<std::uint64_t>(one->size() * bytesPerSample(one->type()));
            samples.push_back(std::move(*one));
        }
        dropExpanded(*signal.variable, keptBytes);
        const std::optional<Index> timeColumn
            = signal.channels > 1 ? m_time.columnOf(samples) : std::nullopt;
        const MatRate rate = timeColumn ? m_time.rateByColumn(signal.variable->name, *timeColumn,
                                 samples[static_cast<std::size_t>(*timeColumn)], m_findings)
                                        : m_time.rateOfLength(signal.length, m_findings);
        const Index timeAt = timeColumn.value_or(-1);
        for (Index c = 0; c < signal.channels; ++c) {
            if (c == timeAt)
                continue;
            if (m_shot.channels.size() >= kChannels)
                return impossibleField(m_path, "number of channels", "more than 4096");
            Channel channel;
            channel.name = signal.channels == 1
                ? signal.variable->name
                : signal.variable->name + " " + std::to_string(c + 1);
            channel.unit = "1";
            channel.sampleRate_Hz = rate.sampleRate_Hz;
            channel.t0_s = rate.first_s;
            channel.samples = std::move(samples[static_cast<std::size_t>(c)]);
            m_shot.channels.push_back(std::move(channel));
        }
        return {};
    }

    void leaveOut(const std::string &name, const std::string &kind)
    {
        if (m_leftOut++ < kNamesShown)
            m_leftOutNames += std::string(m_leftOutNames.empty() ? "" : ", ") + name;
        m_leftOutKinds.insert(kind);
    }

    Result<CaptureSet> finish()
    {
        if (m_shot.channels.empty())
            return noSignal(m_path);
        CaptureSet set;
        set.findings = std::move(m_findings);
        if (m_leftOut > 0) {
            std::string kinds;
            for (const std::string &kind : m_leftOutKinds)
                kinds += std::string(kinds.empty() ? "" : ", ") + kind;
            if (m_leftOut > kNamesShown)
                m_leftOutNames += ", ...";
            set.findings.push_back(leftOut(m_path, m_leftOutNames, kinds));
        }
        set.shots.push_back(std::move(m_shot));
        labelShots(set, m_path);
        return set;
    }

    const std::string &m_path;
    const JobControl &m_control;
    std::shared_ptr<const SampleFile> m_file;
    ExpansionBudget m_budget;
    MatTime m_time;
    std::vector<Signals> m_signals;
    Shot m_shot;
    Findings m_findings;
    std::size_t m_leftOut = 0;
    std::string m_leftOutNames;
    std::set<std::string> m_leftOutKinds;
};

} // namespace

int recogniseMat(const std::string &, std::string_view head)
{
    const int version = matVersion(head);
    return version == 5 ? 100 : version == 4 ? 90 : 0;
}

Result<CaptureSet> readMat(
    const std::string &path, const ImportSettings &settings, const JobControl &control)
{
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    return MatReader(path, settings, control, *file).read();
}

} // namespace dyncal
