// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_exact.h"

#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/dcc/complex_region.h"
#include "core/dcc/dcc_quantity.h"
#include "core/dcc/si_unit.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

using Texts = std::vector<std::string>;

XmlElement resultOf(const DccSource &source, const char *refType, const Message &name)
{
    XmlElement result = withRefType("dcc:result", refType);
    result.add(source.words.element("dcc:name", {name}));
    return result;
}

void addColumn(const DccSource &source, const DccColumn &column, XmlElement &list)
{
    for (XmlElement &quantity : dccColumn(source.words, column))
        list.add(std::move(quantity));
}

/// Every reported value, that of single shots too, by its key in results.json.
std::vector<std::pair<std::string, const ReportedValue *>> reportedOf(
    const UncertaintyReport &report)
{
    std::vector<std::pair<std::string, const ReportedValue *>> all;
    const auto place
        = [](std::size_t i) { return std::string("[").append(std::to_string(i)).append("]"); };
    if (report.sensitivity)
        all.emplace_back("sensitivity", &*report.sensitivity);
    for (std::size_t i = 0; i < report.perLevel.size(); ++i)
        all.emplace_back("sensitivity.per_level" + place(i), &report.perLevel[i]);
    for (std::size_t i = 0; i < report.ofShots.size(); ++i)
        all.emplace_back("shots" + place(i) + ".sensitivity", &report.ofShots[i]);
    for (const ReportedValue &value : report.ofModel)
        all.emplace_back(value.of, &value);
    return all;
}

std::vector<XmlElement> reportedValues(const DccSource &source)
{
    const UncertaintyReport *report = source.results.uncertainty.get();
    DccColumn names{{DYNCAL_TEXT("core", "Key in results.json"), {}}, "dyncal_reportedName"};
    DccColumn values{{DYNCAL_TEXT("core", "Value"), {}}, "dyncal_reportedValue"};
    DccColumn factors{{DYNCAL_TEXT("core", "k"), {}}, "dyncal_coverageFactor"};
    DccColumn dofs{
        {DYNCAL_TEXT("core", "Effective degrees of freedom"), {}}, "dyncal_degreesOfFreedom"};
    for (const auto &[name, value] :
        report ? reportedOf(*report) : decltype(reportedOf(*report))()) {
        const auto unit = dsiUnitOf(value->unit);
        if (!unit || !value->u || !std::isfinite(value->value))
            continue;
        names.words.push_back(verbatim(name));
        values.values.push_back(dccNumber(value->value));
        values.units.push_back(*unit);
        values.standard.push_back(dccNumber(*value->u));
        factors.values.push_back(dccNumber(value->k));
        dofs.values.push_back(dccNumber(value->dof));
    }
    if (values.values.empty())
        return {};
    factors.units = dofs.units = Texts(values.values.size(), "\\one");
    XmlElement list{"dcc:list"};
    for (const DccColumn &column : {names, values, factors, dofs})
        addColumn(source, column, list);
    XmlElement result = resultOf(
        source, "dyncal_reportedValues", {DYNCAL_TEXT("core", "Reported values, not rounded"), {}});
    result.add({"dcc:data", {}, {}, {std::move(list)}});
    return {std::move(result)};
}

Texts textsOf(const Eigen::VectorXd &values, Index count)
{
    Texts texts;
    for (Index i = 0; i < count; ++i)
        texts.push_back(dccNumber(valueAt(values, i)));
    return texts;
}

DccColumn numbers(
    Message name, const char *refType, Texts values, const std::string &unit, Texts standard = {})
{
    DccColumn column{std::move(name), refType};
    column.units.assign(values.size(), unit);
    column.values = std::move(values);
    const bool isKnown
        = std::ranges::any_of(standard, [](const std::string &u) { return u != kDccNone; });
    column.standard = isKnown ? std::move(standard) : Texts();
    return column;
}

/// Regions row by row, each part as a text.
struct RegionTexts
{
    Texts re, im, varRe, cov, varIm, k;
};

RegionTexts regionsOf(const ResponseResult &response, const RowUncertainty &rows)
{
    constexpr int kDigitsOfFactor = 4;
    RegionTexts texts;
    for (Index i = 0; i < response.frequency_Hz.size(); ++i) {
        const ComplexRegion region = complexRegion(response, rows, i);
        texts.re.push_back(dccNumber(region.re));
        texts.im.push_back(dccNumber(region.im));
        texts.varRe.push_back(dccNumber(region.varRe));
        texts.cov.push_back(dccNumber(region.covReIm));
        texts.varIm.push_back(dccNumber(region.varIm));
        texts.k.push_back(
            std::isfinite(region.k) ? dccFactor(fixedText(region.k, kDigitsOfFactor)) : kDccNone);
    }
    return texts;
}

XmlElement covariances(const Texts &values, const std::string &unit)
{
    return {"si:covarianceXMLList", {}, {},
        {{"si:valueXMLList", {}, dccList(values)}, {"si:unitXMLList", {}, unit}}};
}

/// "\volt\pascal\tothe{-1}" squared, factor by factor.
std::string squared(const std::string &unit)
{
    return unit == "\\one" ? unit : unit + unit;
}

