// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/text/text_time.h"

#include "core/base/number_text.h"
#include "core/capture/formats/bytes/time_axis.h"
#include "core/capture/formats/text/header_rate.h"
#include "core/capture/formats/text/text_dialect.h"
#include "core/capture/formats/text/time_sentences.h"
#include "core/capture/formats/text/time_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// From this rate on a column without unit is certainly in seconds: in ms the rate would be 1 GHz.
/// Slightly less than 1 MHz, because it comes from printed times.
constexpr double kCertainRate_Hz = 0.999e6;

/// A header rate without unit may be in kHz or MHz, an interval in ms or us.
bool agrees(const HeaderRate &stated, double rate_Hz)
{
    for (const double factor : {1.0, 1e3, 1e6, 1e9}) {
        if (ratesAgree(stated.rate_Hz * factor, rate_Hz)
            || ratesAgree(stated.rate_Hz, rate_Hz * factor))
            return true;
        if (stated.unitStated)
            break;
    }
    return false;
}

/// Works on one table; see timeOfTable.
class TimeReader
{
public:
    TimeReader(const std::string &path, const ImportSettings &settings, const TextDialect &dialect,
        const std::vector<ColumnTitle> &titles, const std::vector<std::vector<double>> &columns)
        : m_say{path, titles, dialect.headerLines()}
        , m_settings(settings)
        , m_columns(columns)
        , m_header(headerRates(dialect))
    {
    }

    Result<TextTime> read()
    {
        if (const Result<void> checked = checkHeaderAlone(); !checked)
            return tl::unexpected(checked.error());
        const Result<void> found = findColumn();
        if (!found)
            return tl::unexpected(found.error());
        if (!m_time.column) {
            takeHeaderRate();
            return std::move(m_time);
        }
        const auto column = static_cast<std::size_t>(*m_time.column);
        const ColumnTitle title = withUnitSplit(m_say.titles[column]);
        const std::string unit = isRowNumberTitle(title) ? std::string() : title.unit;
        const std::optional<double> scale_s = secondsPerUnit(unit);
        if (!unit.empty() && !scale_s)
            return m_say.unknownUnit(unit);
        if (m_columns[column].size() < 2) {
            takeHeaderRate();
            return std::move(m_time);
        }
        const TimeAxis axis = timeAxisOf(m_columns[column]);
        if (axis.irregular)
            return m_say.irregular(m_columns[column], axis);
        if (const Result<void> alone = checkOtherTimes(axis, scale_s.value_or(1.0)); !alone)
            return tl::unexpected(alone.error());
        const Result<void> rated = scale_s ? takeStated(axis, *scale_s) : takeUnstated(axis);
        if (!rated)
            return tl::unexpected(rated.error());
        return std::move(m_time);
    }

private:
    Result<void> checkHeaderAlone() const
    {
        for (const HeaderRate &rate : m_header) {
            if (!m_settings.sampleRate_Hz && !agrees(rate, m_header.front().rate_Hz)
                && !agrees(m_header.front(), rate.rate_Hz))
                return m_say.headerContradictsItself(m_header.front(), rate);
        }
        return {};
    }

    Result<void> findColumn()
    {
        const auto named = m_settings.columns.find("time");
        if (named != m_settings.columns.end()) {
            m_time.column = named->second;
            m_titled = true;
            return {};
        }
        if (m_columns.size() < 2)
            return {};
        if (!m_settings.columns.empty()) {
            noteWhatIsPassedOver();
            return {};
        }
        const ColumnTitle &first = m_say.titles[0];
        if (isFrequencyTitle(first) && riseOf(m_columns[0]) != ColumnRise::None)
            return m_say.frequencies(first);
        m_time.column = titledColumn();
        m_titled = m_time.column.has_value();
        return m_titled ? Result<void>() : findUntitled(first, riseOf(m_columns[0]));
    }

    /// Columns in pairs, each with times of its own, must not all take the first one's.
    Result<void> checkOtherTimes(const TimeAxis &axis, double scale_s) const
    {
        for (std::size_t i = 0; m_settings.columns.empty() && i < m_columns.size(); ++i) {
            const ColumnTitle title = withUnitSplit(m_say.titles[i]);
            const auto unit_s = secondsPerUnit(title.unit);
            const ColumnRise rise = riseOf(m_columns[i]);
            if (static_cast<Index>(i) == *m_time.column || !(unit_s || isTimeTitle(title))
                || rise == ColumnRise::None || rise == ColumnRise::Uneven)
                continue;
            const TimeAxis other = timeAxisOf(m_columns[i]);
            const double factor = unit_s.value_or(scale_s) / scale_s;
            const bool same = ratesAgree(other.step * factor, axis.step)
                && std::abs(other.first * factor - axis.first) <= 0.5 * axis.step;
            if (!same)
                return m_say.otherTimes(m_say.titles[i].name,
                    m_say.titles[static_cast<std::size_t>(*m_time.column)].name);
        }
        return {};
    }

    std::optional<Index> titledColumn() const
    {
        const std::vector<ColumnTitle> &titles = m_say.titles;
        const auto title = std::find_if(titles.begin(), titles.end(), &isTimeTitle);
        if (title != titles.end())
            return title - titles.begin();
        return secondsPerUnit(titles[0].unit) ? std::optional<Index>(0) : std::nullopt;
    }

