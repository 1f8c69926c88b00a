// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc/dcc_exact.h"

#include "core/base/rounding.h"
#include "core/certificate/certificate_words.h"
#include "core/dcc/complex_region.h"
#include "core/dcc/dcc_quantity.h"
#include "core/dcc/si_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace dyncal {
namespace {

using Texts = std::vector<std::string>;

Texts textsOf(const Eigen::VectorXd &values, Index count)
{
    Texts texts;
    for (Index i = 0; i < count; ++i)
        texts.push_back(dccNumber(valueAt(values, i)));
    return texts;
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

/// Numbers over frequency, with their u where they have one.
struct RowColumn
{
    const char *name, *refType;
    const Eigen::VectorXd *values;
    std::string unit;
    const Eigen::VectorXd *standard = nullptr;
};

DccColumn columnOfRows(const RowColumn &rows, Index count)
{
    DccColumn column{{rows.name, {}}, rows.refType, textsOf(*rows.values, count)};
    column.units.assign(column.values.size(), rows.unit);
    Texts standard = rows.standard ? textsOf(*rows.standard, count) : Texts();
    const bool isKnown
        = std::ranges::any_of(standard, [](const std::string &u) { return u != kDccNone; });
    column.standard = isKnown ? std::move(standard) : Texts();
    return column;
}

XmlElement responseList(const DccSource &source, const ResponseResult &response,
    const RowUncertainty &rows, const std::string &unit)
{
    const RowColumn frequency{DYNCAL_TEXT("core", "Frequency"),
        "basic_tableIndex0 dyncal_frequency", &response.frequency_Hz, "\\hertz"};
    const std::array others{
        RowColumn{DYNCAL_TEXT("core", "Magnitude"), "basic_measuredValue dyncal_magnitude",
            &response.magnitude, unit, &rows.u_magnitude},
        RowColumn{DYNCAL_TEXT("core", "Phase"), "basic_measuredValue dyncal_phase",
            &response.phase_rad, "\\radian", &rows.u_phase_rad},
        RowColumn{DYNCAL_TEXT("core", "Effective degrees of freedom"), "dyncal_degreesOfFreedom",
            &rows.dof_magnitude, "\\one"},
        RowColumn{DYNCAL_TEXT("core", "Model, magnitude"), "dyncal_modelMagnitude",
            &response.modelMagnitude, unit, &rows.u_modelMagnitude},
        RowColumn{DYNCAL_TEXT("core", "Model, phase"), "dyncal_modelPhase",
            &response.modelPhase_rad, "\\radian", &rows.u_modelPhase_rad}};
    const Index count = response.frequency_Hz.size();
    XmlElement list{"dcc:list"};
    addDccColumn(source.words, columnOfRows(frequency, count), list);
    list.add(complexValues(source, regionsOf(response, rows), unit));
    for (const RowColumn &column : others)
        addDccColumn(source.words, columnOfRows(column, count), list);
    return list;
}

/// Nothing where nothing was measured, or its unit is not known.
void addResponse(const DccSource &source, const char *refType, const Message &name,
    const ResponseResult *response, const RowUncertainty &rows, std::vector<XmlElement> &results)
{
    const auto unit = dsiUnitOf(response ? response->unit : std::string());
    if (!response || !unit || response->frequency_Hz.size() == 0 || response->magnitude.size() == 0)
        return;
    XmlElement result = dccResult(source.words, name, refType);
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

void addComparison(const DccSource &source, std::vector<XmlElement> &results)
{
    const UncertainResponse *found = source.comparisonBeside();
    if (!found)
        return;
    addResponse(source, "dyncal_comparisonResponse",
        {DYNCAL_TEXT("core", "Frequency response against the reference transducer, not rounded"),
            {}},
        &found->response, found->report.rows, results);
    addResponse(source, "dyncal_comparisonResponseAtMarks",
        {DYNCAL_TEXT("core", "The same at the limits of the band, its edges and the resonance"),
            {}},
        found->response.atMarks.get(), found->report.rowsAtMarks, results);
}

} // namespace

std::vector<XmlElement> dccExactResults(const DccSource &source)
{
    std::vector<XmlElement> results;
    addResponses(source, results);
    addComparison(source, results);
    return results;
}

} // namespace dyncal
