// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/import_view.h"

#include <QTableWidget>

namespace dyncal {

/// The first rows of a text table as they are read: cells that are no numbers are marked, the
/// column of times is grey. The head of a column says what it is: times, or which shot.
class ImportPreviewTable : public QTableWidget
{
    Q_OBJECT

public:
    explicit ImportPreviewTable(QWidget *parent = nullptr);
    void setPreview(const TextPreview &preview);

    /// Cells of the rows on show that are marked.
    int markedCells() const { return m_marked; }

private:
    void fillRow(int row, const std::vector<std::string> &cells, const TextPreview &preview);
    int m_marked = 0;
};

} // namespace dyncal
