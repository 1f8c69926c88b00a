// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_sections.h"

#include "core/dcc/dcc_fields.h"

#include <algorithm>
#include <string_view>

namespace dyncal {
namespace {

/// What a column of a table is, by its heading.
enum class ColumnRole { Words, Number, Expanded, Factor };

ColumnRole roleOf(const CertificateColumn &column)
{
    const std::string_view heading = column.heading.text;
    if (heading == "U" || heading.starts_with("U (") || heading.starts_with("U of"))
        return ColumnRole::Expanded;
    if (heading == "k")
        return ColumnRole::Factor;
    return column.number ? ColumnRole::Number : ColumnRole::Words;
}

/// "f0_hz" of the table of a quantity's earlier calibrations; "" of all others.
std::string_view followedIn(const CertificateTable &table)
{
    constexpr std::string_view kBegin = "history-";
    const std::string_view id = table.id;
    return id.starts_with(kBegin) ? id.substr(kBegin.size()) : std::string_view();
}

/// Where a table stands in the table of fields.
std::string placeOf(const CertificateTable &table)
{
    const std::string_view followed = followedIn(table);
    return followed.empty() ? table.id : std::string("history/").append(followed);
}

/// The same of a column; those of all earlier calibrations are alike.
std::string placeOf(const CertificateTable &table, const CertificateColumn &column)
{
    const std::string place = followedIn(table).empty() ? table.id : "history";
    return place + "/" + column.heading.text;
}

bool isDash(const Message &cell)
{
    return english(cell) == "\xE2\x80\x93";
}

/// A marked frequency has words around its number; no other column has.
std::optional<PrintedValue> markedFrequency(const Message &cell)
{
    const std::string_view text = cell.text;
    const bool isMarked = text.find("%L1") != text.npos || text == "%1: %V2";
    return isMarked && !cell.arguments.empty() ? printedValue(cell.arguments.front())
                                               : std::nullopt;
}

bool isFrequencyColumn(const CertificateTable &table, std::size_t column)
{
    return table.id == "frequency-response" && column == 0;
}

/// Units of values that are none are those of the others, so that one unit can stand for all.
void fillUnits(DccColumn &column)
{
    const auto known
        = std::ranges::find_if(column.units, [](const auto &unit) { return !unit.empty(); });
    const std::string unit = known == column.units.end() ? "\\one" : *known;
    std::ranges::replace(column.units, std::string(), unit);
}

DccColumn columnOf(const CertificateTable &table, std::size_t at)
{
    const CertificateColumn &heading = table.columns[at];
    DccColumn column{heading.heading, refTypeOf(placeOf(table, heading))};
    const bool isNumber = roleOf(heading) == ColumnRole::Number;
    bool hasValue = false, hasWords = !isNumber;
    for (const std::vector<Message> &row : table.rows) {
        const Message &cell = row[at];
        auto printed = isNumber ? printedValue(cell) : std::nullopt;
        const bool isSaid = !printed && !isDash(cell);
        if (isNumber && !printed && isFrequencyColumn(table, at))
            printed = markedFrequency(cell);
        const PrintedValue value = printed.value_or(PrintedValue{kDccNone, {}});
        column.values.push_back(value.value);
        column.units.push_back(value.unit);
        column.expanded.push_back(value.expanded.empty() ? kDccNone : value.expanded);
        column.factors.push_back(value.expanded.empty() ? kDccNone : dccFactor(value.factor));
        column.words.push_back(isSaid || !isNumber ? cell : Message{"%1", {"\xE2\x80\x93"}});
        hasValue = hasValue || printed;
        hasWords = hasWords || isSaid;
    }
    if (!hasValue)
        column.values.clear();
    if (!hasWords)
        column.words.clear();
    fillUnits(column);
    return column;
}

/// Drops a U that no value has.
void tidy(DccColumn &column)
{
    if (std::ranges::all_of(column.expanded, [](const auto &u) { return u == kDccNone; })) {
        column.expanded.clear();
        column.factors.clear();
    }
}

/// U of a column goes to the values before it; k, where no cell says another, is 2.
void takeExpanded(const CertificateTable &table, std::size_t at, DccColumn &column)
{
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto printed = printedValue(table.rows[i][at]);
        if (!printed || i >= column.values.size() || printed->unit != column.units[i])
            continue;
        column.expanded[i] = printed->value;
        column.factors[i] = printed->factor.empty() ? "2" : dccFactor(printed->factor);
    }
}

void takeFactors(const CertificateTable &table, std::size_t at, DccColumn &column)
{
    for (std::size_t i = 0; i < table.rows.size() && i < column.factors.size(); ++i)
        if (const auto printed = printedValue(table.rows[i][at]);
            printed && column.expanded[i] != kDccNone)
            column.factors[i] = dccFactor(printed->value);
}

std::vector<DccColumn> columnsOf(const CertificateTable &table)
{
    std::vector<DccColumn> columns;
    std::size_t number = 0; // the last column of numbers
    for (std::size_t at = 0; at < table.columns.size(); ++at) {
        const ColumnRole role = roleOf(table.columns[at]);
        if (role == ColumnRole::Expanded && !columns.empty()) {
            takeExpanded(table, at, columns[number]);
        } else if (role == ColumnRole::Factor && !columns.empty()) {
            takeFactors(table, at, columns[number]);
        } else {
            columns.push_back(columnOf(table, at));
            number = role == ColumnRole::Number ? columns.size() - 1 : number;
        }
    }
    std::ranges::for_each(columns, tidy);
    return columns;
}

void addText(const DccWords &words, const std::vector<Message> &sentences, XmlElement &data)
{
    if (!sentences.empty())
        data.add(words.element("dcc:text", sentences));
}

PrintedValue rowOfKeyResults(const std::vector<Message> &row)
{
    constexpr std::size_t kExpandedAt = 2, kFactorAt = 3;
    PrintedValue printed = printedValue(row[1]).value_or(PrintedValue{});
    const auto expanded = printedValue(row[kExpandedAt]);
    const auto factor = printedValue(row[kFactorAt]);
    if (expanded && factor && expanded->unit == printed.unit) {
        printed.expanded = expanded->value;
        printed.factor = factor->value;
    }
    return printed;
}

/// A section as a result: what `addContent` adds to the data stands between its sentences.
template <typename AddContent>
XmlElement sectionResult(
    const DccWords &words, const CertificateSection &section, const AddContent &addContent)
{
    XmlElement result = dccResult(words, section.title, refTypeOf(section.id));
    XmlElement &data = result.add({"dcc:data"});
    addText(words, section.paragraphs, data);
    addContent(data);
    addText(words, section.notes, data);
    if (data.children.empty()) // the schema wants something
        addText(words, {section.title}, data);
    return result;
}

/// A row of the key results, or of those that are none.
XmlElement keyResult(
    const DccWords &words, const CertificateTable &table, const std::vector<Message> &row)
{
    const bool isReported = table.id == "key-results";
    const std::string refType = refTypeOf("key-results/" + std::string(row[0].text));
    const PrintedValue printed = isReported ? rowOfKeyResults(row) : PrintedValue{};
    if (!printed.value.empty())
        return dccQuantity(words, row[0], refType, printed);
    return dccWordsQuantity(words, row[0], isReported ? refType : refType + " dyncal_notReported",
        std::vector<Message>(row.begin() + 1, row.end()));
}

} // namespace

XmlElement dccListOf(const DccWords &words, const CertificateTable &table)
{
    XmlElement list = withRefType("dcc:list", refTypeOf(placeOf(table)));
    if (*table.caption.text != '\0')
        list.add(words.element("dcc:name", {table.caption}));
    for (const DccColumn &column : columnsOf(table))
        addDccColumn(words, column, list);
    return list;
}

XmlElement dccResultOf(const DccWords &words, const CertificateSection &section)
{
    return sectionResult(words, section, [&](XmlElement &data) {
        for (const CertificateField &field : section.fields)
            data.add(dccQuantityOf(
                words, field.label, refTypeOf(section.id + "." + field.id), field.value));
        for (const CertificateTable &table : section.tables)
            data.add(dccListOf(words, table));
    });
}

XmlElement dccKeyResults(const DccWords &words, const CertificateSection &section)
{
    return sectionResult(words, section, [&](XmlElement &data) {
        for (const CertificateTable &table : section.tables)
            for (const std::vector<Message> &row : table.rows)
                data.add(keyResult(words, table, row));
    });
}

} // namespace dyncal
