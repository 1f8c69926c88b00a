// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/page_stack.h"

#include "ui/stages/frame/layout_scale.h"

#include <QPaintEvent>
#include <QPainter>

namespace dyncal {

namespace {

constexpr double kPale = 0.45;

} // namespace

PageStack::PageStack(QWidget *parent)
    : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Minimum);
}

void PageStack::setPages(std::vector<QImage> pages)
{
    m_pages = std::move(pages);
    setMinimumHeight(heightOfPages(width()));
    updateGeometry();
    update();
}

void PageStack::setPale(bool isPale)
{
    m_isPale = isPale;
    update();
}

int PageStack::heightOf(const QImage &page, int width) const
{
    return page.width() < 1
        ? 0
        : static_cast<int>(static_cast<qint64>(page.height()) * width / page.width());
}

int PageStack::heightOfPages(int width) const
{
    int height = 0;
    for (const QImage &page : m_pages)
        height += heightOf(page, width) + scale::kMedium;
    return height;
}

QRect PageStack::areaOf(std::size_t page) const
{
    int top = 0;
    for (std::size_t i = 0; i < page; ++i)
        top += heightOf(m_pages[i], width()) + scale::kMedium;
    return {0, top, width(), heightOf(m_pages[page], width())};
}

int PageStack::pageAt(int y) const
{
    for (std::size_t i = 0; i < m_pages.size(); ++i)
        if (y <= areaOf(i).bottom() + scale::kMedium)
            return static_cast<int>(i);
    return static_cast<int>(m_pages.size()) - 1;
}

void PageStack::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        const QRect area = areaOf(i);
        if (!area.intersects(event->rect()))
            continue;
        painter.fillRect(area, Qt::white); // paper, whatever the theme
        painter.setOpacity(m_isPale ? kPale : 1.0);
        painter.drawImage(area, m_pages[i]);
        painter.setOpacity(1.0);
        painter.setPen(palette().color(QPalette::Mid));
        painter.drawRect(area.adjusted(0, 0, -1, -1));
    }
}

void PageStack::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    setMinimumHeight(heightOfPages(width()));
}

} // namespace dyncal
