// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/hankel/hankel_decomposition.h"

#include "core/base/number_text.h"
#include "core/base/svd.h"
#include "core/base/tall_matrix.h"
#include "core/realization/hankel/hankel_operator.h"
#include "core/realization/hankel/hankel_triplets.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dyncal {
namespace {

/// Beyond this many rows Lanczos is faster even for 120 triplets (70 ms for three shots).
constexpr Index kDenseRows = 350;

struct Shape
{
    Index rows = 0;
    std::vector<Index> columns; ///< per series
    Index kept = 0; ///< singular values wanted
};

Result<Shape> chooseShape(const ModelInput &input, const RealizationSettings &settings)
{
    Shape shape;
    const Index length
        = input.treatment == ResponseTreatment::Differenced ? input.samples - 1 : input.samples;
    shape.rows = settings.rows.value.value_or(length / 2 - 1);
    if (shape.rows < 2 || shape.rows > length - 2) {
        return fail(ErrorKind::Usage,
            Message{
                DYNCAL_TEXT("core",
                    "Hankel matrix: %1 rows do not fit a model input of %2 samples; choose 2 to %3."),
                {std::to_string(shape.rows), std::to_string(length), std::to_string(length - 2)}});
    }
    Index total = 0;
    for (std::size_t i = 0; i < input.series.size(); ++i) {
        // The listing's matrix is square and leaves the last samples of the series out.
        shape.columns.push_back(isThesisMode(input) && settings.rows.isAuto() ? shape.rows
                : isThesisMode(input)                                         ? length - shape.rows
                                      : length - shape.rows + 1);
        total += shape.columns.back();
    }
    shape.kept = std::min({settings.maxOrder, shape.rows, total});
    return shape;
}

std::vector<HankelOperator> operators(const ModelInput &input, const Shape &shape,
    const std::vector<double> &weights, bool projectOnes)
{
    std::vector<HankelOperator> list;
    list.reserve(input.series.size());
    for (std::size_t i = 0; i < input.series.size(); ++i) {
        list.emplace_back(hankelSequence(input.series[i], input.treatment, weights[i]), shape.rows,
            shape.columns[i], projectOnes);
    }
    return list;
}

/// What the thesis's formulas need beside U and the singular values (eq 3.22).
void keepThesisParts(const Eigen::VectorXd &y, const Shape &shape, const Eigen::MatrixXd &right,
    HankelDecomposition &result)
{
    const HankelOperator shifted(y.tail(y.size() - 1), shape.rows, shape.columns.front(), false);
    Eigen::MatrixXd product(shape.rows, right.cols());
    for (Index k = 0; k < right.cols(); ++k)
        product.col(k) = shifted.times(right.col(k));
    result.shiftedCore = result.leftVectors.transpose() * product;
    result.firstRightRow = right.row(0);
}

SingularTriplets denseTriplets(
    const std::vector<HankelOperator> &blocks, bool needsRight, Index count)
{
    if (!needsRight) {
        const LeftSvd svd = leftSvd(denseHankel(blocks));
        return {svd.singularValues.head(count), svd.left.leftCols(count), {}, count};
    }
    const ThinSvd svd = thinSvd(denseHankel(blocks));
    return {
        svd.singularValues.head(count), svd.left.leftCols(count), svd.right.leftCols(count), count};
}

void keep(SingularTriplets &&triplets, HankelDecomposition &result)
{
    const Index r = result.rows;
    result.singularValues = std::move(triplets.singularValues);
    result.leftVectors = std::move(triplets.left);
    result.converged = triplets.converged;
    result.shiftGram
        = innerProducts(result.leftVectors.topRows(r - 1), result.leftVectors.bottomRows(r - 1));
}

/// Largest singular values of matrices of the same shape built from the pre-trigger noise, up to
/// kDraws, as many as the noise record allows.
std::vector<double> noiseTops(const ModelInput &input, const Shape &shape,
    const HankelDecomposition &result, const JobControl &control)
{
    constexpr Index kDraws = 12;
    const Index length = shape.rows + shape.columns.front() - 1;
    Index longest = std::numeric_limits<Index>::max();
    for (const ModelSeries &series : input.series)
        longest = std::min(longest, series.noise.size());
    std::vector<double> tops;
    for (Index draw = 0; draw < std::min(kDraws, (longest - 1) / length); ++draw) {
        if (control.stopRequested())
            break;
        std::vector<HankelOperator> blocks;
        for (std::size_t i = 0; i < input.series.size(); ++i) {
            ModelSeries noise;
            noise.y = input.series[i].noise.segment(draw * length, length + 1);
            blocks.emplace_back(
                hankelSequence(noise, input.treatment, result.seriesWeights[i]).head(length),
                shape.rows, shape.columns[i], result.onesProjected);
        }
        tops.push_back(largestSingularValue(blocks, control));
    }
    return tops;
}

/// Median and 95 % point of what noise alone would give; if the record is too short, by the formula
/// share * sqrt(2 m ln m) (docs/method/hankel.md; the Marchenko-Pastur edge does not hold for
/// Hankel matrices).
void setNoiseFloor(const ModelInput &input, const Shape &shape, const JobControl &control,
    HankelDecomposition &result)
{
    constexpr double kShare_p95 = 0.75;
    constexpr double kShare_median = 0.65;
    const std::vector<double> tops = noiseTops(input, shape, result, control);
    if (tops.size() < 3) {
        double mean = 0.0;
        for (std::size_t i = 0; i < input.series.size(); ++i)
            mean += input.series[i].noiseSd / result.seriesWeights[i];
        mean /= static_cast<double>(input.series.size());
        const double m = std::sqrt(static_cast<double>(shape.rows * result.columns));
        const double edge = mean * std::sqrt(2.0 * m * std::log(m));
        result.noiseFloor_p95 = kShare_p95 * edge;
        result.noiseFloor_median = kShare_median * edge;
        return;
    }
    // With few draws mean and mean + 1.645 sd scatter less than median and maximum.
    const Eigen::Map<const Eigen::ArrayXd> values(tops.data(), static_cast<Index>(tops.size()));
    const double mean = values.mean();
    const double sd
        = std::sqrt((values - mean).square().sum() / static_cast<double>(tops.size() - 1));
    result.noiseFloor_median = mean;
    result.noiseFloor_p95 = mean + 1.645 * sd;
}

} // namespace

