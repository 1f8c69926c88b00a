// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/certified_sensor.h"

#include "core/base/ascii_text.h"
#include "core/base/constants.h"
#include "core/base/number_text.h"
#include "core/dcc_reading/own_certificate.h"
#include "core/dcc_reading/quantity_names.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace dyncal {
namespace {

using Candidates = std::vector<const StatedQuantity *>;

void setSerial(const DccContents &contents, CertifiedSensor &sensor)
{
    std::vector<std::string> serials;
    for (const CalibratedItem &item : contents.items)
        if (!item.serial.empty())
            serials.push_back(item.serial);
    if (serials.size() == 1)
        sensor.serial = serials.front();
    else if (serials.empty())
        sensor.whyNoSerial = {
            DYNCAL_TEXT("core",
                "The certificate states no serial number of its item, or not which of its numbers that is."),
            {}};
    else
        sensor.whyNoSerial = {
            DYNCAL_TEXT("core",
                "The certificate is of several items (%1), and it is not said which of them the results are of."),
            {commaList(serials)}};
}

CertifiedValue valueOf(const StatedQuantity &quantity)
{
    const StatedValues &stated = quantity.stated.values;
    const bool hasU = !stated.u.empty();
    return {quantity.name, quantity.line, stated.unit.symbol(), stated.values.front(),
        hasU ? stated.u.front() : kUnknown, hasU ? stated.k.front() : kUnknown};
}

/// A single real number.
bool isScalar(const StatedQuantity &one)
{
    return !one.isComplex() && one.stated.values.values.size() == 1;
}

Candidates singleOf(
    const DccContents &contents, const std::function<bool(const StatedQuantity &)> &isMeant)
{
    Candidates meant;
    for (const StatedQuantity &one : contents.single)
        if (isScalar(one) && isMeant(one))
            meant.push_back(&one);
    return meant;
}

const StatedQuantity *onlyOf(const Candidates &candidates)
{
    return candidates.size() == 1 ? candidates.front() : nullptr;
}

bool isInUnit(const StatedQuantity &one, const char *symbol)
{
    return one.stated.values.unit.symbol() == symbol;
}

const std::vector<std::string_view> kSensitivity{
    "sensitivity", "empfindlichkeit", "k\xC3\xA4nslighet"};
const std::vector<std::string_view> kNaturalFrequency{
    "natural frequency", "eigenfrequenz", "eigenfrequency"};
const std::vector<std::string_view> kDampingRatio{"damping ratio", "d\xC3\xA4mpfungsgrad"};

bool isSensitivity(const StatedQuantity &one)
{
    return one.stated.values.unit.isSensitivity() && !isAboutAValue(one.name, one.refTypes);
}

bool mayBeSensitivity(const UnreadQuantity &one)
{
    const bool isInUnit = one.unit ? one.unit->isSensitivity() : isCalled(one.name, kSensitivity);
    return isInUnit && !isAboutAValue(one.name, one.refTypes);
}

bool isMeasured(const UnreadQuantity &one)
{
    return mayBeSensitivity(one) && one.hasRefType("basic_measuredValue");
}

const StatedQuantity *foreignSensitivity(const DccContents &contents)
{
    const Candidates all = singleOf(contents, isSensitivity);
    if (all.size() <= 1 && std::ranges::none_of(contents.unread, mayBeSensitivity))
        return onlyOf(all);
    if (std::ranges::any_of(contents.unread, isMeasured))
        return nullptr;
    return onlyOf(singleOf(contents, [&](const StatedQuantity &one) {
        return isSensitivity(one) && one.hasRefType("basic_measuredValue");
    }));
}

/// The only one in this unit that is called so; none where another is called so that is not
/// understood.
const StatedQuantity *foreignCalled(
    const DccContents &contents, const char *symbol, const std::vector<std::string_view> &words)
{
    const auto isMeant = [&](const auto &one) {
        return isCalled(one.name, words) && !isAboutAValue(one.name, one.refTypes);
    };
    if (std::ranges::any_of(contents.unread, isMeant))
        return nullptr;
    return onlyOf(singleOf(contents,
        [&](const StatedQuantity &one) { return isInUnit(one, symbol) && isMeant(one); }));
}

/// Takes what is there over; what it was is remembered.
void take(const StatedQuantity *quantity, std::optional<CertifiedValue> &value, Candidates &taken)
{
    if (!quantity)
        return;
    value = valueOf(*quantity);
    taken.push_back(quantity);
}

void leaveOutOthers(const DccContents &contents, const Candidates &taken, CertifiedSensor &sensor)
{
    for (const StatedQuantity &one : contents.single)
        if (std::ranges::find(taken, &one) == taken.end())
            sensor.leftOut.push_back(
                {DYNCAL_TEXT("core",
                     "The result '%1' in line %2 is not known as sensitivity, natural frequency or damping ratio, or is not the only one that may be it."),
                    {one.name, std::to_string(one.line)}});
}

void append(std::vector<Message> &to, const std::vector<Message> &more)
{
    to.insert(to.end(), more.begin(), more.end());
}

void leaveOut(const StatedTable &table, Message reason, CertifiedSensor &sensor)
{
    // Where the reasons are those of its quantities, they are told once.
    sensor.leftOut.push_back(std::move(reason));
    if (sensor.leftOut.back().below.empty())
        append(sensor.leftOut, table.notUnderstood);
}

void leaveOutAsSeveral(const std::vector<const StatedTable *> &tables, CertifiedSensor &sensor)
{
    for (const StatedTable *table : tables)
        leaveOut(*table,
            {DYNCAL_TEXT("core",
                 "The list in line %1 is a response over frequency, but so is another, and which is meant is not guessed."),
                {std::to_string(table->line)}},
            sensor);
}

/// What no sensor has: a frequency twice, or a magnitude that is not above 0.
Result<void> checkRows(const StatedTable &table, const CertifiedResponse &response)
{
    constexpr double kRounding = 1e-9; // of one frequency in two units
    const auto refused = [&](const char *text, std::size_t row) {
        return fail(ErrorKind::Usage,
            {text,
                {std::to_string(table.line), numberText(response.frequency_Hz[row], 6),
                    numberText(response.magnitude.values[row], 6)}});
    };
    std::vector<double> sorted = response.frequency_Hz;
    std::ranges::sort(sorted);
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i] <= sorted[i - 1] * (1.0 + kRounding))
            return refused(
                DYNCAL_TEXT("core",
                    "The list in line %1 of the certificate has the frequency %2 Hz more than once, and which of its rows is meant is not guessed."),
                static_cast<std::size_t>(std::ranges::find(response.frequency_Hz, sorted[i])
                    - response.frequency_Hz.begin()));
    const auto low = std::ranges::find_if(
        response.magnitude.values, [](double magnitude) { return !(magnitude > 0.0); });
    if (low == response.magnitude.values.end())
        return {};
    return refused(
        DYNCAL_TEXT("core",
            "The list in line %1 of the certificate has the magnitude %3 at %2 Hz; one above 0 is needed, with the sign in the phase."),
        static_cast<std::size_t>(low - response.magnitude.values.begin()));
}

