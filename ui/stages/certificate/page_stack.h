// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QImage>
#include <QWidget>

#include <vector>

namespace dyncal {

/// Pages below one another, as wide as the widget. It shows them pale while they are of something
/// older.
class PageStack : public QWidget
{
    Q_OBJECT

public:
    explicit PageStack(QWidget *parent = nullptr);

    void setPages(std::vector<QImage> pages);
    void setPale(bool isPale);
    bool isPale() const { return m_isPale; }
    std::size_t pageCount() const { return m_pages.size(); }
    const std::vector<QImage> &pages() const { return m_pages; }
    /// Of the page that holds this height, from 0; -1 without pages.
    int pageAt(int y) const;

    int heightOfPages(int width) const; ///< of all, with what lies between them

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QRect areaOf(std::size_t page) const;
    int heightOf(const QImage &page, int width) const;

    std::vector<QImage> m_pages;
    bool m_isPale = false;
};

} // namespace dyncal
