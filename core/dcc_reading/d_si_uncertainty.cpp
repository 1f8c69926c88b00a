// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/d_si_uncertainty.h"

#include "core/base/constants.h"
#include "core/dcc_reading/d_si_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dyncal {
namespace {

/// A way to state an uncertainty: the element, what of it is U or u, and its factor.
struct Form
{
    std::string_view element, value, factor; ///< no factor: `value` is u itself
};

constexpr std::array kForms{Form{"expandedMU", "valueExpandedMU", "coverageFactor"},
    Form{"expandedMUXMLList", "valueExpandedMUXMLList", "coverageFactorXMLList"},
    Form{"expandedUnc", "uncertainty", "coverageFactor"},
    Form{"expandedUncXMLList", "uncertaintyXMLList", "coverageFactorXMLList"},
    Form{"standardMU", "valueStandardMU", ""},
    Form{"standardMUXMLList", "valueStandardMUXMLList", ""},
    Form{"coverageIntervalMU", "valueStandardMU", ""},
    Form{"coverageIntervalMUXMLList", "valueStandardMUXMLList", ""},
    Form{"coverageInterval", "standardUnc", ""},
    Form{"coverageIntervalXMLList", "standardUncXMLList", ""}};

/// What holds one of the forms; the D-SI of 2.2 spells the one in realList so.
constexpr std::array<std::string_view, 5> kHolders{"measurementUncertaintyUnivariate",
    "measurementUncertaintyUnivaraite", "measurementUncertaintyUnivariateXMLList",
    "listMeasurementUncertaintyUnivariate", "listUnivariateUnc"};

Result<std::vector<double>> notBelowZero(
    const ParsedElement &element, std::string_view name, std::size_t count)
{
    Result<std::vector<double>> numbers = numbersOfChild(element, name, count);
    if (numbers && std::ranges::any_of(*numbers, [](double one) { return one < 0.0; }))
        return notUnderstood(element,
            DYNCAL_TEXT("core", "Line %1, %2: its %3 is below 0, which no uncertainty is."),
            {std::string(name)});
    return numbers;
}

Result<DSiUncertainty> expanded(const ParsedElement &element, const Form &form, std::size_t count)
{
    const Result<std::vector<double>> U = notBelowZero(element, form.value, count);
    if (!U)
        return tl::unexpected<Error>(U.error());
    Result<std::vector<double>> k = numbersOfChild(element, form.factor, count);
    if (!k)
        return tl::unexpected<Error>(k.error());
    if (std::ranges::any_of(*k, [](double one) { return one <= 0.0; }))
        return notUnderstood(element,
            DYNCAL_TEXT("core",
                "Line %1, %2: its %3 is not above 0, so the standard uncertainty does not follow."),
            {std::string(form.factor)});
    DSiUncertainty stated{*U, std::move(*k)};
    for (std::size_t i = 0; i < count; ++i)
        stated.u[i] /= stated.k[i];
    return stated;
}

Result<DSiUncertainty> inForm(const ParsedElement &element, const Form &form, std::size_t count)
{
    if (!form.factor.empty())
        return expanded(element, form, count);
    Result<std::vector<double>> u = notBelowZero(element, form.value, count);
    if (!u)
        return tl::unexpected<Error>(u.error());
    return DSiUncertainty{std::move(*u), std::vector<double>(count, kUnknown)};
}

const Form *formOf(const ParsedElement &element)
{
    const auto found = std::ranges::find(kForms, element.name, &Form::element);
    return found == kForms.end() ? nullptr : &*found;
}

bool isHolder(const ParsedElement &element)
{
    return std::ranges::find(kHolders, element.name) != kHolders.end();
}

/// Whether its name says that it is of uncertainty, understood or not.
bool isOfUncertainty(const ParsedElement &element)
{
    return std::ranges::any_of(std::array{"ncertaint", "Unc", "MU", "Interval", "Region"},
        [&](const char *part) { return element.name.find(part) != std::string::npos; });
}

tl::unexpected<Error> unknownUncertainty(const ParsedElement &element)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: this statement of the uncertainty is not understood, or is the second one; the quantity is not read without it."));
}

