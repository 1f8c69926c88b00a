// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signal/spectral_sums.h"

#include "core/base/constants.h"
#include "core/base/lanes.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace dyncal {
namespace {

constexpr Index kPairs = 256; ///< of a block
constexpr Index kBlock = 2 * kPairs; ///< samples
constexpr Index kGroup = 4; ///< blocks that share a load of the tables
constexpr Index kBlocksOfPart = 32; ///< from one anchor
constexpr Index kPart = kBlocksOfPart * kBlock;

/// What all parts of the record share; one column for each frequency, and where their number is
/// odd one of zeros.
struct Tables
{
    explicit Tables(const Eigen::Ref<const Eigen::VectorXd> &turns);

    Eigen::VectorXd turns;
    Eigen::MatrixXd cosines; ///< at the distances of the pairs from the middle of their block
    Eigen::MatrixXd sines;
    Eigen::MatrixXcd blocks; ///< from the first sample of a part to the middle of each block
};

Tables::Tables(const Eigen::Ref<const Eigen::VectorXd> &all)
    : turns(all)
    , cosines(Eigen::MatrixXd::Zero(kPairs, all.size() + all.size() % 2))
    , sines(cosines)
    , blocks(kBlocksOfPart, all.size())
{
    for (Index k = 0; k < all.size(); ++k) {
        for (Index i = 0; i < kPairs; ++i) {
            const std::complex<double> turn = turned(all[k], static_cast<double>(i) + 0.5);
            cosines(i, k) = turn.real();
            sines(i, k) = turn.imag();
        }
        for (Index b = 0; b < kBlocksOfPart; ++b)
            blocks(b, k) = turned(all[k], static_cast<double>(b * kBlock + kPairs) - 0.5);
    }
}

using Paired = Eigen::Matrix<double, kPairs, kGroup>;

/// Sums and differences of the pairs of a group of blocks; samples behind the end count as 0.
void pairUp(const Eigen::Ref<const Eigen::VectorXd> &y, Index first, Paired &sums, Paired &rests)
{
    const Index there = std::clamp<Index>(y.size() - first, 0, kGroup * kBlock);
    Eigen::Matrix<double, kBlock, kGroup> samples;
    samples.reshaped().head(there) = y.segment(first, there);
    samples.reshaped().tail(kGroup * kBlock - there).setZero();
    const auto later = samples.bottomRows<kPairs>();
    const auto earlier = samples.topRows<kPairs>().colwise().reverse();
    sums = later + earlier;
    rests = later - earlier;
}

/// Inner products of kGroup columns at `data` with two neighbouring ones at `table`, each in four
/// partial sums: products[column + kGroup * table's column].
DYNCAL_INLINE void innerProducts(const double *data, const double *table, double *products)
{
    Lanes sums[2 * kGroup] = {};
    for (Index i = 0; i < kPairs; i += kLanes) {
        const Lanes one = *lanes(table + i);
        const Lanes other = *lanes(table + kPairs + i);
        for (Index b = 0; b < kGroup; ++b) {
            const Lanes values = *lanes(data + b * kPairs + i);
            sums[b] += values * one;
            sums[kGroup + b] += values * other;
        }
    }
    for (Index b = 0; b < 2 * kGroup; ++b)
        products[b] = (sums[b][0] + sums[b][1]) + (sums[b][2] + sums[b][3]);
}

DYNCAL_AVX2 void innerProductsAvx2(const double *data, const double *table, double *products)
{
    innerProducts(data, table, products);
}

void innerProductsAnywhere(const double *data, const double *table, double *products)
{
    innerProducts(data, table, products);
}

/// Adds what a group of blocks has to the sums of a part, which begin at its first sample.
void addGroup(const Tables &tables, const Paired &sums, const Paired &rests, Index firstBlock,
    Eigen::Ref<Eigen::VectorXcd> total)
{
    static const auto products = hasAvx2() ? innerProductsAvx2 : innerProductsAnywhere;
    double re[2 * kGroup];
    double im[2 * kGroup];
    for (Index k = 0; k < total.size(); ++k) {
        if (k % 2 == 0) {
            products(sums.data(), tables.cosines.col(k).data(), re);
            products(rests.data(), tables.sines.col(k).data(), im);
        }
        for (Index b = 0; b < kGroup; ++b) {
            const Index at = b + kGroup * (k % 2);
            total[k] += tables.blocks(firstBlock + b, k) * std::complex<double>(re[at], im[at]);
        }
    }
}

/// The sums of the part that begins at sample `first`.
Eigen::VectorXcd sumsOfPart(
    const Eigen::Ref<const Eigen::VectorXd> &y, Index first, const Tables &tables)
{
    Eigen::VectorXcd total = Eigen::VectorXcd::Zero(tables.turns.size());
    Paired sums;
    Paired rests;
    for (Index block = 0; block < kBlocksOfPart; block += kGroup) {
        if (first + block * kBlock >= y.size())
            break;
        pairUp(y, first + block * kBlock, sums, rests);
        addGroup(tables, sums, rests, block, total);
    }
    for (Index k = 0; k < total.size(); ++k)
        total[k] *= turned(tables.turns[k], static_cast<double>(first));
    return total;
}

} // namespace

std::complex<double> turned(double turnsPerSample, double samples)
{
    const double product = turnsPerSample * samples;
    const double turns
        = product - std::nearbyint(product) + std::fma(turnsPerSample, samples, -product);
    return std::polar(1.0, -kTwoPi * turns);
}

Eigen::VectorXcd spectralSums(
    const Eigen::Ref<const Eigen::VectorXd> &y, const Eigen::Ref<const Eigen::VectorXd> &turns)
{
    constexpr double kWorthAThread = 4e6; // products: about a millisecond
    const Tables tables(turns);
    const Index parts = (y.size() + kPart - 1) / kPart;
    const bool isLong
        = static_cast<double>(y.size()) * static_cast<double>(turns.size()) > kWorthAThread;
    Eigen::MatrixXcd ofParts(turns.size(), parts);
    forEachPart(parts, isLong,
        [&](Index part) { ofParts.col(part) = sumsOfPart(y, part * kPart, tables); });
    return ofParts.rowwise().sum();
}

} // namespace dyncal
