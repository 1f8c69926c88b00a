// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QSplitter>

namespace dyncal {

/// Parts of a page side by side where each has room for its axes, texts and legend; else one below
/// the other, and the page scrolls. The shares of either arrangement are kept for its return.
class FoldingSplitter : public QSplitter
{
    Q_OBJECT

public:
    explicit FoldingSplitter(QWidget *parent = nullptr);

    bool isFolded() const { return orientation() == Qt::Vertical; }
    /// As wide as the widest part: it can always fold.
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    int widthOfParts() const;
    void foldOrUnfold();

    QList<int> m_otherSizes; ///< of the arrangement that is not shown
};

} // namespace dyncal
