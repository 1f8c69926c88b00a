// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/dcc_reading/d_si_quantity.h"

#include "core/base/constants.h"
#include "core/base/uncertain_complex.h"
#include "core/dcc_reading/d_si_numbers.h"
#include "core/dcc_reading/d_si_uncertainty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dyncal {
namespace {

/// Names of the children that hold values: of one value, or of an XML list.
struct PartNames
{
    std::string_view value, unit, real, imaginary, magnitude, phase, unitOfPhase;
};

constexpr PartNames kOne{
    "value", "unit", "valueReal", "valueImag", "valueMagnitude", "valuePhase", "unitPhase"};
constexpr PartNames kListed{"valueXMLList", "unitXMLList", "valueRealXMLList", "valueImagXMLList",
    "valueMagnitudeXMLList", "valuePhaseXMLList", "unitPhaseXMLList"};

const PartNames &namesOf(const ParsedElement &element)
{
    return element.name.ends_with("XMLList") ? kListed : kOne;
}

/// The unit of the element, else that of the list it stands in.
Result<ListedUnit> unitOf(const ParsedElement &element, std::string_view name,
    const ParsedElement *list, std::string_view nameInList, std::size_t count)
{
    const bool isOfList = list && !element.child(name) && list->child(nameInList);
    return neededChild(isOfList ? *list : element, isOfList ? nameInList : name)
        .and_then([count](const ParsedElement *unit) { return unitIn(*unit, count); });
}

Result<std::vector<double>> valuesOfChild(const ParsedElement &element, std::string_view name)
{
    return neededChild(element, name).and_then([](const ParsedElement *child) {
        return numbersIn(*child);
    });
}

/// As many as factors, or none.
void scale(std::vector<double> &values, const std::vector<double> &factors)
{
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] *= factors[i];
}

/// In units without prefix a number may be beyond what a computer's numbers hold.
Result<StatedValues> withinRange(const ParsedElement &element, StatedValues stated)
{
    const auto isBeyond = [](double value) { return std::isinf(value); };
    if (std::ranges::none_of(stated.values, isBeyond) && std::ranges::none_of(stated.u, isBeyond))
        return stated;
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: a value or its uncertainty is beyond 1e308 in %3, which nothing measured is."),
        {stated.unit.symbol()});
}

Result<DSiUncertainty> ownOrListed(
    const ParsedElement &element, const ParsedElement *list, std::size_t count)
{
    Result<DSiUncertainty> own = uncertaintyOf(element, count);
    return own && own->u.empty() && list ? uncertaintyOf(*list, count) : own;
}

/// A real or an XML list of them; `list`: the realList that it stands in.
Result<StatedValues> realOf(const ParsedElement &element, const ParsedElement *list = nullptr)
{
    const PartNames &names = namesOf(element);
    Result<std::vector<double>> values = valuesOfChild(element, names.value);
    if (!values)
        return tl::unexpected<Error>(values.error());
    const Result<ListedUnit> unit = unitOf(element, names.unit, list, "listUnit", values->size());
    if (!unit)
        return tl::unexpected<Error>(unit.error());
    Result<DSiUncertainty> stated = ownOrListed(element, list, values->size());
    if (!stated)
        return tl::unexpected<Error>(stated.error());
    scale(*values, unit->factors);
    scale(stated->u, unit->factors);
    return withinRange(
        element, {unit->unit, std::move(*values), std::move(stated->u), std::move(stated->k)});
}

Result<DSiQuantity> realQuantity(const ParsedElement &element)
{
    return realOf(element).map([](StatedValues real) { return DSiQuantity{std::move(real)}; });
}

tl::unexpected<Error> unlikeBefore(const ParsedElement &element)
{
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: its unit, or whether it has an uncertainty, is not as in the entries before it; a list of one kind is needed."));
}

/// False where it is not of the kind of those before.
bool append(StatedValues &all, StatedValues more)
{
    const bool isAlike = all.values.empty()
        || (all.unit.powers == more.unit.powers && all.u.empty() == more.u.empty());
    all.unit = more.unit;
    all.values.insert(all.values.end(), more.values.begin(), more.values.end());
    all.u.insert(all.u.end(), more.u.begin(), more.u.end());
    all.k.insert(all.k.end(), more.k.begin(), more.k.end());
    return isAlike;
}

