// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/dashes.h"

#include <cmath>
#include <numeric>

namespace dyncal {

namespace {

/// Longer stretches occur only in views that show almost nothing of the curve; they are drawn
/// solid.
constexpr double kLongest_px = 5000.0;
constexpr double kShortest_px = 1e-3; ///< a shorter rest of a dash counts as nothing

} // namespace

Dashes::Dashes(QVector<qreal> pattern)
    : m_pattern(std::move(pattern))
    , m_period(std::accumulate(m_pattern.begin(), m_pattern.end(), 0.0))
    , m_left(m_pattern[0])
{
}

void Dashes::add(const QPointF &from, const QPointF &to, const QRectF &clip, QVector<QLineF> &parts)
{
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (!std::isfinite(length) || !(length > 0.0))
        return;
    const QRectF box = QRectF(from, to).normalized();
    const bool outside = box.right() < clip.left() || box.left() > clip.right()
        || box.bottom() < clip.top() || box.top() > clip.bottom();
    if (outside || length > kLongest_px) {
        skip(std::fmod(length, m_period));
        if (!outside)
            parts.append(QLineF(from, to));
        return;
    }
    for (double done = 0.0; done < length;) {
        const double end = std::min(length, done + m_left);
        if (m_at % 2 == 0)
            parts.append(QLineF(from + way * (done / length), from + way * (end / length)));
        skip(end - done);
        done = end;
    }
}

void Dashes::skip(double length)
{
    m_left -= length;
    while (m_left < kShortest_px) {
        m_at = (m_at + 1) % static_cast<int>(m_pattern.size());
        m_left += m_pattern[m_at];
    }
}

} // namespace dyncal
