// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/capture_reading.h"

#include <QWidget>

class QLabel;
class QTableWidget;

namespace dyncal {

/// Every file that could not be read, with what is wrong and what can be done, in one place: the
/// other files of the same drop are already open. A file leaves the list when it has been read.
class ProblemPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ProblemPanel(QWidget *parent = nullptr);

    /// What one attempt gave: `tried` files leave the list, then `problems` join it.
    void update(const std::vector<std::string> &tried, const std::vector<FileProblem> &problems);
    const std::vector<FileProblem> &problems() const { return m_problems; }

signals:
    void changed(); ///< problems came or went
    void importRequested(const QString &path); ///< the operator wants to say how it is read
    void retryRequested(const QStringList &paths);

private:
    void showProblems();
    void addRow(int row, const FileProblem &problem);
    QStringList paths() const;
    void copy() const;

    std::vector<FileProblem> m_problems;
    QLabel *m_summary;
    QTableWidget *m_table;
};

} // namespace dyncal