tl::unexpected<Error> emptyList(const ParsedElement &element)
{
    return notUnderstood(
        element, DYNCAL_TEXT("core", "Line %1, %2: the list is empty, and values are needed."));
}

Result<DSiQuantity> realListQuantity(const ParsedElement &element)
{
    StatedValues all;
    for (const ParsedElement *one : element.all("real")) {
        Result<StatedValues> real = realOf(*one, &element);
        if (!real)
            return tl::unexpected<Error>(real.error());
        if (!append(all, std::move(*real)))
            return unlikeBefore(*one);
    }
    if (all.values.empty())
        return emptyList(element);
    return DSiQuantity{std::move(all)};
}

/// Two lists of numbers and their units, before they mean anything.
struct ComplexParts
{
    std::vector<double> first, second;
    ListedUnit unitOfFirst, unitOfSecond;
    std::vector<Eigen::Matrix2d> covariances; ///< empty: none is stated
};

/// Of both parts, in units without prefix.
Result<ComplexParts> partsOf(const ParsedElement &element, const ParsedElement *list, bool isPolar)
{
    const PartNames &names = namesOf(element);
    Result<std::vector<double>> first
        = valuesOfChild(element, isPolar ? names.magnitude : names.real);
    if (!first)
        return tl::unexpected<Error>(first.error());
    const std::size_t count = first->size();
    Result<std::vector<double>> second
        = numbersOfChild(element, isPolar ? names.phase : names.imaginary, count);
    if (!second)
        return tl::unexpected<Error>(second.error());
    const Result<ListedUnit> unit = unitOf(element, names.unit, list, "listUnit", count);
    const Result<ListedUnit> unitOfSecond
        = isPolar ? unitOf(element, names.unitOfPhase, list, "listUnitPhase", count) : unit;
    for (const Result<ListedUnit> *one : {&unit, &unitOfSecond})
        if (!*one)
            return tl::unexpected<Error>(one->error());
    ComplexParts parts{std::move(*first), std::move(*second), *unit, *unitOfSecond, {}};
    Result<std::vector<Eigen::Matrix2d>> covariances
        = covariancesOf(element, count, parts.unitOfFirst.unit, parts.unitOfSecond.unit);
    if (covariances && covariances->empty() && list)
        covariances = covariancesOf(*list, count, parts.unitOfFirst.unit, parts.unitOfSecond.unit);
    if (!covariances)
        return tl::unexpected<Error>(covariances.error());
    parts.covariances = std::move(*covariances);
    scale(parts.first, parts.unitOfFirst.factors);
    scale(parts.second, parts.unitOfSecond.factors);
    return parts;
}

UncertainPolar polarOf(const ComplexParts &parts, std::size_t i, bool isPolar)
{
    const Eigen::Matrix2d covariance
        = parts.covariances.empty() ? Eigen::Matrix2d::Zero() : parts.covariances[i];
    if (isPolar)
        return {parts.first[i], parts.second[i], covariance};
    return toPolar({{parts.first[i], parts.second[i]}, covariance});
}

void add(DSiQuantity &quantity, const UncertainPolar &one, bool hasU)
{
    quantity.values.values.push_back(one.magnitude);
    quantity.phases_rad->values.push_back(one.phase_rad);
    if (!hasU)
        return;
    quantity.values.u.push_back(std::sqrt(one.covariance(0, 0)));
    quantity.phases_rad->u.push_back(std::sqrt(one.covariance(1, 1)));
    quantity.values.k.push_back(kUnknown);
    quantity.phases_rad->k.push_back(kUnknown);
}

