// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/ui/shell/registry/registry_bench.h"
#include "ui/shell/registry/issue_dialog.h"

#include <QListWidget>
#include <QPointer>

namespace dyncal::test {

/// The same with what issues.
struct IssuingBench : RegistryBench
{
    QPointer<IssueDialog> issuing;
    QString program = qEnvironmentVariable("DYNCAL_BINARY"); ///< that the dialog calls

    void openJob() const
    {
        window->files().openProjectFile(path("job.dyncal"));
        QTRY_VERIFY_WITH_TIMEOUT(
            window->session().state().hasShots() && window->session().isUpToDate(), kPatience_ms);
    }
    void showIssuing()
    {
        find<QAction>("issueAction")->trigger();
        issuing = find<IssueDialog>("issueDialog");
        issuing->setProgram(program);
        issuing->lookUp();
        QTRY_VERIFY_WITH_TIMEOUT(!issuing->isBusy(), kPatience_ms);
    }
    void issueNow() const
    {
        QVERIFY2(button("issueNow")->isEnabled(), qPrintable(obstacles().join('\n')));
        button("issueNow")->click();
        QTRY_VERIFY_WITH_TIMEOUT(!issuing->isBusy(), kPatience_ms);
    }
    QStringList obstacles() const
    {
        QStringList lines;
        const auto *list = find<QListWidget>("issueObstacles");
        for (int row = 0; row < list->count(); ++row)
            lines << list->item(row)->text();
        return lines;
    }
};

} // namespace dyncal::test
