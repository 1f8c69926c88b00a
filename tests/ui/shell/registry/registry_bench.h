// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "tests/system/issued_job.h"
#include "tests/ui/shell/window_bench.h"
#include "ui/shell/registry/registry_window.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

namespace dyncal::test {

/// The main window with a laboratory's folder and the registry in it, over the built program.
struct RegistryBench : WindowBench
{
    static constexpr int kPatience_ms = 120'000;

    IssuedJob job;
    RegistryWindow *registry = nullptr;

    RegistryBench()
        : WindowBench(runPipeline)
    {
        preferences.setIssuing(Preferences::Issuing::Registry, job.registry());
        preferences.setIssuing(Preferences::Issuing::Folder, job.output());
        window->show();
    }
    QString path(const QString &name) const { return job.path(name); }
    QPushButton *button(const char *name) const { return find<QPushButton>(name); }
    QString text(const char *label) const { return find<QLabel>(label)->text(); }

    void showRegistry()
    {
        find<QAction>("registryAction")->trigger();
        registry = find<RegistryWindow>("registryWindow");
        registry->setProgram(qEnvironmentVariable("DYNCAL_BINARY"));
        registry->refresh();
        waitForRegistry();
    }
    void waitForRegistry() const { QTRY_VERIFY_WITH_TIMEOUT(!registry->isBusy(), kPatience_ms); }
    QString cell(const char *table, int row, int column) const
    {
        return find<QTableView>(table)->model()->index(row, column).data().toString();
    }
    int rows(const char *table) const { return find<QTableView>(table)->model()->rowCount(); }
};

} // namespace dyncal::test