/// A complex value or an XML list of them; `list`: the complexList that it stands in.
Result<DSiQuantity> complexOf(const ParsedElement &element, const ParsedElement *list = nullptr)
{
    const bool isPolar = element.child(namesOf(element).magnitude) != nullptr;
    const Result<ComplexParts> parts = partsOf(element, list, isPolar);
    if (!parts)
        return tl::unexpected<Error>(parts.error());
    if (isPolar && !parts->unitOfSecond.unit.isOf("rad"))
        return notUnderstood(element,
            DYNCAL_TEXT(
                "core", "Line %1, %2: its phase is in %3; one in \\radian or \\degree is needed."),
            {parts->unitOfSecond.unit.symbol()});
    DSiQuantity quantity{{}, StatedValues{}};
    quantity.values.unit = parts->unitOfFirst.unit;
    quantity.phases_rad->unit.powers = {{"rad", 1}};
    for (std::size_t i = 0; i < parts->first.size(); ++i) {
        const UncertainPolar one = polarOf(*parts, i, isPolar);
        if (!isPolar && one.magnitude == 0.0)
            return notUnderstood(element,
                DYNCAL_TEXT("core",
                    "Line %1, %2: value %3 is 0, so its phase and the uncertainty of it are not determined."),
                {std::to_string(i + 1)});
        add(quantity, one, !parts->covariances.empty());
    }
    Result<StatedValues> phases_rad = withinRange(element, std::move(*quantity.phases_rad));
    if (!phases_rad)
        return tl::unexpected<Error>(phases_rad.error());
    return withinRange(element, std::move(quantity.values)).map([&](StatedValues values) {
        return DSiQuantity{std::move(values), std::move(*phases_rad)};
    });
}

/// Each phase to the turn nearest to the one before it: the angle of a complex value has none.
void unwrap(std::vector<double> &phases_rad)
{
    constexpr double kTurn_rad = 2.0 * std::numbers::pi;
    double before_rad = 0.0;
    for (double &phase_rad : phases_rad) {
        if (!std::isfinite(phase_rad))
            continue;
        phase_rad -= kTurn_rad * std::round((phase_rad - before_rad) / kTurn_rad);
        before_rad = phase_rad;
    }
}

Result<DSiQuantity> complexQuantity(const ParsedElement &element)
{
    Result<DSiQuantity> quantity = complexOf(element);
    if (quantity && !element.child(namesOf(element).magnitude))
        unwrap(quantity->phases_rad->values);
    return quantity;
}

Result<DSiQuantity> complexListQuantity(const ParsedElement &element)
{
    DSiQuantity all{{}, StatedValues{}};
    bool isRectangular = false;
    for (const ParsedElement *one : element.all("complex")) {
        Result<DSiQuantity> quantity = complexOf(*one, &element);
        if (!quantity)
            return quantity;
        isRectangular = isRectangular || one->child(kOne.real);
        const bool isAlike = append(all.values, std::move(quantity->values))
            && append(*all.phases_rad, std::move(*quantity->phases_rad));
        if (!isAlike)
            return unlikeBefore(*one);
    }
    if (all.values.values.empty())
        return emptyList(element);
    if (isRectangular)
        unwrap(all.phases_rad->values);
    return all;
}

Result<DSiQuantity> hybridQuantity(const ParsedElement &element);

struct Reader
{
    std::string_view element;
    Result<DSiQuantity> (*read)(const ParsedElement &element);
};

constexpr std::array kReaders{Reader{"real", realQuantity}, Reader{"realListXMLList", realQuantity},
    Reader{"realList", realListQuantity}, Reader{"constant", realQuantity},
    Reader{"complex", complexQuantity}, Reader{"complexListXMLList", complexQuantity},
    Reader{"complexList", complexListQuantity}, Reader{"hybrid", hybridQuantity}};

const Reader *readerOf(const ParsedElement &element)
{
    const auto found = std::ranges::find(kReaders, element.name, &Reader::element);
    return found == kReaders.end() ? nullptr : &*found;
}

/// The same in several units; one that is not known, as degrees Celsius, gives way to another.
Result<DSiQuantity> hybridQuantity(const ParsedElement &element)
{
    Result<DSiQuantity> quantity = emptyList(element);
    for (const ParsedElement &member : element.children) {
        Result<DSiQuantity> one = readDSiQuantity(member);
        if (one)
            return one;
        if (&member == &element.children.front())
            quantity = std::move(one);
    }
    return quantity;
}

} // namespace

bool isDSiElement(const ParsedElement &element)
{
    return readerOf(element) != nullptr;
}

Result<DSiQuantity> readDSiQuantity(const ParsedElement &element)
{
    if (const Reader *reader = readerOf(element))
        return reader->read(element);
    return notUnderstood(element,
        DYNCAL_TEXT("core",
            "Line %1, %2: this form of a quantity is not understood; one of the D-SI's real, complex or constant values or lists of them is needed."));
}

} // namespace dyncal