/// The only child that states an uncertainty, of all values together (multivariate) left out where
/// there is one of single values; null where there is none.
Result<const ParsedElement *> onlyStatement(const ParsedElement &element)
{
    const ParsedElement *known = nullptr, *other = nullptr;
    for (const ParsedElement &child : element.children) {
        const bool isKnown = formOf(child) || isHolder(child);
        if (isKnown && std::exchange(known, &child))
            return unknownUncertainty(child);
        if (!isKnown && isOfUncertainty(child))
            other = &child;
    }
    if (!known && other)
        return unknownUncertainty(*other);
    return known;
}

/// A constant has its standard uncertainty beside its value.
Result<DSiUncertainty> ofConstant(const ParsedElement &element, std::size_t count)
{
    if (element.child("valueStandardMU") && element.child("uncertainty"))
        return unknownUncertainty(*element.child("uncertainty"));
    for (const char *name : {"valueStandardMU", "uncertainty"})
        if (element.child(name))
            return inForm(element, {element.name, name, ""}, count);
    return DSiUncertainty{};
}

/// One entry of the matrix, for each value.
Result<std::vector<double>> covarianceEntries(
    const ParsedElement &entry, std::size_t count, const DSiUnit &product)
{
    const bool isList = entry.child("valueXMLList") != nullptr;
    const Result<const ParsedElement *> unitElement
        = neededChild(entry, isList ? "unitXMLList" : "unit");
    if (!unitElement)
        return tl::unexpected<Error>(unitElement.error());
    const Result<ListedUnit> unit = unitIn(**unitElement, count);
    if (!unit)
        return tl::unexpected<Error>(unit.error());
    if (unit->unit.powers != product.powers)
        return notUnderstood(**unitElement,
            DYNCAL_TEXT(
                "core", "Line %1, %2: the covariance is in %3, where the values ask for %4."),
            {unit->unit.symbol(), product.symbol()});
    Result<std::vector<double>> values
        = numbersOfChild(entry, isList ? "valueXMLList" : "value", count);
    if (values)
        for (std::size_t i = 0; i < count; ++i)
            (*values)[i] *= unit->factors[i];
    return values;
}

DSiUnit productOf(const DSiUnit &a, const DSiUnit &b)
{
    DSiUnit product = a;
    for (const auto &[symbol, power] : b.powers)
        product.powers[symbol] += power;
    std::erase_if(product.powers, [](const auto &power) { return power.second == 0; });
    return product;
}

/// Its columns, each with its entries; empty where it is not of two parts.
std::vector<std::vector<const ParsedElement *>> columnsOf(const ParsedElement &matrix)
{
    std::vector<std::vector<const ParsedElement *>> columns;
    for (const ParsedElement &column : matrix.children) {
        columns.emplace_back();
        for (const ParsedElement &entry : column.children)
            columns.back().push_back(&entry);
        if (columns.back().size() != 2)
            return {};
    }
    if (columns.size() != 2)
        columns.clear();
    return columns;
}

/// Symmetric, and no correlation beyond 1 by more than rounded digits make. Of a value that is not
/// stated it is not either. Without squares, which numbers far from 1 do not have.
bool isCovariance(const Eigen::Matrix2d &matrix)
{
    if (matrix(0, 0) < 0.0 || matrix(1, 1) < 0.0 || matrix.array().isInf().any())
        return false;
    if (!matrix.allFinite())
        return true;
    constexpr double kRounding = 0.02;
    const double largest = std::sqrt(matrix(0, 0)) * std::sqrt(matrix(1, 1));
    const double asymmetry = std::abs(matrix(0, 1) - matrix(1, 0));
    return asymmetry <= kRounding * largest
        && std::abs(matrix(0, 1)) <= largest * std::sqrt(1.0 + kRounding);
}

