// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/problem_panel.h"

#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>

namespace dyncal {

namespace {

constexpr int kMostHeight = 190; ///< the work beside it needs room

enum Column { File, Sentence, Action, ColumnCount };

QString fileName(const FileProblem &problem)
{
    return shownText(QFileInfo(rawText(problem.path)).fileName());
}

/// The row shows the name already; the full path would only make the sentence long.
QString sentence(const FileProblem &problem)
{
    return translated(problem.error.message).replace(shownText(problem.path), fileName(problem));
}

} // namespace

ProblemPanel::ProblemPanel(QWidget *parent)
    : QWidget(parent)
    , m_summary(new QLabel(this))
    , m_table(new QTableWidget(0, ColumnCount, this))
{
    setObjectName("problemPanel");
    m_summary->setObjectName("problemSummary");
    m_table->setObjectName("problemTable");
    m_table->setAccessibleName(tr("Files that could not be read"));
    m_table->setHorizontalHeaderLabels({tr("File"), tr("What is wrong, and what to do"), {}});
    m_table->verticalHeader()->hide();
    m_table->setTabKeyNavigation(false);
    m_table->setMaximumHeight(kMostHeight);
    m_table->setWordWrap(true);
    m_table->setTextElideMode(Qt::ElideMiddle);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Sentence, QHeaderView::Stretch);
    // Wrapped text takes the height it needs at the width there is.
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);

    auto *line = new QHBoxLayout;
    line->addWidget(m_summary, 1);
    const auto addButton = [&](const QString &name, const QString &text, auto action) {
        auto *button = new QPushButton(text, this);
        button->setObjectName(name);
        connect(button, &QPushButton::clicked, this, action);
        line->addWidget(button);
    };
    addButton("retryProblems", tr("Try again"), [this] { emit retryRequested(paths()); });
    addButton("copyProblems", tr("Copy all"), [this] { copy(); });
    addButton("dismissProblems", tr("Dismiss"), [this] {
        m_problems.clear();
        showProblems();
    });
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 6);
    column->addLayout(line);
    column->addWidget(m_table);
}

void ProblemPanel::update(
    const std::vector<std::string> &tried, const std::vector<FileProblem> &problems)
{
    std::erase_if(m_problems, [&](const FileProblem &problem) {
        return std::ranges::find(tried, problem.path) != tried.end();
    });
    m_problems.insert(m_problems.end(), problems.begin(), problems.end());
    showProblems();
}

void ProblemPanel::showProblems()
{
    m_summary->setText(tr("%n file(s) could not be read. All others are open.", nullptr,
        static_cast<int>(m_problems.size())));
    m_table->setRowCount(0);
    m_table->setRowCount(static_cast<int>(m_problems.size()));
    for (int row = 0; row < m_table->rowCount(); ++row)
        addRow(row, m_problems[static_cast<std::size_t>(row)]);
    emit changed();
}

void ProblemPanel::addRow(int row, const FileProblem &problem)
{
    const QString path = rawText(problem.path);
    auto *name = new QTableWidgetItem(fileName(problem));
    name->setToolTip(shownText(path));
    m_table->setItem(row, File, name);
    m_table->setItem(row, Sentence, new QTableWidgetItem(sentence(problem)));
    if (!QFileInfo(path).isFile())
        return;
    auto *button = new QPushButton(tr("Import settings..."), m_table);
    button->setObjectName(QString("importProblem%1").arg(row + 1));
    button->setAccessibleName(tr("Import settings of %1").arg(fileName(problem)));
    connect(
        button, &QPushButton::clicked, this, [this, path] { emit importRequested(path); },
        Qt::QueuedConnection);
    m_table->setCellWidget(row, Action, button);
}

QStringList ProblemPanel::paths() const
{
    QStringList paths;
    for (const FileProblem &problem : m_problems)
        paths << rawText(problem.path);
    return paths;
}

void ProblemPanel::copy() const
{
    QStringList lines;
    for (const FileProblem &problem : m_problems)
        lines << QStringList{rawText(problem.error.findingId), pasted(rawText(problem.path)),
            pasted(translated(problem.error.message))}
                     .join('\t');
    QGuiApplication::clipboard()->setText(lines.join('\n'));
}

} // namespace dyncal
