// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/checks_page.h"

#include "ui/stages/check_rows.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/value_table.h"

#include <QLabel>

namespace dyncal {

ChecksPage::ChecksPage(Session &session)
    : StagePage(session,
        {"checksPage", tr("Checks"),
            tr("What is known in two independent ways is compared, within its combined uncertainty.")},
        Page::Checks)
{
    m_summary = new QLabel(this);
    m_summary->setObjectName("checkSummary");
    m_summary->setWordWrap(true);
    m_table = new ValueTable("checkTable", tr("Comparisons"), this);
    content()->addWidget(m_summary);
    content()->addWidget(m_table, 1);
    auto *note = new QLabel(
        tr("Two ways contradict each other from 3.6 combined standard uncertainties on. \"Smallest fault seen\" is found in nine of ten cases; what is smaller may pass unseen. A comparison that could not be made proves nothing."),
        this);
    note->setObjectName("checkNote");
    note->setWordWrap(true);
    inspector()->addWide(note);
}

void ChecksPage::showResults()
{
    const auto checks = results().checks;
    m_table->setValues(checkHeaders(), checks ? checkRows(checks->checks) : QVector<QStringList>());
    m_summary->setText(checks ? checkSummary(checks->checks) : QString());
}

} // namespace dyncal