Result<std::vector<Eigen::Matrix2d>> covariancesIn(
    const ParsedElement &matrix, std::size_t count, const std::array<DSiUnit, 2> &units)
{
    const auto columns = columnsOf(matrix);
    if (columns.empty())
        return notUnderstood(matrix,
            DYNCAL_TEXT("core",
                "Line %1, %2: it has not two columns with two entries each, which both parts of a complex value ask for."));
    std::vector<Eigen::Matrix2d> covariances(count, Eigen::Matrix2d::Zero());
    for (std::size_t column = 0; column < 2; ++column)
        for (std::size_t row = 0; row < 2; ++row) {
            const Result<std::vector<double>> entries = covarianceEntries(
                *columns[column][row], count, productOf(units[row], units[column]));
            if (!entries)
                return tl::unexpected<Error>(entries.error());
            for (std::size_t i = 0; i < count; ++i)
                covariances[i](static_cast<Index>(row), static_cast<Index>(column)) = (*entries)[i];
        }
    if (!std::ranges::all_of(covariances, isCovariance))
        return notUnderstood(matrix,
            DYNCAL_TEXT("core",
                "Line %1, %2: it is no covariance: not symmetric, negative on its diagonal, or correlated by more than 1."));
    return covariances;
}

/// The region, wherever the form of the complex value has it; null where it has none.
Result<const ParsedElement *> regionOf(const ParsedElement &element)
{
    const ParsedElement *only = nullptr;
    for (const char *holder : {"", "measurementUncertaintyBivariateXMLList", "listBivariateUnc"}) {
        const ParsedElement *in = *holder == '\0' ? &element : element.child(holder);
        for (const char *region : {"ellipsoidalRegion", "rectangularRegion",
                 "ellipsoidalRegionMUXMLList", "rectangularRegionMUXMLList"})
            for (const ParsedElement *found :
                in ? in->all(region) : std::vector<const ParsedElement *>{})
                if (std::exchange(only, found))
                    return unknownUncertainty(*found);
    }
    return only;
}

} // namespace

Result<DSiUncertainty> uncertaintyOf(const ParsedElement &element, std::size_t count)
{
    if (element.name == "constant")
        return ofConstant(element, count);
    const Result<const ParsedElement *> statement = onlyStatement(element);
    if (!statement)
        return tl::unexpected<Error>(statement.error());
    if (!*statement)
        return DSiUncertainty{};
    if (const Form *form = formOf(**statement))
        return inForm(**statement, *form, count);
    const Result<const ParsedElement *> inside = onlyStatement(**statement);
    const Form *form = inside && *inside ? formOf(**inside) : nullptr;
    return form ? inForm(**inside, *form, count) : unknownUncertainty(**statement);
}

Result<std::vector<Eigen::Matrix2d>> covariancesOf(
    const ParsedElement &element, std::size_t count, const DSiUnit &first, const DSiUnit &second)
{
    const Result<const ParsedElement *> found = regionOf(element);
    if (!found)
        return tl::unexpected<Error>(found.error());
    const ParsedElement *region = *found;
    if (!region) {
        const auto other = std::ranges::find_if(element.children, isOfUncertainty);
        if (other != element.children.end())
            return unknownUncertainty(*other);
        return std::vector<Eigen::Matrix2d>{};
    }
    const ParsedElement *matrix = region->child("covarianceMatrix");
    if (!matrix)
        matrix = region->child("covarianceMatrixXMLList");
    if (!matrix)
        return notUnderstood(*region,
            DYNCAL_TEXT(
                "core", "Line %1, %2: it lacks the element %3, without which it says nothing."),
            {"covarianceMatrix"});
    return covariancesIn(*matrix, count, {first, second});
}

} // namespace dyncal
