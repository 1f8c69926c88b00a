// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/certified_sensor.h"

#include "core/base/ascii_text.h"
#include "core/base/constants.h"
#include "core/dcc_reading/own_certificate.h"

#include <algorithm>
#include <array>
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

template <std::size_t N>
bool isCalled(const StatedQuantity &quantity, const std::array<const char *, N> &words)
{
    const std::string name = lowerCase(quantity.name);
    return std::ranges::any_of(
        words, [&](const char *word) { return name.find(word) != std::string::npos; });
}

bool isInUnit(const StatedQuantity &one, const char *symbol)
{
    return one.stated.values.unit.symbol() == symbol;
}

const StatedQuantity *foreignSensitivity(const DccContents &contents)
{
    const auto isSensitivity
        = [](const StatedQuantity &one) { return one.stated.values.unit.isSensitivity(); };
    const Candidates all = singleOf(contents, isSensitivity);
    if (all.size() <= 1)
        return onlyOf(all);
    return onlyOf(singleOf(contents, [&](const StatedQuantity &one) {
        return isSensitivity(one) && one.hasRefType("basic_measuredValue");
    }));
}

const StatedQuantity *foreignNaturalFrequency(const DccContents &contents)
{
    constexpr std::array kWords{"natural frequency", "eigenfrequen"};
    return onlyOf(singleOf(contents,
        [&](const StatedQuantity &one) { return isInUnit(one, "Hz") && isCalled(one, kWords); }));
}

const StatedQuantity *foreignDampingRatio(const DccContents &contents)
{
    constexpr std::array kWords{"damping ratio", "d\xC3\xA4mpfungsgrad"};
    return onlyOf(singleOf(contents,
        [&](const StatedQuantity &one) { return isInUnit(one, "1") && isCalled(one, kWords); }));
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
                     "The result '%1' in line %2 is not known as sensitivity, natural frequency or damping ratio, or is not the only one."),
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

/// The only list that is a response; the others with their reasons.
void readForeignTables(const DccContents &contents, CertifiedSensor &sensor)
{
    std::vector<const StatedTable *> responses;
    for (const StatedTable &table : contents.tables) {
        const Result<CertifiedResponse> response = responseOf(table, std::nullopt);
        if (response)
            responses.push_back(&table);
        else
            leaveOut(table, response.error().message, sensor);
    }
    if (responses.size() > 1)
        return leaveOutAsSeveral(responses, sensor);
    if (responses.empty())
        return;
    sensor.response = *responseOf(*responses.front(), std::nullopt);
    append(sensor.leftOut, sensor.response->notUnderstood);
}

void readOwnTables(const DccContents &contents, CertifiedSensor &sensor)
{
    const std::vector<const StatedTable *> responses = ownResponses(contents);
    if (responses.size() > 1)
        return leaveOutAsSeveral(responses, sensor);
    if (responses.empty())
        return;
    Result<CertifiedResponse> response = responseOf(*responses.front(), std::nullopt);
    if (!response)
        return leaveOut(*responses.front(), response.error().message, sensor);
    append(sensor.leftOut, response->notUnderstood);
    sensor.response = std::move(*response);
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
    take(foreignNaturalFrequency(contents), sensor.naturalFrequency, taken);
    take(foreignDampingRatio(contents), sensor.dampingRatio, taken);
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
