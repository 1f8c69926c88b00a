// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc_reading/d_si_unit.h"
#include "core/xml/parsed_xml.h"

#include <string_view>
#include <vector>

namespace dyncal {

// What the elements of the D-SI hold: numbers and units, one or a list of them. All fail (Usage)
// with one sentence that has line, element, what was found and what is needed.

/// The only child of this name. Fails where there is none, or several.
Result<const ParsedElement *> neededChild(const ParsedElement &element, std::string_view name);

/// The numbers of the element's text, with "." as decimal mark; in an XML list NaN too, which is
/// how the D-SI writes that there is no value. Fails on none at all, on elements among
/// the text and on what is no finite number.
Result<std::vector<double>> numbersIn(const ParsedElement &element);

/// The same, `count` of them: one stands for all. Fails where it is another number of them.
Result<std::vector<double>> numbersIn(const ParsedElement &element, std::size_t count);

/// The child's numbers, `count` of them.
Result<std::vector<double>> numbersOfChild(
    const ParsedElement &element, std::string_view name, std::size_t count);

/// Unit of values: without prefix, and what each value is multiplied by to be in it.
struct ListedUnit
{
    DSiUnit unit; ///< factor 1
    std::vector<double> factors; ///< as many as values
};

/// The unit, one for all or one for each of `count` values, which may then differ in their prefixes
/// only.
Result<ListedUnit> unitIn(const ParsedElement &element, std::size_t count);

/// A sentence about an element that begins with its line and name, places %1 and %2.
tl::unexpected<Error> notUnderstood(
    const ParsedElement &element, const char *text, std::vector<std::string> arguments = {});

} // namespace dyncal
