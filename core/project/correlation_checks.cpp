// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/correlation_checks.h"

#include "core/base/number_text.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <string>
#include <vector>

namespace dyncal {
namespace {

bool isSamePair(const CorrelationEntry &a, const CorrelationEntry &b)
{
    return (a.quantity == b.quantity && a.with == b.with)
        || (a.quantity == b.with && a.with == b.quantity);
}

Result<void> checkOnce(const CorrelationEntry &entry, const UncertaintySettings &settings)
{
    const auto same = [&](const CorrelationEntry &other) { return isSamePair(entry, other); };
    if (std::ranges::count_if(settings.correlations, same) <= 1)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "Recipe key uncertainty.correlations holds \"%1\" with \"%2\" twice; leave one."),
            {entry.quantity, entry.with}});
}

Eigen::MatrixXd matrixOf(const UncertaintySettings &settings)
{
    std::vector<std::string> names;
    const auto placeOf = [&names](const std::string &name) {
        return static_cast<Index>(std::ranges::find(names, name) - names.begin());
    };
    for (const CorrelationEntry &entry : settings.correlations)
        for (const std::string &name : {entry.quantity, entry.with})
            if (std::ranges::find(names, name) == names.end())
                names.push_back(name);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(std::ssize(names), std::ssize(names));
    for (const CorrelationEntry &entry : settings.correlations) {
        const Index a = placeOf(entry.quantity), b = placeOf(entry.with);
        if (a != b)
            matrix(a, b) = matrix(b, a) = entry.coefficient;
    }
    return matrix;
}

} // namespace

Result<void> checkCorrelations(const UncertaintySettings &settings)
{
    constexpr double kRounding = 1e-9;
    if (settings.correlations.empty())
        return {};
    for (const CorrelationEntry &entry : settings.correlations)
        if (const Result<void> checked = checkOnce(entry, settings); !checked)
            return checked;
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrixOf(settings))
                             .eigenvalues()
                             .minCoeff();
    if (least >= -kRounding)
        return {};
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "The coefficients of recipe key uncertainty.correlations contradict each other (their matrix has the eigenvalue %1, it needs none below 0): what goes along with one quantity goes along with those that this one goes along with. Correct them."),
            {numberText(least, 3)}});
}

} // namespace dyncal