Result<CertifiedResponse> soundResponse(const StatedTable &table)
{
    return responseOf(table, std::nullopt)
        .and_then([&](CertifiedResponse response) -> Result<CertifiedResponse> {
            if (const Result<void> rows = checkRows(table, response); !rows)
                return tl::unexpected<Error>(rows.error());
            return response;
        });
}

void take(CertifiedResponse response, CertifiedSensor &sensor)
{
    // The reason for missing phases has those of the quantities.
    if (response.whyNoPhases)
        sensor.leftOut.push_back(*response.whyNoPhases);
    else
        append(sensor.leftOut, response.notUnderstood);
    sensor.response = std::move(response);
}

/// The only list that is a response, where no other may be one; the others with their reasons.
void readForeignTables(const DccContents &contents, CertifiedSensor &sensor)
{
    std::vector<const StatedTable *> responses;
    const StatedTable *possible = nullptr;
    for (const StatedTable &table : contents.tables) {
        const Result<CertifiedResponse> response = soundResponse(table);
        if (response)
            responses.push_back(&table);
        else
            leaveOut(table, response.error().message, sensor);
        if (!response && mightBeResponse(table, std::nullopt))
            possible = &table;
    }
    if (responses.size() > 1)
        return leaveOutAsSeveral(responses, sensor);
    if (responses.empty())
        return;
    if (possible)
        return leaveOut(*responses.front(),
            {DYNCAL_TEXT("core",
                 "The list in line %1 is a response over frequency, but that in line %2, which is not understood, may be the one that is meant, so it is not taken."),
                {std::to_string(responses.front()->line), std::to_string(possible->line)}},
            sensor);
    take(*soundResponse(*responses.front()), sensor);
}

void readOwnTables(const DccContents &contents, CertifiedSensor &sensor)
{
    const std::vector<const StatedTable *> responses = ownResponses(contents);
    if (responses.size() > 1)
        return leaveOutAsSeveral(responses, sensor);
    if (responses.empty())
        return;
    Result<CertifiedResponse> response = soundResponse(*responses.front());
    if (!response)
        return leaveOut(*responses.front(), response.error().message, sensor);
    take(std::move(*response), sensor);
}

void readOwn(const DccContents &contents, CertifiedSensor &sensor)
{
    Candidates taken;
    take(ownValue(contents, "dyncal_sensitivity"), sensor.sensitivity, taken);
    take(ownValue(contents, "dyncal_naturalFrequency"), sensor.naturalFrequency, taken);
    take(ownValue(contents, "dyncal_dampingRatio"), sensor.dampingRatio, taken);
    sensor.recordings = ownRecordings(contents);
    readOwnTables(contents, sensor);
}

void readForeign(const DccContents &contents, CertifiedSensor &sensor)
{
    Candidates taken;
    take(foreignSensitivity(contents), sensor.sensitivity, taken);
    take(foreignCalled(contents, "Hz", kNaturalFrequency), sensor.naturalFrequency, taken);
    take(foreignCalled(contents, "1", kDampingRatio), sensor.dampingRatio, taken);
    leaveOutOthers(contents, taken, sensor);
    readForeignTables(contents, sensor);
}

} // namespace

CertifiedSensor certifiedSensor(const DccContents &contents)
{
    CertifiedSensor sensor;
    setSerial(contents, sensor);
    append(sensor.leftOut, contents.notUnderstood);
    if (isOwnCertificate(contents))
        readOwn(contents, sensor);
    else
        readForeign(contents, sensor);
    if (sensor.response && sensor.response->withoutValue > 0)
        sensor.leftOut.push_back(
            {DYNCAL_TEXT("core", "%1 rows of the response over frequency state no value (NaN)."),
                {std::to_string(sensor.response->withoutValue)}});
    return sensor;
}

} // namespace dyncal
