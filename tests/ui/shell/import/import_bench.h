// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/import_rules.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/recording_files.h"
#include "tests/ui/support/sample_results.h"
#include "ui/shell/findings/problem_panel.h"
#include "ui/shell/import/import_dialog.h"
#include "ui/shell/main_window.h"

#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QtTest>

namespace dyncal::test {

/// Answers at once: what is tested is how recordings come in.
inline PipelineOutcome noComputation(const std::shared_ptr<const CaptureSet> &captures,
    const Recipe &, ResultCache &, StageId, const JobControl &)
{
    PipelineOutcome outcome;
    auto prepared = std::make_shared<PreparedCaptures>();
    prepared->set = *captures;
    outcome.results.captures = prepared;
    return outcome;
}

/// A window on show that recordings are dropped on.
struct ImportBench : WindowBench
{
    explicit ImportBench(const Session::Pipeline &pipeline = noComputation)
        : WindowBench(pipeline)
    {
        window->show();
    }

    QString write(const QString &name, const QByteArray &bytes) const
    {
        writeFile(folder.filePath(name), bytes);
        return folder.filePath(name);
    }
    void drop(const QStringList &paths) const
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString &path : paths)
            urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &enter);
        QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.get(), &event);
    }
    ImportDialog *dialog() const { return window->findChild<ImportDialog *>("importDialog"); }
    /// Waits for the dialog to open and to have read the file.
    ImportDialog *waitDialog() const
    {
        for (int i = 0; i < 500 && (!dialog() || dialog()->isLooking()); ++i)
            QTest::qWait(10);
        return dialog();
    }
    void settle() const
    {
        for (int i = 0; i < 500; ++i) {
            QTest::qWait(10);
            if (!window->files().isBusy() && !window->session().isComputing())
                return;
        }
    }
    ProblemPanel *panel() const { return find<ProblemPanel>("problemPanel"); }
    bool panelShown() const { return find<QDockWidget>("problemsDock")->isVisible(); }
    std::size_t shots() const { return window->session().state().captures->shots.size(); }
    const ImportSettings &import() const { return window->session().recipe().import; }
};

/// Clicks a choice of a combo box as an operator does.
inline void choose(const QDialog *dialog, const QString &name, int choice)
{
    auto *box = dialog->findChild<QComboBox *>(name);
    QVERIFY(box);
    box->setCurrentIndex(choice);
    emit box->activated(choice);
}

inline QString verdict(const ImportDialog *dialog)
{
    return dialog->findChild<QLabel *>("importVerdict")->text();
}

inline QPushButton *importButton(const ImportDialog *dialog)
{
    return dialog->findChild<QPushButton *>("importButton");
}

inline QByteArray oneChannel()
{
    return tableText({.header = "time [s],p [V]\n", .columns = 1});
}

inline constexpr int kComma = 1;
inline constexpr int kSemicolon = 2;
inline constexpr int kCommaDecimal = 2;
inline constexpr int kDutRole = 0;
inline constexpr int kNotRead = 0;
inline constexpr int kReadAsDut = 1;
inline constexpr int kReadAsDrivenSide = 2;
inline constexpr int kReadAsOther = 6;

inline std::vector<double> ramp(int count)
{
    std::vector<double> values;
    for (int k = 0; k < count; ++k)
        values.push_back(0.5 * k);
    return values;
}

} // namespace dyncal::test
