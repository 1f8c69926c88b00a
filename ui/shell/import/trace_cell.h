// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/channel_glance.h"

#include <QWidget>

namespace dyncal {

/// The course of a record, as small as a cell: where the step is, and whether it rings.
class TraceCell : public QWidget
{
public:
    explicit TraceCell(QWidget *parent = nullptr);
    void setGlance(const ChannelGlance &glance);

    /// The curve in a rectangle: lowest and highest of every stretch, from top to bottom the whole
    /// range of the record. Empty without samples.
    static QPolygonF outline(const ChannelGlance &glance, const QRectF &inside);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    ChannelGlance m_glance;
};

/// "step 4.19 mV, 89 times the noise"; "no step" where it does not stand out.
QString glanceText(const ChannelGlance &glance, const QString &unit);

} // namespace dyncal
