// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/dcc_contents.h"

#include "core/base/ascii_text.h"
#include "core/dcc_reading/dcc_quantities.h"
#include "core/dcc_reading/dcc_words_read.h"

#include <algorithm>
#include <array>

namespace dyncal {
namespace {

constexpr const char *kRoot = "digitalCalibrationCertificate";

/// An identification of an item.
struct Identification
{
    std::string issuer, value, name;
    std::vector<std::string> refTypes;
};

/// The schema wants a value where nothing is known: a hyphen, or the dash of this program.
bool isPlaceholder(const std::string &value)
{
    return value.empty() || value == "-" || value == "\xE2\x80\x93" || value == "\xE2\x80\x94";
}

std::vector<Identification> identificationsOf(const ParsedElement &item)
{
    std::vector<Identification> identifications;
    if (const ParsedElement *list = item.child("identifications"))
        for (const ParsedElement *one : list->all("identification"))
            if (!isPlaceholder(one->textAt({"value"})))
                identifications.push_back({one->textAt({"issuer"}), one->textAt({"value"}),
                    lowerCase(wordsOfText(one->child("name"))), wordsOfAttribute(*one, "refType")});
    return identifications;
}

bool isCalledSerial(const Identification &one)
{
    return std::ranges::any_of(std::array{"serial", "serien", "s/n"},
        [&](const char *word) { return one.name.find(word) != std::string::npos; });
}

/// The value of the only one of them; "" where it is none or several.
template <typename Test>
std::string valueOfOnly(const std::vector<Identification> &all, Test isMeant)
{
    const auto found = std::ranges::find_if(all, isMeant);
    const bool isOnly = std::ranges::count_if(all, isMeant) == 1;
    return isOnly ? found->value : std::string();
}

std::string serialOf(const std::vector<Identification> &all)
{
    const auto hasRefType = [](const Identification &one) {
        return std::ranges::find(one.refTypes, "basic_serialNumber") != one.refTypes.end();
    };
    std::string serial = valueOfOnly(all, hasRefType);
    if (serial.empty())
        serial = valueOfOnly(all, isCalledSerial);
    if (serial.empty())
        serial = valueOfOnly(
            all, [](const Identification &one) { return one.issuer == "manufacturer"; });
    return serial;
}

CalibratedItem itemOf(const ParsedElement &element)
{
    const std::vector<Identification> identifications = identificationsOf(element);
    CalibratedItem item{wordsOfText(element.child("name")),
        wordsOfText(element.at({"manufacturer", "name"})), element.textAt({"model"}),
        serialOf(identifications), {}};
    for (const Identification &one : identifications)
        item.numbers.push_back(one.value);
    return item;
}

void readAdministrativeData(const ParsedElement &data, DccContents &contents)
{
    contents.software = wordsOfText(data.at({"dccSoftware", "software", "name"}));
    contents.number = data.textAt({"coreData", "uniqueIdentifier"});
    contents.begun = data.textAt({"coreData", "beginPerformanceDate"});
    contents.ended = data.textAt({"coreData", "endPerformanceDate"});
    contents.issued = data.textAt({"coreData", "issueDate"});
    const auto stated = [](std::string text) { return isPlaceholder(text) ? std::string() : text; };
    contents.laboratory
        = stated(wordsOfText(data.at({"calibrationLaboratory", "contact", "name"})));
    contents.customer = stated(wordsOfText(data.at({"customer", "name"})));
    if (const ParsedElement *items = data.child("items"))
        for (const ParsedElement *item : items->all("item"))
            contents.items.push_back(itemOf(*item));
}

void readResults(const ParsedElement &root, DccContents &contents)
{
    const ParsedElement *all = root.child("measurementResults");
    if (!all)
        return;
    for (const ParsedElement *measurement : all->all("measurementResult"))
        if (const ParsedElement *results = measurement->child("results"))
            for (const ParsedElement *result : results->all("result"))
                readResult(*result, contents);
}

/// The namespaces of DCC and D-SI as their schemas and their users write them.
bool isOfCertificates(std::string_view address)
{
    for (const std::string_view begin : {"https://", "http://", "www."})
        if (address.starts_with(begin))
            address.remove_prefix(begin.size());
    if (address.ends_with('/'))
        address.remove_suffix(1);
    return address.empty() || address == "ptb.de/dcc" || address == "ptb.de/si";
}

Result<void> checkRoot(const ParsedElement &root)
{
    if (root.name != kRoot)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The file is XML, but no digital calibration certificate (it holds '%1'); give one, or a table as CSV."),
                {root.name}});
    const std::string version = root.attribute("schemaVersion");
    const bool isKnown = std::ranges::any_of(std::array{"3.0.", "3.1.", "3.2.", "3.3."},
        [&](const char *begin) { return version.starts_with(begin); });
    if (!isKnown)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The digital calibration certificate is of version '%1' (schemaVersion), and versions 3.0 to 3.3 are read; ask its laboratory for one of them."),
                {version}});
    return {};
}

} // namespace

bool StatedQuantity::hasRefType(std::string_view refType) const
{
    return std::ranges::find(refTypes, refType) != refTypes.end();
}

bool UnreadQuantity::hasRefType(std::string_view refType) const
{
    return std::ranges::find(refTypes, refType) != refTypes.end();
}

Result<DccContents> readDcc(std::string_view bytes)
{
    const Result<ParsedElement> root = readXml(bytes, isOfCertificates);
    if (!root)
        return tl::unexpected<Error>(root.error());
    if (const Result<void> checked = checkRoot(*root); !checked)
        return tl::unexpected<Error>(checked.error());
    DccContents contents{.version = root->attribute("schemaVersion")};
    if (const ParsedElement *data = root->child("administrativeData"))
        readAdministrativeData(*data, contents);
    readResults(*root, contents);
    return contents;
}

} // namespace dyncal