XmlElement complexValues(
    const DccSource &source, const RegionTexts &regions, const std::string &unit)
{
    const std::string square = squared(unit);
    XmlElement quantity = withRefType("dcc:quantity", "dyncal_complexValue");
    quantity.add(
        source.words.element("dcc:name", {Message{DYNCAL_TEXT("core", "Complex response"), {}}}));
    XmlElement &list = quantity.add({"si:complexListXMLList"});
    list.add({"si:valueRealXMLList", {}, dccList(regions.re)});
    list.add({"si:valueImagXMLList", {}, dccList(regions.im)});
    list.add({"si:unitXMLList", {}, unit});
    XmlElement &region = list.add({"si:measurementUncertaintyBivariateXMLList"})
                             .add({"si:ellipsoidalRegionMUXMLList"});
    XmlElement &matrix = region.add({"si:covarianceMatrixXMLList"});
    matrix.add({"si:columnXMLList", {}, {},
        {covariances(regions.varRe, square), covariances(regions.cov, square)}});
    matrix.add({"si:columnXMLList", {}, {},
        {covariances(regions.cov, square), covariances(regions.varIm, square)}});
    region.add({"si:coverageFactorXMLList", {}, dccList(regions.k)});
    region.add({"si:coverageProbabilityXMLList", {}, kDccProbability});
    return quantity;
}

XmlElement responseList(const DccSource &source, const ResponseResult &response,
    const RowUncertainty &rows, const std::string &unit)
{
    const Index count = response.frequency_Hz.size();
    const RegionTexts regions = regionsOf(response, rows);
    XmlElement list{"dcc:list"};
    addColumn(source,
        numbers({DYNCAL_TEXT("core", "Frequency"), {}}, "basic_tableIndex0 dyncal_frequency",
            textsOf(response.frequency_Hz, count), "\\hertz"),
        list);
    list.add(complexValues(source, regions, unit));
    addColumn(source,
        numbers({DYNCAL_TEXT("core", "Magnitude"), {}}, "basic_measuredValue dyncal_magnitude",
            textsOf(response.magnitude, count), unit, textsOf(rows.u_magnitude, count)),
        list);
    addColumn(source,
        numbers({DYNCAL_TEXT("core", "Phase"), {}}, "basic_measuredValue dyncal_phase",
            textsOf(response.phase_rad, count), "\\radian", textsOf(rows.u_phase_rad, count)),
        list);
    addColumn(source,
        numbers({DYNCAL_TEXT("core", "Effective degrees of freedom"), {}},
            "dyncal_degreesOfFreedom", textsOf(rows.dof_magnitude, count), "\\one"),
        list);
    addColumn(source,
        numbers({DYNCAL_TEXT("core", "Model, magnitude"), {}}, "dyncal_modelMagnitude",
            textsOf(response.modelMagnitude, count), unit, textsOf(rows.u_modelMagnitude, count)),
        list);
    addColumn(source,
        numbers({DYNCAL_TEXT("core", "Model, phase"), {}}, "dyncal_modelPhase",
            textsOf(response.modelPhase_rad, count), "\\radian",
            textsOf(rows.u_modelPhase_rad, count)),
        list);
    return list;
}

/// Nothing where nothing was measured, or its unit is not known.
void addResponse(const DccSource &source, const char *refType, const Message &name,
    const ResponseResult *response, const RowUncertainty &rows, std::vector<XmlElement> &results)
{
    const auto unit = dsiUnitOf(response ? response->unit : std::string());
    if (!response || !unit || response->frequency_Hz.size() == 0 || response->magnitude.size() == 0)
        return;
    XmlElement result = resultOf(source, refType, name);
    const auto withheld = std::ranges::count_if(
        response->withheld, [](WithheldReason reason) { return reason != WithheldReason::None; });
    if (withheld > 0)
        result.add(source.words.element("dcc:description",
            {Message{DYNCAL_TEXT("core", "Of %1 rows %2 are withheld and have no value (NaN)."),
                {std::to_string(response->frequency_Hz.size()), std::to_string(withheld)}}}));
    XmlElement list = responseList(source, *response, rows, *unit);
    if (std::string_view(refType) == "dyncal_complexResponse")
        list.attributes.emplace_back("id", kDccResponse);
    result.add({"dcc:data", {}, {}, {std::move(list)}});
    results.push_back(std::move(result));
}

void addResponses(const DccSource &source, std::vector<XmlElement> &results)
{
    const UncertaintyReport none;
    const UncertaintyReport &report
        = source.results.uncertainty ? *source.results.uncertainty : none;
    const ResponseResult *response = source.results.response.get();
    addResponse(source, "dyncal_complexResponse",
        {DYNCAL_TEXT("core", "Frequency response as complex numbers, not rounded"), {}}, response,
        report.rows, results);
    addResponse(source, "dyncal_complexResponseAtMarks",
        {DYNCAL_TEXT("core", "The same at the limits of the band, its edges and the resonance"),
            {}},
        response ? response->atMarks.get() : nullptr, report.rowsAtMarks, results);
}

/// Of a comparison beside the response by the step; against a transducer it is the response itself.
void addComparison(const DccSource &source, std::vector<XmlElement> &results)
{
    const auto &comparison = source.results.comparison;
    const bool isBeside = comparison && comparison->byTransducer && source.results.response
        && !source.results.response->isByTransducer;
    if (!isBeside)
        return;
    const UncertainResponse &found = *comparison->byTransducer;
    addResponse(source, "dyncal_comparisonResponse",
        {DYNCAL_TEXT("core", "Frequency response against the reference transducer, not rounded"),
            {}},
        &found.response, found.report.rows, results);
    addResponse(source, "dyncal_comparisonResponseAtMarks",
        {DYNCAL_TEXT("core", "The same at the limits of the band, its edges and the resonance"),
            {}},
        found.response.atMarks.get(), found.report.rowsAtMarks, results);
}

} // namespace

std::vector<XmlElement> dccExactResults(const DccSource &source)
{
    std::vector<XmlElement> results = reportedValues(source);
    addResponses(source, results);
    addComparison(source, results);
    return results;
}

} // namespace dyncal
