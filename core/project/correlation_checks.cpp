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

/// The inputs of that name: a typed velocity is one for each shot.
std::vector<std::string> inputsOf(const std::string &name, Index velocities)
{
    std::vector<std::string> inputs{name};
    for (Index shot = 2; name == "velocity_m_s" && shot <= velocities; ++shot)
        inputs.push_back(name + std::to_string(shot));
    return inputs;
}

/// Entries between all inputs of the one and all of the other.
void correlate(const std::vector<Index> &some, const std::vector<Index> &others, double coefficient,
    Eigen::MatrixXd &matrix)
{
    for (const Index a : some)
        for (const Index b : others)
            if (a != b)
                matrix(a, b) = matrix(b, a) = coefficient;
}

Eigen::MatrixXd matrixOf(const UncertaintySettings &settings, Index velocities)
{
    std::vector<std::string> names;
    const auto placesOf = [&](const std::string &name) {
        std::vector<Index> places;
        for (const std::string &input : inputsOf(name, velocities)) {
            if (std::ranges::find(names, input) == names.end())
                names.push_back(input);
            places.push_back(std::ranges::find(names, input) - names.begin());
        }
        return places;
    };
    for (const CorrelationEntry &entry : settings.correlations)
        for (const std::string &name : {entry.quantity, entry.with})
            placesOf(name);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(std::ssize(names), std::ssize(names));
    for (const CorrelationEntry &entry : settings.correlations)
        correlate(placesOf(entry.quantity), placesOf(entry.with), entry.coefficient, matrix);
    return matrix;
}

} // namespace

Result<void> checkCorrelations(const UncertaintySettings &settings, Index velocities)
{
    constexpr double kRounding = 1e-9;
    if (settings.correlations.empty())
        return {};
    for (const CorrelationEntry &entry : settings.correlations)
        if (const Result<void> checked = checkOnce(entry, settings); !checked)
            return checked;
    const double least
        = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrixOf(settings, velocities))
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
