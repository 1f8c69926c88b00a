// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/selftest/self_check.h"

#include "core/base/constants.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

namespace dyncal {
namespace {

double foundBy(const CheckSpec &spec, DataChange change)
{
    try {
        return spec.find(change);
    } catch (const std::bad_alloc &) {
        throw; // says nothing of the method
    } catch (const std::exception &) {
        return kUnknown;
    }
}

} // namespace

DataChange::DataChange(double relative, std::uint64_t sequence)
    : m_relative(relative)
    , m_state(sequence)
{
}

double DataChange::operator()(double value)
{
    // The multiplier of Knuth's MMIX; the upper bits are the random ones.
    m_state = m_state * 6364136223846793005U + 1442695040888963407U;
    const bool up = (m_state >> 63U) != 0;
    return value * (1.0 + (up ? m_relative : -m_relative));
}

Eigen::VectorXd DataChange::operator()(Eigen::VectorXd values)
{
    for (double &value : values)
        value = (*this)(value);
    return values;
}

bool SelfCheck::holds() const
{
    return std::abs(found - expected) <= tolerance;
}

SelfCheck carriedOut(const CheckSpec &spec)
{
    SelfCheck check{spec.step, spec.name, spec.source, spec.expected, 0.0, spec.tolerance, 0.0};
    check.found = foundBy(spec, DataChange());
    if (!std::isfinite(check.found)) {
        check.sensitivity = kUnknown;
        return check;
    }
    for (const std::uint64_t sequence : {1U, 2U}) {
        const double moved = foundBy(spec, DataChange(kDataChange, sequence));
        check.sensitivity = std::max(check.sensitivity, std::abs(moved - check.found));
    }
    return check;
}

} // namespace dyncal
