// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/unrest.h"

#include "core/signal/level_statistics.h"

#include <algorithm>
#include <cmath>

namespace dyncal {
namespace {

constexpr Index kPieces = 40;
constexpr Index kFewestPieces = 8;
constexpr Index kLeastPiece = 32; ///< samples
constexpr Index kSoftPart = 8; ///< of a piece at the end, in which a response may begin softly
constexpr Index kLeastMeans = 8; ///< of a piece
constexpr Index kScale = 4; ///< from one number of averaged samples to the next
constexpr double kQuantile = 0.8;
constexpr double kNormalQuantile = 1.2816; ///< that 0.8 of normal values stay within, +-
constexpr double kUpperQuantile = 0.7; ///< of the pieces: vibration that is always there differs
                                       ///< from piece to piece
constexpr double kLeastRatio = 1.5;
constexpr double kSigmas = 10.0;
constexpr double kSigmasOfFew = 12.0; ///< where a piece has few means, and its size is uncertain
constexpr Index kFewMeans = 64;

double quantileOf(Eigen::VectorXd values, double share)
{
    const auto at
        = values.begin() + static_cast<Index>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Standard deviation about the middle, by what four fifths of the values stay within.
double sizeOf(const Eigen::VectorXd &values)
{
    return quantileOf((values.array() - median(values)).abs(), kQuantile) / kNormalQuantile;
}

/// How far the largest of the sizes stands above what all of them are like, as a share of what
/// would stand out; and its place.
struct Largest
{
    Index piece = 0;
    double excess = 0.0;
    Unrest unrest;
};

Largest largestOf(const Eigen::VectorXd &sizes, double sigmas, double least)
{
    Largest largest;
    const double size = sizes.maxCoeff(&largest.piece);
    const double usual = median(sizes);
    const double upper = quantileOf(sizes, kUpperQuantile);
    const double sd = kNormalSdPerMad * median((sizes.array() - usual).abs());
    const double limit = std::max(kLeastRatio * upper, upper + sigmas * sd);
    const double own = std::sqrt(std::max(0.0, size * size - usual * usual));
    largest.unrest = {0, size, usual};
    if (size > limit && own > least)
        largest.excess = limit > 0.0 ? size / limit : HUGE_VAL;
    return largest;
}

} // namespace

std::optional<Unrest> unrestBefore(const Eigen::Ref<const Eigen::VectorXd> &before, double least)
{
    const Index piece = std::max(before.size() / kPieces, kLeastPiece);
    const Index end = before.size() - piece / kSoftPart;
    const Index pieces = end / piece;
    if (pieces < kFewestPieces)
        return std::nullopt;
    // One more piece holds the first samples, of which the others may leave out some.
    const auto beginOf
        = [&](Index i) { return std::max(end - (pieces + 1 - i) * piece, Index(0)); };
    Largest found;
    for (Index samples = 1; kLeastMeans * samples <= piece; samples *= kScale) {
        Eigen::VectorXd sizes(pieces + 1);
        for (Index i = 0; i <= pieces; ++i)
            sizes[i] = sizeOf(meansOf(before.segment(beginOf(i), piece), samples));
        Largest largest
            = largestOf(sizes, piece < kFewMeans * samples ? kSigmasOfFew : kSigmas, least);
        largest.unrest.begin = beginOf(largest.piece);
        if (largest.excess > found.excess)
            found = largest;
    }
    return found.excess > 0.0 ? std::optional(found.unrest) : std::nullopt;
}

} // namespace dyncal
