// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/batch/batch_table.h"

#include "ui/stages/frame/rows_table.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QTableView>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kWidthOfColumns_chars[BatchModel::kColumns]{20, 17, 34, 30, 34, 32, 40};

} // namespace

BatchTable::BatchTable(QWidget *parent)
    : QWidget(parent)
    , m_filter(m_model, this)
    , m_view(new QTableView(this))
    , m_text(new QLineEdit(this))
    , m_state(new QComboBox(this))
    , m_tally(new QLabel(this))
{
    buildView();
    buildFields();
    auto *fields = new QHBoxLayout;
    fields->addWidget(m_text, 1);
    fields->addWidget(m_state);
    fields->addWidget(m_tally, 2);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(fields);
    column->addWidget(m_view, 1);
    showWords();
}

void BatchTable::buildView()
{
    m_view->setObjectName("batchTable");
    m_view->setModel(&m_filter);
    showAsRows(*m_view);
    m_view->sortByColumn(BatchModel::State, Qt::AscendingOrder);
    for (int column = 0; column < BatchModel::kColumns; ++column)
        m_view->setColumnWidth(
            column, kWidthOfColumns_chars[column] * fontMetrics().averageCharWidth());
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &BatchTable::selectionChanged);
    connect(m_view, &QTableView::activated, this, [this](const QModelIndex &shown) {
        emit activated(static_cast<std::size_t>(m_filter.mapToSource(shown).row()));
    });
}

void BatchTable::buildFields()
{
    m_text->setObjectName("batchText");
    m_text->setClearButtonEnabled(true);
    m_state->setObjectName("batchState");
    m_tally->setObjectName("batchTally");
    connect(m_text, &QLineEdit::textChanged, &m_filter, &BatchFilter::setText);
    connect(m_state, &QComboBox::currentIndexChanged, this, [this](int index) {
        m_filter.setState(index > 0 ? std::optional(kShownStates[index - 1]) : std::nullopt);
    });
}

void BatchTable::setMoment(const BatchMoment &moment)
{
    m_model.setMoment(moment);
    m_tally->setText(moment.plan ? batchTallyText(moment) : QString());
}

void BatchTable::showWords()
{
    m_view->setAccessibleName(tr("Sensors of the batch"));
    m_text->setPlaceholderText(tr("Sensor, finding or reason"));
    m_text->setAccessibleName(tr("Show only sensors whose name, finding or reason holds this"));
    m_state->setAccessibleName(tr("Show only sensors of this state"));
    fillStates();
    m_model.showWords();
    m_tally->setText(m_model.moment().plan ? batchTallyText(m_model.moment()) : QString());
}

void BatchTable::fillStates()
{
    const QSignalBlocker quiet(m_state);
    const int before = std::max(m_state->currentIndex(), 0);
    m_state->clear();
    m_state->addItem(tr("All states"));
    for (const ShownState state : kShownStates)
        m_state->addItem(stateText(state));
    m_state->setCurrentIndex(before);
}

std::optional<std::size_t> BatchTable::selected() const
{
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    if (rows.isEmpty())
        return std::nullopt;
    return static_cast<std::size_t>(m_filter.mapToSource(rows.first()).row());
}

} // namespace dyncal
