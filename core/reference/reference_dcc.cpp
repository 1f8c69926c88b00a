// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/reference/reference_dcc.h"

#include "core/base/number_text.h"
#include "core/reference/d_si_unit.h"

#include <pugixml.hpp>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace dyncal {
namespace {

/// Behind the prefix of its namespace, which every writer chooses for itself.
std::string_view localName(const pugi::xml_node &node)
{
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == name.npos ? name : name.substr(colon + 1);
}

pugi::xml_node firstBelow(const pugi::xml_node &node, std::string_view name)
{
    return node.find_node([=](const pugi::xml_node &at) { return localName(at) == name; });
}

std::vector<pugi::xml_node> allBelow(const pugi::xml_node &node, std::string_view name)
{
    struct Walker : pugi::xml_tree_walker // a file may be nested deeper than a stack is
    {
        std::string_view name;
        std::vector<pugi::xml_node> found;

        bool for_each(pugi::xml_node &at) override
        {
            if (localName(at) == name)
                found.push_back(at);
            return true;
        }
    };
    Walker walker;
    walker.name = name;
    pugi::xml_node start = node;
    start.traverse(walker);
    return walker.found;
}

std::vector<std::string> wordsOf(const pugi::xml_node &node)
{
    std::vector<std::string> words;
    const std::string text = node.child_value();
    constexpr const char *kBlank = " \t\r\n";
    for (std::size_t at = text.find_first_not_of(kBlank); at != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
        words.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(kBlank, end);
    }
    return words;
}

/// Numbers of a list; empty where one is none. A single one stands for all `count`.
std::vector<double> numbersOf(const pugi::xml_node &node, std::size_t count)
{
    std::vector<double> values;
    for (const std::string &word : wordsOf(node)) {
        const std::optional<double> value = parseNumber(word);
        if (!value)
            return {};
        values.push_back(*value);
    }
    if (values.size() == 1)
        values.resize(count, values.front());
    return values;
}

/// One quantity of a list, without prefixes.
struct ListedQuantity
{
    std::string unit;
    std::vector<double> values;
    std::vector<double> u; ///< empty without an uncertainty
};

std::optional<ListedQuantity> quantityOf(const pugi::xml_node &node)
{
    const std::vector<std::string> units = wordsOf(firstBelow(node, "unitXMLList"));
    const std::size_t count = wordsOf(firstBelow(node, "valueXMLList")).size();
    // One for all, or one for each, which must then be the same.
    const bool isOne = !units.empty()
        && std::ranges::all_of(units, [&](const auto &unit) { return unit == units.front(); });
    const std::optional<DSiUnit> unit = isOne ? parseDSiUnit(units.front()) : std::nullopt;
    if (!unit)
        return std::nullopt;
    ListedQuantity quantity{unit->symbol(), numbersOf(firstBelow(node, "valueXMLList"), count), {}};
    std::vector<double> U = numbersOf(firstBelow(node, "valueExpandedMUXMLList"), count);
    const std::vector<double> k = numbersOf(firstBelow(node, "coverageFactorXMLList"), count);
    for (double &value : quantity.values)
        value *= unit->factor;
    if (U.size() == count && k.size() == count)
        for (std::size_t i = 0; i < count; ++i)
            quantity.u.push_back(U[i] * unit->factor / k[i]);
    return quantity;
}

std::vector<ListedQuantity> quantitiesOf(const pugi::xml_node &list)
{
    std::vector<ListedQuantity> quantities;
    for (const pugi::xml_node &node : allBelow(list, "quantity"))
        if (auto quantity = quantityOf(node))
            quantities.push_back(std::move(*quantity));
    return quantities;
}

const ListedQuantity *inUnit(const std::vector<ListedQuantity> &list, std::string_view unit)
{
    const auto found = std::ranges::find(list, unit, &ListedQuantity::unit);
    return found == list.end() ? nullptr : &*found;
}

tl::unexpected<Error> refused(Message message)
{
    return fail(ErrorKind::Usage, std::move(message));
}

bool isOverFrequency(const pugi::xml_node &list)
{
    return inUnit(quantitiesOf(list), "Hz") != nullptr;
}

/// The list that is meant.
Result<pugi::xml_node> listOf(const pugi::xml_document &document, const std::string &id)
{
    std::vector<pugi::xml_node> found;
    for (const pugi::xml_node &list : allBelow(document, "list")) {
        const bool isMeant
            = id.empty() ? isOverFrequency(list) : list.attribute("id").value() == id;
        if (isMeant)
            found.push_back(list);
    }
    if (found.size() == 1)
        return found.front();
    if (id.empty())
        return refused(
            {DYNCAL_TEXT("core",
                 "The certificate has %1 lists over frequency; name the one that is meant by its id in quantity_id."),
                {std::to_string(found.size())}});
    return refused({DYNCAL_TEXT("core",
                        "The certificate has no list with the id '%1' of quantity_id, or several."),
        {id}});
}

Result<std::vector<ReferencePoint>> rowsOfList(
    const std::vector<ListedQuantity> &list, const std::string &unit)
{
    const ListedQuantity *f = inUnit(list, "Hz"), *S = inUnit(list, unit),
                         *phase = inUnit(list, "rad");
    const std::size_t count = f ? f->values.size() : 0;
    const auto isWhole = [count](const ListedQuantity *one) {
        return one && one->values.size() == count && one->u.size() == count;
    };
    if (!isWhole(S) || (phase && !isWhole(phase)))
        return refused(
            {DYNCAL_TEXT("core",
                 "The list of the certificate needs frequencies, magnitudes in %1 and perhaps phases, as many of each, with expanded uncertainties and their coverage factors."),
                {unit}});
    std::vector<ReferencePoint> rows;
    for (std::size_t i = 0; i < count; ++i) {
        rows.push_back({f->values[i], S->values[i], S->u[i]});
        if (phase) {
            rows.back().phase_rad = phase->values[i];
            rows.back().u_phase_rad = phase->u[i];
        }
    }
    return rows;
}

} // namespace

std::vector<std::string> listsOverFrequency(const std::string &xml)
{
    pugi::xml_document document;
    std::vector<std::string> ids;
    if (!document.load_buffer(xml.data(), xml.size()))
        return ids;
    for (const pugi::xml_node &list : allBelow(document, "list"))
        if (isOverFrequency(list))
            ids.emplace_back(list.attribute("id").value());
    return ids;
}

Result<CertifiedReference> readReferenceDcc(
    const std::string &xml, const std::string &quantityId, const std::string &unit)
{
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
    if (!parsed || localName(document.document_element()) != "digitalCalibrationCertificate")
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The file is XML, but no digital calibration certificate (%1); give that, or a table as CSV."),
                {parsed ? document.document_element().name() : parsed.description()}});
    const Result<pugi::xml_node> list = listOf(document, quantityId);
    if (!list)
        return tl::unexpected(list.error());
    Result<std::vector<ReferencePoint>> rows = rowsOfList(quantitiesOf(*list), unit);
    if (!rows)
        return tl::unexpected(rows.error());
    auto sensitivity = ReferenceSensitivity::fromTable(std::move(*rows));
    if (!sensitivity)
        return tl::unexpected(sensitivity.error());
    return CertifiedReference{
        std::move(*sensitivity), firstBelow(document, "uniqueIdentifier").child_value()};
}

} // namespace dyncal
