// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/folding_splitter.h"

#include <QEvent>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kColumnsOfAPart = 28; ///< letters, for a plot with labels of ticks and a legend

int leastWidth(const QWidget &part)
{
    return std::max(part.minimumWidth(), part.minimumSizeHint().width());
}

} // namespace

FoldingSplitter::FoldingSplitter(QWidget *parent)
    : QSplitter(Qt::Horizontal, parent)
{
}

QSize FoldingSplitter::minimumSizeHint() const
{
    int widest = 0;
    for (int i = 0; i < count(); ++i)
        widest = std::max(widest, leastWidth(*widget(i)));
    return {widest, QSplitter::minimumSizeHint().height()};
}

void FoldingSplitter::resizeEvent(QResizeEvent *event)
{
    foldOrUnfold();
    QSplitter::resizeEvent(event);
}

void FoldingSplitter::changeEvent(QEvent *event)
{
    QSplitter::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        foldOrUnfold();
}

int FoldingSplitter::widthOfParts() const
{
    int width = (count() - 1) * handleWidth();
    for (int i = 0; i < count(); ++i)
        width
            += std::max(leastWidth(*widget(i)), kColumnsOfAPart * fontMetrics().averageCharWidth());
    return width;
}

void FoldingSplitter::foldOrUnfold()
{
    const Qt::Orientation fitting = width() < widthOfParts() ? Qt::Vertical : Qt::Horizontal;
    if (fitting == orientation())
        return;
    const QList<int> before = sizes();
    setOrientation(fitting);
    if (m_otherSizes.size() == count())
        setSizes(m_otherSizes);
    m_otherSizes = before;
}

} // namespace dyncal