    /// The first column, if its numbers look like times or row numbers and no title or unit says
    /// otherwise.
    Result<void> findUntitled(const ColumnTitle &title, ColumnRise rise)
    {
        const bool neutral
            = isNeutralTitle(title) && (title.unit.empty() || isRowNumberTitle(title));
        if (rise == ColumnRise::None || (!neutral && !title.unit.empty()))
            return {};
        const bool rowNumbers = rise == ColumnRise::Counter && (neutral || isRowNumberTitle(title));
        if (neutral && rise == ColumnRise::Gaps)
            return m_say.irregular(m_columns[0], timeAxisOf(m_columns[0]));
        if (rowNumbers || (neutral && rise == ColumnRise::Uniform))
            m_time.column = 0;
        else if (rise != ColumnRise::Counter)
            m_time.findings.push_back(m_say.looksLikeTimes(title));
        return {};
    }

    /// A recipe may ignore the times, but then a finding tells what they state.
    void noteWhatIsPassedOver()
    {
        const std::optional<Index> titled = titledColumn();
        const bool neutral = isNeutralTitle(m_say.titles[0]) && m_say.titles[0].unit.empty();
        if (!titled && (!neutral || riseOf(m_columns[0]) == ColumnRise::None))
            return;
        const auto column = static_cast<std::size_t>(titled.value_or(0));
        const bool used = std::any_of(m_settings.columns.begin(), m_settings.columns.end(),
            [&](const auto &entry) { return entry.second == static_cast<Index>(column); });
        if (used || m_columns[column].size() < 2)
            return;
        const TimeAxis axis = timeAxisOf(m_columns[column]);
        const auto scale_s = secondsPerUnit(withUnitSplit(m_say.titles[column]).unit);
        if (axis.irregular)
            m_time.findings.push_back(m_say.irregularPassedOver(axis));
        else if (scale_s && m_settings.sampleRate_Hz
            && !ratesAgree(*m_settings.sampleRate_Hz, 1.0 / (axis.step * *scale_s)))
            m_time.findings.push_back(
                m_say.ratePassedOver(*m_settings.sampleRate_Hz, 1.0 / (axis.step * *scale_s)));
    }

    void takeHeaderRate()
    {
        if (m_header.empty())
            return;
        m_time.sampleRate_Hz = m_header.front().rate_Hz;
        if (!m_header.front().unitStated && !m_settings.sampleRate_Hz)
            m_time.findings.push_back(m_say.headerUnitAssumed(m_header.front()));
    }

    void take(const TimeAxis &axis, double scale_s)
    {
        // Kept finite, so that a message can name even an absurd step.
        m_time.sampleRate_Hz = std::clamp(1.0 / (axis.step * scale_s),
            std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
        m_time.first_s = axis.first * scale_s;
    }

    Result<void> takeStated(const TimeAxis &axis, double scale_s)
    {
        take(axis, scale_s);
        if (m_settings.sampleRate_Hz
            && !ratesAgree(*m_settings.sampleRate_Hz, m_time.sampleRate_Hz)) {
            if (m_settings.sampleRateReason.empty())
                return m_say.recipeAgainstTimes(*m_settings.sampleRate_Hz, m_time.sampleRate_Hz);
            return {}; // the import rules replace the rate and print the reason
        }
        for (const HeaderRate &rate : m_header) {
            if (agrees(rate, m_time.sampleRate_Hz))
                continue;
            if (!m_settings.sampleRate_Hz) // a rate in the recipe decides
                return m_say.headerAgainstTimes(rate, m_time.sampleRate_Hz);
            m_time.findings.push_back(m_say.headerOverruled(rate, m_time.sampleRate_Hz));
        }
        return {};
    }

    /// Numbers without unit: a rate stated elsewhere gives the unit.
    Result<void> takeUnstated(const TimeAxis &axis)
    {
        const bool counter = isCounter(axis);
        std::optional<double> known_Hz = m_settings.sampleRate_Hz;
        if (!known_Hz && !m_header.empty() && m_header.front().unitStated)
            known_Hz = m_header.front().rate_Hz;
        if (!known_Hz && !m_header.empty()) {
            takeHeaderRate();
            known_Hz = m_time.sampleRate_Hz;
        }
        for (const double scale_s : {1.0, 1e-3, 1e-6, 1e-9}) {
            if (known_Hz && !counter && ratesAgree(*known_Hz, 1.0 / (axis.step * scale_s))) {
                take(axis, scale_s);
                return {};
            }
        }
        const bool reasoned = m_settings.sampleRate_Hz && !m_settings.sampleRateReason.empty();
        if (known_Hz && !counter && !reasoned)
            return m_say.noUnitAgrees(axis.step, *known_Hz);
        if (known_Hz) {
            m_time.sampleRate_Hz = m_settings.sampleRate_Hz ? 0.0 : *known_Hz;
            return {};
        }
        const double inSeconds_Hz = 1.0 / axis.step;
        const double needed_Hz = m_titled ? kCredibleRate_Hz : kCertainRate_Hz;
        const std::string &name = m_say.titles[static_cast<std::size_t>(*m_time.column)].name;
        if (counter || inSeconds_Hz < needed_Hz) {
            m_time.findings.push_back(m_say.unitUnknown(name, axis.step, counter));
            return {};
        }
        take(axis, 1.0);
        m_time.findings.push_back(m_say.secondsAssumed(name, inSeconds_Hz,
            inSeconds_Hz >= kCertainRate_Hz ? Severity::Info : Severity::Caution));
        return {};
    }

    TimeSentences m_say;
    const ImportSettings &m_settings;
    const std::vector<std::vector<double>> &m_columns;
    std::vector<HeaderRate> m_header;
    TextTime m_time;
    bool m_titled = false; ///< title or recipe calls the column times
};

} // namespace

Result<TextTime> timeOfTable(const std::string &path, const ImportSettings &settings,
    const TextDialect &dialect, const std::vector<ColumnTitle> &titles,
    const std::vector<std::vector<double>> &columns)
{
    return TimeReader(path, settings, dialect, titles, columns).read();
}

} // namespace dyncal
