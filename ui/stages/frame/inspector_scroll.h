// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/layout_scale.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace dyncal {

/// As wide as its inspector ever needed: it scrolls up and down only, and a value that gets shorter
/// moves nothing.
class InspectorScroll : public QScrollArea
{
public:
    explicit InspectorScroll(QWidget *inspector)
    {
        setWidget(inspector);
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus); // keys belong to its controls
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    }

    QSize minimumSizeHint() const override
    {
        const QSize least = QScrollArea::minimumSizeHint();
        return {std::max(m_least, widthOfInspector()), least.height()};
    }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        const bool isFiltered = QScrollArea::eventFilter(watched, event);
        if (watched == widget() && event->type() == QEvent::LayoutRequest
            && widthOfInspector() > m_least) {
            m_least = widthOfInspector();
            updateGeometry();
        }
        return isFiltered;
    }

    void changeEvent(QEvent *event) override
    {
        QScrollArea::changeEvent(event);
        if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
            m_least = 0;
    }

private:
    int widthOfInspector() const
    {
        const int bar = verticalScrollBar()->sizeHint().width() + scale::kSmall;
        return widget() ? widget()->minimumSizeHint().width() + bar : 0;
    }

    int m_least = 0;
};

} // namespace dyncal
