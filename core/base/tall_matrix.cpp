// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/tall_matrix.h"

#include "core/base/index.h"
#include "core/base/lanes.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace dyncal {
namespace {

constexpr Index kPanelRows
    = 8192; ///< one part of the work: fixed, so that sums do not depend on threads
constexpr Index kCacheRows = 512; ///< of Q and W that stay in the first cache while columns pair up
constexpr Index kThreadWork
    = 1'000'000; ///< multiplications; they take much longer than starting a thread

struct View
{
    const double *data;
    Index stride;
    const double *column(Index j) const { return data + j * stride; }
};

/// Adds the products of QC columns of Q and WC of W over `rows` rows to c (column stride d).
template <int QC, int WC>
DYNCAL_INLINE void addInnerTile(View Q, View W, Index rows, double *c, Index d)
{
    Lanes sums[QC][WC] = {};
    const Index whole = rows - rows % kLanes;
    for (Index i = 0; i < whole; i += kLanes) {
        for (int a = 0; a < QC; ++a) {
            const Lanes q = *lanes(Q.column(a) + i);
            for (int b = 0; b < WC; ++b)
                sums[a][b] += q * *lanes(W.column(b) + i);
        }
    }
    for (int a = 0; a < QC; ++a) {
        for (int b = 0; b < WC; ++b) {
            double sum = (sums[a][b][0] + sums[a][b][1]) + (sums[a][b][2] + sums[a][b][3]);
            for (Index i = whole; i < rows; ++i)
                sum += Q.column(a)[i] * W.column(b)[i];
            c[a + b * d] += sum;
        }
    }
}

template <int QC>
DYNCAL_INLINE void addInnerStrip(View Q, View W, Index rows, Index columns, double *c, Index d)
{
    Index b = 0;
    for (; b + 2 <= columns; b += 2)
        addInnerTile<QC, 2>(Q, {W.column(b), W.stride}, rows, c + b * d, d);
    if (b < columns)
        addInnerTile<QC, 1>(Q, {W.column(b), W.stride}, rows, c + b * d, d);
}

DYNCAL_INLINE void addInner(View Q, Index d, View W, Index columns, Index rows, double *c)
{
    for (Index row = 0; row < rows; row += kCacheRows) {
        const Index count = std::min(kCacheRows, rows - row);
        const View w{W.data + row, W.stride};
        Index a = 0;
        for (; a + 4 <= d; a += 4)
            addInnerStrip<4>({Q.column(a) + row, Q.stride}, w, count, columns, c + a, d);
        for (; a < d; ++a)
            addInnerStrip<1>({Q.column(a) + row, Q.stride}, w, count, columns, c + a, d);
    }
}

/// w -= Q c for WC columns of W, a few columns of Q at a time.
template <int WC>
DYNCAL_INLINE void subtractTile(
    View Q, Index d, double *w, Index stride, Index rows, const double *c, Index cStride)
{
    const Index whole = rows - rows % kLanes;
    for (Index i = 0; i < whole; i += kLanes) {
        Lanes rest[WC];
        for (int b = 0; b < WC; ++b)
            rest[b] = *lanes(w + b * stride + i);
        for (Index a = 0; a < d; ++a) {
            const Lanes q = *lanes(Q.column(a) + i);
            for (int b = 0; b < WC; ++b)
                rest[b] -= q * c[a + b * cStride];
        }
        for (int b = 0; b < WC; ++b)
            *lanes(w + b * stride + i) = rest[b];
    }
    for (Index i = whole; i < rows; ++i) {
        for (int b = 0; b < WC; ++b) {
            for (Index a = 0; a < d; ++a)
                w[b * stride + i] -= Q.column(a)[i] * c[a + b * cStride];
        }
    }
}

DYNCAL_INLINE void subtract(
    View Q, Index d, double *w, Index stride, Index columns, Index rows, const double *c)
{
    constexpr Index kColumnsOfQ = 16;
    for (Index row = 0; row < rows; row += kCacheRows) {
        const Index count = std::min(kCacheRows, rows - row);
        for (Index a = 0; a < d; a += kColumnsOfQ) {
            const Index some = std::min(kColumnsOfQ, d - a);
            const View q{Q.column(a) + row, Q.stride};
            Index b = 0;
            for (; b + 4 <= columns; b += 4)
                subtractTile<4>(q, some, w + b * stride + row, stride, count, c + a + b * d, d);
            for (; b + 2 <= columns; b += 2)
                subtractTile<2>(q, some, w + b * stride + row, stride, count, c + a + b * d, d);
            for (; b < columns; ++b)
                subtractTile<1>(q, some, w + b * stride + row, stride, count, c + a + b * d, d);
        }
    }
}

void addInnerAnywhere(View Q, Index d, View W, Index columns, Index rows, double *c)
{
    addInner(Q, d, W, columns, rows, c);
}

DYNCAL_AVX2 void addInnerAvx2(View Q, Index d, View W, Index columns, Index rows, double *c)
{
    addInner(Q, d, W, columns, rows, c);
}

void subtractAnywhere(
    View Q, Index d, double *w, Index stride, Index columns, Index rows, const double *c)
{
    subtract(Q, d, w, stride, columns, rows, c);
}

DYNCAL_AVX2 void subtractAvx2(
    View Q, Index d, double *w, Index stride, Index columns, Index rows, const double *c)
{
    subtract(Q, d, w, stride, columns, rows, c);
}

} // namespace

