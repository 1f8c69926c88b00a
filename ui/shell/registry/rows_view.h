// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QVariantList>
#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;
class QTableView;

namespace dyncal {

/// In the tables of the registry; what is longer is cut.
inline constexpr int kWidestColumn_chars = 44;

/// A table to look things up in: a line of text above it leaves the rows that hold it, a title
/// sorts, and a count says how many are shown. Numbers sort as numbers.
class RowsView : public QWidget
{
    Q_OBJECT

public:
    /// The table is named `name`, the line above it `name` + "Text".
    RowsView(const QString &name, QWidget *parent);

    void setTitles(const QStringList &titles, const QString &accessibleName);
    void setRows(const std::vector<QVariantList> &rows); ///< a cell for each title
    /// Position in the rows as they were given; -1: none is selected.
    int selected() const;
    const QStandardItemModel &rows() const { return m_rows; }

signals:
    void selectionChanged();

private:
    void showCount();

    QStandardItemModel m_rows;
    QSortFilterProxyModel m_filter;
    QLineEdit *m_text;
    QLabel *m_count;
    QTableView *m_view;
};

} // namespace dyncal
