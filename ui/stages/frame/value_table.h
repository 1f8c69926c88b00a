// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QTableWidget>

namespace dyncal {

/// A table of values to read, select and copy (Ctrl+C, tab separated). Keeps its scroll position
/// and selection when the values change.
class ValueTable : public QTableWidget
{
    Q_OBJECT

public:
    ValueTable(const QString &objectName, const QString &accessibleName, QWidget *parent = nullptr);

    void setValues(const QStringList &headers, const QVector<QStringList> &rows);
    QString selectedText() const; ///< the selected cells, or all without a selection

protected:
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// Columns share the width when there is enough, and scroll when there is not.
    void fitColumns();
};

} // namespace dyncal