Eigen::MatrixXd innerProducts(
    const Eigen::Ref<const Eigen::MatrixXd> &Q, const Eigen::Ref<const Eigen::MatrixXd> &W)
{
    const Index panels = (Q.rows() + kPanelRows - 1) / kPanelRows;
    const auto add = hasAvx2() ? addInnerAvx2 : addInnerAnywhere;
    std::vector<Eigen::MatrixXd> sums(static_cast<std::size_t>(panels));
    forEachPart(panels, Q.size() * W.cols() > kThreadWork, [&](Index panel) {
        const Index row = panel * kPanelRows;
        Eigen::MatrixXd &sum = sums[static_cast<std::size_t>(panel)];
        sum.setZero(Q.cols(), W.cols());
        add({Q.data() + row, Q.outerStride()}, Q.cols(), {W.data() + row, W.outerStride()},
            W.cols(), std::min(kPanelRows, Q.rows() - row), sum.data());
    });
    Eigen::MatrixXd total = Eigen::MatrixXd::Zero(Q.cols(), W.cols());
    for (const Eigen::MatrixXd &sum : sums)
        total += sum;
    return total;
}

void subtractProducts(const Eigen::Ref<const Eigen::MatrixXd> &Q,
    const Eigen::Ref<const Eigen::MatrixXd> &C, Eigen::Ref<Eigen::MatrixXd> W)
{
    const Index panels = (Q.rows() + kPanelRows - 1) / kPanelRows;
    const auto take = hasAvx2() ? subtractAvx2 : subtractAnywhere;
    const Eigen::MatrixXd packed = C;
    forEachPart(panels, Q.size() * W.cols() > kThreadWork, [&](Index panel) {
        const Index row = panel * kPanelRows;
        take({Q.data() + row, Q.outerStride()}, Q.cols(), W.data() + row, W.outerStride(), W.cols(),
            std::min(kPanelRows, Q.rows() - row), packed.data());
    });
}

Eigen::MatrixXd combineColumns(
    const Eigen::Ref<const Eigen::MatrixXd> &Q, const Eigen::Ref<const Eigen::MatrixXd> &S)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(Q.rows(), S.cols());
    subtractProducts(Q, -S, result);
    return result;
}

void rotateColumns(Eigen::Ref<Eigen::MatrixXd> Q, const Eigen::MatrixXd &S)
{
    constexpr Index kRows = 1024;
    const Index panels = (Q.rows() + kRows - 1) / kRows;
    const auto take = hasAvx2() ? subtractAvx2 : subtractAnywhere;
    const Eigen::MatrixXd negative = -S;
    forEachPart(panels, Q.size() * S.cols() > kThreadWork, [&](Index panel) {
        const Index row = panel * kRows;
        const Index rows = std::min(kRows, Q.rows() - row);
        const Eigen::MatrixXd old = Q.middleRows(row, rows);
        Q.block(row, 0, rows, S.cols()).setZero();
        take({old.data(), rows}, Q.cols(), Q.data() + row, Q.outerStride(), S.cols(), rows,
            negative.data());
    });
}

} // namespace dyncal