Eigen::VectorXd hankelSequence(
    const ModelSeries &series, ResponseTreatment treatment, double weight)
{
    if (treatment == ResponseTreatment::Differenced)
        return (series.y.tail(series.y.size() - 1) - series.y.head(series.y.size() - 1)) / weight;
    return series.y / weight;
}

Result<HankelDecomposition> decomposeHankel(
    const ModelInput &input, const RealizationSettings &settings, const JobControl &control)
{
    const auto shape = chooseShape(input, settings);
    if (!shape)
        return tl::unexpected(shape.error());

    HankelDecomposition result;
    result.rows = shape->rows;
    for (const Index columns : shape->columns)
        result.columns += columns;
    result.onesProjected = input.treatment == ResponseTreatment::StepDeflated;
    // A single series needs no scaling, and the thesis's singular values are those of the raw one.
    for (const ModelSeries &series : input.series) {
        result.seriesWeights.push_back(
            input.series.size() > 1 && series.noiseSd > 0.0 ? series.noiseSd : 1.0);
    }
    const bool isDense
        = shape->rows <= kDenseRows || shape->kept > BlockLanczos::mostPairs(shape->rows);
    result.method = isDense ? "dense" : "lanczos";
    setNoiseFloor(input, *shape, control, result);

    const std::vector<HankelOperator> blocks
        = operators(input, *shape, result.seriesWeights, result.onesProjected);
    using Right = HankelTriplets::Right;
    Result<SingularTriplets> triplets = isDense
        ? denseTriplets(blocks, isThesisMode(input), shape->kept)
        : HankelTriplets(blocks).leading(
            shape->kept, isThesisMode(input) ? Right::Wanted : Right::NotWanted, control);
    if (!triplets)
        return tl::unexpected(triplets.error());
    if (control.stopRequested())
        return fail(ErrorKind::Cancelled, {});
    const Eigen::MatrixXd right = std::move(triplets->right);
    keep(std::move(*triplets), result);
    if (isThesisMode(input)) {
        keepThesisParts(
            hankelSequence(input.series.front(), input.treatment, 1.0), *shape, right, result);
    }
    return result;
}

} // namespace dyncal
