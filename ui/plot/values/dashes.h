// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QLineF>
#include <QRectF>
#include <QVector>

namespace dyncal {

/// Cuts a line into the parts of a dash pattern (lengths in pixels, drawn and gap in turn).
class Dashes
{
public:
    explicit Dashes(QVector<qreal> pattern);

    /// Adds the drawn parts of a stretch. A stretch outside of `clip` adds none, but its length
    /// counts.
    void add(const QPointF &from, const QPointF &to, const QRectF &clip, QVector<QLineF> &parts);

private:
    void skip(double length);

    QVector<qreal> m_pattern;
    double m_period;
    int m_at = 0; ///< in the pattern; even: drawn
    double m_left; ///< of that part
};

} // namespace dyncal
