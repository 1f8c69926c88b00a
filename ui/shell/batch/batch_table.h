// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/batch/batch_filter.h"
#include "ui/shell/batch/batch_model.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace dyncal {

/// The sensors of a batch, with the fields that say which of them are shown.
class BatchTable : public QWidget
{
    Q_OBJECT

public:
    explicit BatchTable(QWidget *parent);

    void setMoment(const BatchMoment &moment);
    void showWords(); ///< in the language of the moment
    std::optional<std::size_t> selected() const; ///< position in the plan

signals:
    void selectionChanged();
    void activated(std::size_t sensor); ///< double-clicked, or Return; position in the plan

private:
    void buildView();
    void buildFields();
    void fillStates();

    BatchModel m_model;
    BatchFilter m_filter;
    QTableView *m_view;
    QLineEdit *m_text;
    QComboBox *m_state;
    QLabel *m_tally;
};

} // namespace dyncal
