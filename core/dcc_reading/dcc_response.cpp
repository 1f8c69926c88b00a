// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_response.h"

#include "core/base/ascii_text.h"
#include "core/base/constants.h"
#include "core/base/propagation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace dyncal {
namespace {

using Candidates = std::vector<const StatedQuantity *>;

tl::unexpected<Error> refused(Message message)
{
    return fail(ErrorKind::Usage, std::move(message));
}

Candidates thoseOf(
    const Candidates &all, const std::function<bool(const StatedQuantity &)> &isMeant)
{
    Candidates meant;
    for (const StatedQuantity *one : all)
        if (isMeant(*one))
            meant.push_back(one);
    return meant;
}

/// The quantity that is meant among those in one kind of unit; null where there is none or it is
/// not clear which.
const StatedQuantity *meantOf(const Candidates &all, const std::vector<const char *> &refTypes)
{
    if (all.size() == 1)
        return all.front();
    for (const char *refType : refTypes) {
        const Candidates named
            = thoseOf(all, [&](const StatedQuantity &one) { return one.hasRefType(refType); });
        if (named.size() == 1)
            return named.front();
    }
    const Candidates uncertain
        = thoseOf(all, [](const StatedQuantity &one) { return !one.stated.values.u.empty(); });
    return uncertain.size() == 1 ? uncertain.front() : nullptr;
}

Candidates columnsOf(const StatedTable &table)
{
    Candidates columns;
    for (const StatedQuantity &one : table.columns)
        columns.push_back(&one);
    return columns;
}

std::string linesOf(const Candidates &all)
{
    std::vector<std::string> lines;
    for (const StatedQuantity *one : all)
        lines.push_back(std::to_string(one->line));
    return commaList(lines);
}

/// `text` begins with the line of the list, place %1; the lines of the candidates are place %2.
tl::unexpected<Error> notOne(
    const StatedTable &table, const char *text, const Candidates &all, const std::string &unit = {})
{
    return refused({text, {std::to_string(table.line), linesOf(all), unit}, table.notUnderstood});
}

constexpr const char *kNoFrequencies = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has no frequencies in hertz, which a response over frequency needs.");
constexpr const char *kSeveralFrequencies = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has several quantities in hertz (lines %2), and which of them are the frequencies is not guessed; its laboratory must mark them by a refType.");
constexpr const char *kNoMagnitudes = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has no magnitudes in the unit of a sensitivity, such as V/Pa, V/N or V/(m/s2).");
constexpr const char *kNoneInUnit = DYNCAL_TEXT(
    "core", "The list in line %1 of the certificate has no magnitudes in %3, which are asked for.");
constexpr const char *kSeveralMagnitudes = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has several quantities in the unit of a sensitivity (lines %2), and which of them is meant is not guessed; its laboratory must mark it by a refType.");
constexpr const char *kSeveralPhases = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has several angles (lines %2), and which of them are the phases is not guessed; its laboratory must mark them by a refType.");

Result<const StatedQuantity *> frequencyOf(const StatedTable &table, const Candidates &columns)
{
    const Candidates inHertz = thoseOf(columns, [](const StatedQuantity &one) {
        return !one.isComplex() && one.stated.values.unit.isOf("Hz");
    });
    const StatedQuantity *found
        = meantOf(inHertz, {"dyncal_frequency", "vib_frequency", "basic_tableIndex0"});
    if (!found)
        return notOne(table, inHertz.empty() ? kNoFrequencies : kSeveralFrequencies, inHertz);
    return found;
}

Result<const StatedQuantity *> magnitudeOf(
    const StatedTable &table, const Candidates &columns, const std::optional<DSiUnit> &unit)
{
    const auto isInUnit = [&unit](const StatedQuantity &one) {
        const DSiUnit &its = one.stated.values.unit;
        return unit ? its.powers == unit->powers : its.isSensitivity();
    };
    const Candidates inUnit = thoseOf(columns, isInUnit);
    const Candidates real
        = thoseOf(inUnit, [](const StatedQuantity &one) { return !one.isComplex(); });
    const StatedQuantity *found = meantOf(
        real.empty() ? inUnit : real, {"dyncal_magnitude", "vib_magnitude", "basic_measuredValue"});
    if (found)
        return found;
    if (inUnit.empty())
        return notOne(
            table, unit ? kNoneInUnit : kNoMagnitudes, inUnit, unit ? unit->symbol() : "");
    return notOne(table, kSeveralMagnitudes, inUnit);
}

/// Null where there are none.
Result<const StatedQuantity *> phaseOf(const StatedTable &table, const Candidates &columns)
{
    const Candidates inRadian = thoseOf(columns, [](const StatedQuantity &one) {
        return !one.isComplex() && one.stated.values.unit.isOf("rad");
    });
    const StatedQuantity *found
        = meantOf(inRadian, {"dyncal_phase", "vib_phase", "basic_measuredValue"});
    if (!found && !inRadian.empty())
        return notOne(table, kSeveralPhases, inRadian);
    return found;
}

Result<void> checkLengths(const StatedTable &table, const Candidates &columns)
{
    const std::size_t count = columns.front()->stated.values.values.size();
    for (const StatedQuantity *one : columns)
        if (one->stated.values.values.size() != count)
            return refused(
                {DYNCAL_TEXT("core",
                     "The list in line %1 of the certificate has %2 frequencies and, in line %3, %4 values; as many of each are needed."),
                    {std::to_string(table.line), std::to_string(count), std::to_string(one->line),
                        std::to_string(one->stated.values.values.size())}});
    const auto isNone = [](double f_Hz) { return !(f_Hz > 0.0); };
    if (std::ranges::none_of(columns.front()->stated.values.values, isNone))
        return {};
    return refused(
        {DYNCAL_TEXT("core",
             "The frequencies in line %1 of the certificate are not all above 0; which rows are meant is not guessed."),
            {std::to_string(columns.front()->line)}});
}

StatedValues rowsOf(const StatedValues &all, const std::vector<std::size_t> &rows)
{
    StatedValues kept{all.unit, {}, {}, {}};
    for (const std::size_t row : rows) {
        kept.values.push_back(all.values[row]);
        if (all.u.empty())
            continue;
        kept.u.push_back(all.u[row]);
        kept.k.push_back(all.k[row]);
    }
    return kept;
}

/// Effective degrees of freedom of each row, which certificates of this program state; infinite
/// where they are not.
std::vector<double> dofOf(const StatedTable &table, std::size_t count)
{
    const auto found = std::ranges::find_if(table.columns,
        [](const StatedQuantity &one) { return one.hasRefType("dyncal_degreesOfFreedom"); });
    std::vector<double> dof(count, std::numeric_limits<double>::infinity());
    if (found == table.columns.end() || found->stated.values.values.size() != count)
        return dof;
    for (std::size_t i = 0; i < count; ++i)
        if (const double stated = found->stated.values.values[i]; stated > 0.0)
            dof[i] = stated;
    return dof;
}

/// Student's factor of 95 % where no other is stated.
void fillFactors(StatedValues &stated, const std::vector<double> &dof)
{
    constexpr double kCoverage = 0.95;
    for (std::size_t i = 0; i < stated.k.size(); ++i)
        if (std::isnan(stated.k[i]) && std::isfinite(dof[i]))
            stated.k[i] = coverageFactor(dof[i], kCoverage);
}

CertifiedResponse responseFrom(const StatedTable &table, const std::vector<double> &f_Hz,
    const StatedValues &magnitude, const StatedValues *phase)
{
    CertifiedResponse response;
    response.notUnderstood = table.notUnderstood;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < f_Hz.size(); ++i) {
        if (!std::isfinite(magnitude.values[i]))
            continue;
        rows.push_back(i);
        response.frequency_Hz.push_back(f_Hz[i]);
    }
    response.withoutValue = static_cast<Index>(f_Hz.size() - rows.size());
    const std::vector<double> dof = dofOf(table, f_Hz.size());
    for (const std::size_t row : rows)
        response.dof.push_back(dof[row]);
    const auto kept = [&](StatedValues all) {
        fillFactors(all, dof);
        return rowsOf(all, rows);
    };
    response.magnitude = kept(magnitude);
    if (phase)
        response.phase_rad = kept(*phase);
    return response;
}

} // namespace

