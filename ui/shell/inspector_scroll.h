// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QScrollArea>
#include <QScrollBar>

namespace dyncal {

/// As wide as its inspector needs: it scrolls up and down only.
class InspectorScroll : public QScrollArea
{
public:
    explicit InspectorScroll(QWidget *inspector)
    {
        setWidget(inspector);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    }

    QSize minimumSizeHint() const override
    {
        const int bar = verticalScrollBar()->sizeHint().width();
        const QSize least = QScrollArea::minimumSizeHint();
        return {
            widget() ? widget()->minimumSizeHint().width() + bar : least.width(), least.height()};
    }
};

} // namespace dyncal
