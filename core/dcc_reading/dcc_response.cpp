// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_response.h"

#include "core/base/ascii_text.h"
#include "core/base/constants.h"
#include "core/base/propagation.h"
#include "core/dcc_reading/meant_quantity.h"
#include "core/dcc_reading/quantity_names.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

using Candidates = std::vector<const StatedQuantity *>;

tl::unexpected<Error> refused(Message message)
{
    return fail(ErrorKind::Usage, std::move(message));
}

template <typename Quantity>
std::string linesOf(const std::vector<const Quantity *> &all)
{
    std::vector<std::string> lines;
    lines.reserve(all.size());
    for (const Quantity *one : all)
        lines.push_back(std::to_string(one->line));
    return commaList(lines);
}

/// What of the list is not understood, and what is about the values that are asked for.
std::vector<Message> reasonsOf(const StatedTable &table, const Candidates &about)
{
    std::vector<Message> reasons = table.notUnderstood;
    for (const StatedQuantity *one : about)
        reasons.push_back(
            {DYNCAL_TEXT("core",
                 "The quantity '%1' in line %2 is by its name or its refType no such value but one about it (an error, an uncertainty, a limit, a nominal value)."),
                {one->name, std::to_string(one->line)}});
    return reasons;
}

/// What may be missing of a list. The texts begin with the line of the list, place %1; place %2 has
/// the lines of the quantities.
struct RoleTexts
{
    const char *none, *several, *unread;
};

Message whyNone(const StatedTable &table, const RoleTexts &texts, const MeantQuantity &found,
    const std::string &unit = {})
{
    const bool isUnread = !found.unread.empty();
    const char *text = isUnread ? texts.unread : texts.several;
    return {found.inUnit.empty() ? texts.none : text,
        {std::to_string(table.line), isUnread ? linesOf(found.unread) : linesOf(found.inUnit),
            unit},
        reasonsOf(table, found.about)};
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
constexpr const char *kUnreadFrequencies = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has a quantity (line %2) that is not understood and may be the frequencies, so no other is taken for them; its laboratory must correct it.");
constexpr const char *kUnreadMagnitudes = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has a quantity (line %2) that is not understood and may be the magnitudes, so no other is taken for them; its laboratory must correct it.");
constexpr const char *kUnreadPhases = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has a quantity (line %2) that is not understood and may be the phases, so none are taken; its laboratory must correct it.");
constexpr const char *kSeveralPhases = DYNCAL_TEXT("core",
    "The list in line %1 of the certificate has several angles (lines %2), and which of them are the phases is not guessed; its laboratory must mark them by a refType.");

QuantityRole frequencies()
{
    return {[](const DSiUnit &unit) { return unit.isOf("Hz"); },
        {"dyncal_frequency", "vib_frequency", "basic_tableIndex0"}, true, false, isAboutAFrequency};
}

QuantityRole magnitudes(const std::optional<DSiUnit> &unit)
{
    return {[unit](const DSiUnit &its) {
                return unit ? its.powers == unit->powers : its.isSensitivity();
            },
        {"dyncal_magnitude", "vib_magnitude", "basic_measuredValue"}, false, true, isAboutAValue};
}

QuantityRole phases()
{
    return {[](const DSiUnit &unit) { return unit.isOf("rad"); },
        {"dyncal_phase", "vib_phase", "basic_measuredValue"}, true, false, isAboutAValue};
}

Result<const StatedQuantity *> frequencyOf(const StatedTable &table)
{
    const MeantQuantity found = meantQuantity(table, frequencies());
    if (!found.meant)
        return refused(
            whyNone(table, {kNoFrequencies, kSeveralFrequencies, kUnreadFrequencies}, found));
    return found.meant;
}

Result<const StatedQuantity *> magnitudeOf(
    const StatedTable &table, const std::optional<DSiUnit> &unit)
{
    const MeantQuantity found = meantQuantity(table, magnitudes(unit));
    if (!found.meant)
        return refused(whyNone(table,
            {unit ? kNoneInUnit : kNoMagnitudes, kSeveralMagnitudes, kUnreadMagnitudes}, found,
            unit ? unit->symbol() : ""));
    return found.meant;
}

/// The phases beside real magnitudes, if there are any.
struct FoundPhases
{
    const StatedQuantity *found = nullptr;
    std::optional<Message> whyNone = {}; ///< where one that is not understood may be them
};

Result<FoundPhases> phasesOf(const StatedTable &table)
{
    const MeantQuantity found = meantQuantity(table, phases());
    if (found.meant || (found.inUnit.empty() && found.unread.empty()))
        return FoundPhases{found.meant, {}};
    Message why = whyNone(table, {kUnreadPhases, kSeveralPhases, kUnreadPhases}, found);
    if (found.unread.empty())
        return refused(std::move(why));
    return FoundPhases{nullptr, std::move(why)};
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
    const Result<const StatedQuantity *> frequency = frequencyOf(table);
    if (!frequency)
        return tl::unexpected<Error>(frequency.error());
    const Result<const StatedQuantity *> magnitude = magnitudeOf(table, unit);
    if (!magnitude)
        return tl::unexpected<Error>(magnitude.error());
    const bool isComplex = (*magnitude)->isComplex();
    const Result<FoundPhases> beside = isComplex ? FoundPhases{} : phasesOf(table);
    if (!beside)
        return tl::unexpected<Error>(beside.error());
    Candidates used{*frequency, *magnitude};
    const StatedValues *phases = isComplex ? &*(*magnitude)->stated.phases_rad : nullptr;
    if (beside->found) {
        used.push_back(beside->found);
        phases = &beside->found->stated.values;
    }
    if (const Result<void> lengths = checkLengths(table, used); !lengths)
        return tl::unexpected<Error>(lengths.error());
    CertifiedResponse response = responseFrom(
        table, (*frequency)->stated.values.values, (*magnitude)->stated.values, phases);
    response.whyNoPhases = beside->whyNone;
    if (response.frequency_Hz.empty())
        return refused(
            {DYNCAL_TEXT("core",
                 "The list in line %1 of the certificate states no magnitude at any frequency (NaN only)."),
                {std::to_string(table.line)}});
    return response;
}

bool mightBeResponse(const StatedTable &table, const std::optional<DSiUnit> &unit)
{
    const auto isKnown = [&](const QuantityRole &role) {
        const auto isIn = [&](const UnreadQuantity &one) { return one.unit && mayBe(one, role); };
        return !meantQuantity(table, role).inUnit.empty()
            || std::ranges::any_of(table.unread, isIn);
    };
    const auto isPossible = [&](const QuantityRole &role) {
        return isKnown(role) || !meantQuantity(table, role).unread.empty();
    };
    const QuantityRole ofFrequencies = frequencies(), ofMagnitudes = magnitudes(unit);
    return !table.unread.empty() && isPossible(ofFrequencies) && isPossible(ofMagnitudes)
        && (isKnown(ofFrequencies) || isKnown(ofMagnitudes)) && !responseOf(table, unit);
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