Result<CertifiedResponse> responseOf(const StatedTable &table, const std::optional<DSiUnit> &unit)
{
    const Candidates columns = columnsOf(table);
    const Result<const StatedQuantity *> frequency = frequencyOf(table, columns);
    if (!frequency)
        return tl::unexpected<Error>(frequency.error());
    const Result<const StatedQuantity *> magnitude = magnitudeOf(table, columns, unit);
    if (!magnitude)
        return tl::unexpected<Error>(magnitude.error());
    Candidates used{*frequency, *magnitude};
    const StatedValues *phases = nullptr;
    if ((*magnitude)->isComplex()) {
        phases = &*(*magnitude)->stated.phases_rad;
    } else {
        const Result<const StatedQuantity *> phase = phaseOf(table, columns);
        if (!phase)
            return tl::unexpected<Error>(phase.error());
        if (*phase) {
            used.push_back(*phase);
            phases = &(*phase)->stated.values;
        }
    }
    if (const Result<void> lengths = checkLengths(table, used); !lengths)
        return tl::unexpected<Error>(lengths.error());
    CertifiedResponse response = responseFrom(
        table, (*frequency)->stated.values.values, (*magnitude)->stated.values, phases);
    if (response.frequency_Hz.empty())
        return refused(
            {DYNCAL_TEXT("core",
                 "The list in line %1 of the certificate states no magnitude at any frequency (NaN only)."),
                {std::to_string(table.line)}});
    return response;
}

bool isOverFrequency(const StatedTable &table)
{
    return std::ranges::any_of(table.columns, [](const StatedQuantity &one) {
        return !one.isComplex() && one.stated.values.unit.isOf("Hz");
    });
}

std::vector<const StatedTable *> tablesOverFrequency(const DccContents &contents)
{
    std::vector<const StatedTable *> tables;
    for (const StatedTable &table : contents.tables)
        if (isOverFrequency(table))
            tables.push_back(&table);
    return tables;
}

} // namespace dyncal
