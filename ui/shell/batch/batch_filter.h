// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/batch/batch_words.h"

#include <QSortFilterProxyModel>

#include <optional>

namespace dyncal {

class BatchModel;

/// Which sensors of a batch are shown, and in which order: the worst first, until a column is
/// chosen. Sensors that are alike keep the order of the plan.
class BatchFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    BatchFilter(BatchModel &model, QObject *parent);

    /// Sensors whose name, finding or reason holds the text, whatever its case.
    void setText(const QString &text);
    void setState(std::optional<ShownState> state); ///< none: all states

protected:
    bool filterAcceptsRow(int row, const QModelIndex &parent) const override;
    bool lessThan(const QModelIndex &left, const QModelIndex &right) const override;

private:
    BatchModel &m_model;
    QString m_text;
    std::optional<ShownState> m_state;
};

} // namespace dyncal
