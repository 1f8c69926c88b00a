// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QStyledItemDelegate>

namespace dyncal {

/// Under the words of a cell a bar as long as its share.
class ShareBar : public QStyledItemDelegate
{
    Q_OBJECT

public:
    static constexpr int kShareRole = Qt::UserRole; ///< 0 to 1; no bar without one

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
        const QModelIndex &index) const override;
};

} // namespace dyncal
