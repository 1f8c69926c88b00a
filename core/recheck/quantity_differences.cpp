// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/recheck/quantity_differences.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

double changeOf(const QuantityPair &pair)
{
    const double change = pair.now - pair.issued;
    return pair.isAngle ? std::remainder(change, kTwoPi) : change;
}

bool hasU(const QuantityPair &pair)
{
    return pair.u > 0.0 && std::isfinite(pair.u);
}

bool isExact(const QuantityPair &pair)
{
    return pair.u == 0.0 && pair.uNow == 0.0;
}

bool hasOtherUnit(const QuantityPair &pair)
{
    return std::isfinite(pair.now) && !pair.unit.empty() && !pair.unitNow.empty()
        && pair.unit != pair.unitNow;
}

double overU(double change, double U)
{
    return change == 0.0 ? 0.0 : std::abs(change) / U;
}

/// With U = k u as issued, where there is one.
QuantityDifference ofStated(const QuantityPair &pair)
{
    QuantityDifference difference{pair};
    if (hasU(pair) || isExact(pair)) {
        difference.isKAssumed = !(pair.k > 0.0 && std::isfinite(pair.k));
        difference.k = difference.isKAssumed ? kAssumedCoverage : pair.k;
        difference.U = difference.k * pair.u;
    }
    if (hasOtherUnit(pair))
        difference.fate = QuantityFate::UnitChanged;
    else if (std::isfinite(pair.now))
        difference.overU = overU(changeOf(pair), difference.U);
    else
        difference.fate = QuantityFate::Withdrawn;
    return difference;
}

QuantityDifference differenceOf(const QuantityPair &pair)
{
    return std::isfinite(pair.issued) ? ofStated(pair)
                                      : QuantityDifference{pair, QuantityFate::StatedNow};
}

/// Two values need a U to be compared; one that is gone or new needs none to be told.
bool isComparable(const QuantityPair &pair)
{
    const bool wasStated = std::isfinite(pair.issued), isStated = std::isfinite(pair.now);
    return wasStated && isStated ? hasU(pair) || isExact(pair) || hasOtherUnit(pair)
                                 : wasStated != isStated;
}

bool isWorse(const QuantityDifference &a, const QuantityDifference &b)
{
    if (a.fate != b.fate)
        return a.fate < b.fate;
    return a.fate == QuantityFate::Compared && a.overU > b.overU;
}

} // namespace

double QuantityDifferences::largestWithinU() const
{
    double largest = 0.0;
    for (const QuantityDifference &one : list)
        if (one.overU <= 1.0)
            largest = std::max(largest, one.overU);
    return largest;
}

int QuantityDifferences::compared() const
{
    return static_cast<int>(
        std::ranges::count(list, QuantityFate::Compared, &QuantityDifference::fate));
}

QuantityDifferences quantityDifferences(const std::vector<QuantityPair> &pairs)
{
    QuantityDifferences differences;
    for (const QuantityPair &pair : pairs) {
        if (isComparable(pair))
            differences.list.push_back(differenceOf(pair));
        else if (std::isfinite(pair.issued))
            ++differences.withoutU;
    }
    std::ranges::stable_sort(differences.list, isWorse);
    return differences;
}

} // namespace dyncal
