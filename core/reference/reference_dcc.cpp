// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_dcc.h"

#include "core/dcc_reading/dcc_response.h"
#include "core/dcc_reading/own_certificate.h"

#include <algorithm>
#include <utility>

namespace dyncal {
namespace {

tl::unexpected<Error> refused(Message message)
{
    return fail(ErrorKind::Usage, std::move(message));
}

/// Of several those that are a response in this unit; of a certificate of this program, which has
/// its response several times, the one with all digits.
std::vector<const StatedTable *> usable(const DccContents &contents,
    const std::vector<const StatedTable *> &tables, const DSiUnit &unit)
{
    if (isOwnCertificate(contents))
        return ownResponses(contents);
    std::vector<const StatedTable *> found;
    for (const StatedTable *table : tables)
        if (responseOf(*table, unit))
            found.push_back(table);
    return found;
}

/// Those beside `found` that may be the response in this unit, were they understood.
std::vector<const StatedTable *> possible(
    const DccContents &contents, const std::vector<const StatedTable *> &found, const DSiUnit &unit)
{
    std::vector<const StatedTable *> tables;
    for (const StatedTable &table : contents.tables)
        if (std::ranges::find(found, &table) == found.end() && mightBeResponse(table, unit))
            tables.push_back(&table);
    return tables;
}

/// The only one that is, or may be, a response in this unit.
Result<const StatedTable *> onlyTable(const DccContents &contents, const DSiUnit &unit)
{
    const std::vector<const StatedTable *> all = tablesOverFrequency(contents);
    const std::vector<const StatedTable *> found
        = all.size() > 1 ? usable(contents, all, unit) : all;
    const std::vector<const StatedTable *> others = isOwnCertificate(contents)
        ? std::vector<const StatedTable *>()
        : possible(contents, found, unit);
    if (found.size() + others.size() == 1)
        return found.empty() ? others.front() : found.front();
    if (found.size() == 1)
        return refused(
            {DYNCAL_TEXT("core",
                 "The certificate has another list (line %1) that is not understood and may be the response; name the one that is meant by its id in quantity_id."),
                {std::to_string(others.front()->line)}, others.front()->notUnderstood});
    return refused(
        {DYNCAL_TEXT("core",
             "The certificate has %1 lists over frequency; name the one that is meant by its id in quantity_id."),
            {std::to_string(all.size())}});
}

/// The list that is meant.
Result<const StatedTable *> tableOf(
    const DccContents &contents, const std::string &id, const DSiUnit &unit)
{
    if (id.empty())
        return onlyTable(contents, unit);
    std::vector<const StatedTable *> named;
    for (const StatedTable &table : contents.tables)
        if (table.id == id)
            named.push_back(&table);
    if (named.size() == 1)
        return named.front();
    return refused({DYNCAL_TEXT("core",
                        "The certificate has no list with the id '%1' of quantity_id, or several."),
        {id}});
}

Result<std::vector<ReferencePoint>> rowsOf(
    const CertifiedResponse &response, const std::string &unit, double factor)
{
    const auto isWhole
        = [&](const StatedValues &one) { return one.u.size() == response.frequency_Hz.size(); };
    if (!isWhole(response.magnitude) || (response.phase_rad && !isWhole(*response.phase_rad)))
        return refused(
            {DYNCAL_TEXT("core",
                 "The list of the certificate needs frequencies, magnitudes in %1 and perhaps phases, as many of each, with expanded uncertainties and their coverage factors."),
                {unit}, response.notUnderstood});
    std::vector<ReferencePoint> rows;
    for (std::size_t i = 0; i < response.frequency_Hz.size(); ++i) {
        rows.push_back({response.frequency_Hz[i], response.magnitude.values[i] / factor,
            response.magnitude.u[i] / factor});
        rows.back().dof = response.dof[i];
        if (response.phase_rad) {
            rows.back().phase_rad = response.phase_rad->values[i];
            rows.back().u_phase_rad = response.phase_rad->u[i];
        }
    }
    return rows;
}

Result<ReferenceSensitivity> sensitivityOf(
    const DccContents &contents, const std::string &id, const std::string &unitText)
{
    const std::optional<DSiUnit> unit = unitOfSymbol(unitText);
    if (!unit)
        return refused(
            {DYNCAL_TEXT("core",
                 "The unit '%1' is none that a certificate can be read in; one such as V/Pa, pC/Pa or 1 is needed."),
                {unitText}});
    const Result<const StatedTable *> table = tableOf(contents, id, *unit);
    if (!table)
        return tl::unexpected<Error>(table.error());
    const Result<CertifiedResponse> response = responseOf(**table, *unit);
    if (!response)
        return tl::unexpected<Error>(response.error());
    if (response->whyNoPhases) // without them it would be another reference
        return refused(*response->whyNoPhases);
    Result<std::vector<ReferencePoint>> rows = rowsOf(*response, unitText, unit->factor);
    if (!rows)
        return tl::unexpected<Error>(rows.error());
    return ReferenceSensitivity::fromTable(std::move(*rows));
}

} // namespace

std::vector<std::string> listsOverFrequency(const std::string &xml)
{
    std::vector<std::string> ids;
    if (const Result<DccContents> contents = readDcc(xml))
        for (const StatedTable *table : tablesOverFrequency(*contents))
            ids.push_back(table->id);
    return ids;
}

Result<CertifiedReference> readReferenceDcc(
    const std::string &xml, const std::string &quantityId, const std::string &unit)
{
    const Result<DccContents> contents = readDcc(xml);
    if (!contents)
        return tl::unexpected<Error>(contents.error());
    return sensitivityOf(*contents, quantityId, unit).map([&](ReferenceSensitivity sensitivity) {
        return CertifiedReference{std::move(sensitivity), contents->number};
    });
}

} // namespace dyncal
