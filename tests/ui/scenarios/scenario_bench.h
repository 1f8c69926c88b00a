// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/capture/formats/hdf5/hdf5_capture_writer.h"
#include "core/synthesis/sensor_simulator.h"
#include "core/synthesis/shot_generator.h"
#include "tests/ui/shell/window_bench.h"
#include "tests/ui/support/quick_pipeline.h"
#include "ui/plot/widget/plot_widget.h"
#include "ui/shell/findings/findings_panel.h"
#include "ui/stages/frame/stage_page.h"

#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>

#include <algorithm>

namespace dyncal::test {

inline constexpr int kPatience_ms = 120'000;

/// Three shots of the optical sensor; short records at a lower rate, so that a run takes a second.
inline SimulationSettings threeShots(const std::vector<Defect> &defects = {})
{
    SimulationSettings settings;
    settings.sensor = sensorPreset("optic3").value();
    settings.sampleRate_Hz = 2e7;
    settings.duration_s = 0.006;
    settings.defects = defects;
    return settings;
}

/// The real window on show with the real pipeline; recordings are files that are dropped on it, and
/// everything after that is done with mouse and keys.
struct ScenarioBench : WindowBench
{
    ScenarioBench()
        : WindowBench(quickPipeline())
    {
        window->resize(1400, 900);
        window->show();
    }

    Session &session() const { return window->session(); }
    const Recipe &recipe() const { return session().recipe(); }

    QString write(const CaptureSet &set, const QString &name) const
    {
        const QString path = folder.filePath(name);
        const auto written = writeHdf5Capture(
            set, {path.toStdString(), false}, "2026-01-31T12:00:00Z", "Scenario");
        if (!written)
            qFatal("cannot write %s", qPrintable(path));
        return path;
    }
    QString record(const SimulationSettings &settings, const QString &name = "shots.h5") const
    {
        return write(simulateShots(settings).value().set, name);
    }
    /// One file for every shot: shot1.h5, shot2.h5, ...
    QStringList recordEach(const SimulationSettings &settings) const
    {
        const CaptureSet all = simulateShots(settings).value().set;
        QStringList paths;
        for (std::size_t i = 0; i < all.shots.size(); ++i) {
            CaptureSet one = all;
            one.shots = {all.shots[i]};
            paths << write(one, QString("shot%1.h5").arg(i + 1));
        }
        return paths;
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
    /// Waits until nothing is read or computed any more.
    void settle() const
    {
        QElapsedTimer waited;
        waited.start();
        int calm = 0;
        while (calm < 3 && waited.elapsed() < kPatience_ms) {
            QTest::qWait(10);
            const bool busy = window->files().isBusy() || session().isComputing()
                || std::ranges::any_of(window->pages(), &StagePage::isDrawing)
                || (session().state().hasShots() && !session().isUpToDate() && !session().error());
            calm = busy ? 0 : calm + 1;
        }
        if (calm < 3)
            qFatal("still busy");
    }
    void open(const QStringList &paths) const
    {
        drop(paths);
        settle();
        if (!session().state().hasShots())
            qFatal("no shots: %s", qPrintable(prompts.shownProblems().join(' ')));
    }

    void show(Page page) const { window->showPage(static_cast<int>(page)); }

    /// The rows of the findings panel as they are read, without those of the buttons; what is
    /// folded as notes is opened with a click.
    QStringList findings() const
    {
        auto *panel = find<FindingsPanel>("findingsPanel");
        if (QListWidgetItem *notes = panel->item(panel->count() - 1);
            notes && notes->text().startsWith(QStringLiteral("▸"))) {
            panel->scrollToItem(notes);
            QTest::mouseClick(
                panel->viewport(), Qt::LeftButton, {}, panel->visualItemRect(notes).center());
            QTest::qWait(20);
        }
        QStringList texts;
        for (int row = 0; row < panel->count(); ++row)
            if (!panel->itemWidget(panel->item(row)))
                texts << panel->item(row)->text();
        return texts;
    }
    /// The first row of this id, or nothing.
    QString finding(const QString &id) const
    {
        for (const QString &row : findings())
            if (row.contains(' ' + id + ':') || row.contains(' ' + id + ','))
                return row;
        return {};
    }
    /// A button below a finding: "correction", "reason" or "show".
    QPushButton *offer(const QString &kind, const QString &id, const QString &text = {}) const
    {
        for (auto *button : find<FindingsPanel>("findingsPanel")->findChildren<QPushButton *>())
            if (button->objectName().startsWith(kind + '_' + id) && button->text().contains(text))
                return button;
        return nullptr;
    }
    void clickOffer(const QString &kind, const QString &id, const QString &text = {}) const
    {
        auto *panel = find<FindingsPanel>("findingsPanel");
        QPushButton *button = offer(kind, id, text);
        if (!button)
            qFatal("no button %s of %s: %s", qPrintable(text), qPrintable(id),
                qPrintable(findings().join('\n')));
        for (int row = 0; row < panel->count(); ++row)
            if (const QWidget *buttons = panel->itemWidget(panel->item(row));
                buttons && buttons->isAncestorOf(button))
                panel->scrollToItem(panel->item(row));
        QTest::mouseClick(button, Qt::LeftButton);
        settle();
    }

    /// Types into a field of an inspector and presses Enter.
    void type(const QString &name, const QString &text) const
    {
        auto *field = find<QWidget>(name);
        field->setFocus();
        QTest::keySequence(field, QKeySequence::SelectAll);
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        settle();
    }
    void click(const QString &name) const
    {
        QTest::mouseClick(find<QAbstractButton>(name), Qt::LeftButton);
        settle();
    }
    /// Walks to a choice of a combo box with the keys.
    void choose(const QString &name, int choice) const
    {
        auto *box = find<QComboBox>(name);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < choice; ++i)
            QTest::keyClick(box, Qt::Key_Down);
        settle();
    }
    void undo() const
    {
        QTest::keySequence(window.get(), QKeySequence::Undo);
        settle();
    }
    QString text(const QString &label) const { return find<QLabel>(label)->text(); }
    /// The cells of one row of a table; the row that begins with `head`.
    QStringList row(const QString &table, const QString &head) const
    {
        auto *widget = find<QTableWidget>(table);
        for (int r = 0; r < widget->rowCount(); ++r) {
            if (!widget->item(r, 0) || !widget->item(r, 0)->text().startsWith(head))
                continue;
            QStringList cells;
            for (int c = 0; c < widget->columnCount(); ++c)
                cells << (widget->item(r, c) ? widget->item(r, c)->text() : QString());
            return cells;
        }
        return {};
    }

    /// Presses on a line of a plot and drags it in steps; the button stays down.
    void dragLine(PlotWidget *plot, const QString &id, double to) const
    {
        const double y = 0.5 * (plot->yRange().begin + plot->yRange().end);
        const auto &handles = plot->handles();
        const auto line = std::ranges::find(handles, id, &HandleState::id);
        if (line == handles.end())
            qFatal("no handle %s", qPrintable(id));
        const double shift = line->snapToIntegers ? 0.5 : 0.0;
        const double from = line->x.begin;
        QTest::mousePress(plot, Qt::LeftButton, {}, plot->pixelOf(from + shift, y));
        constexpr int kSteps = 4;
        for (int step = 1; step <= kSteps; ++step) {
            QTest::mouseMove(plot, plot->pixelOf(from + shift + (to - from) * step / kSteps, y));
            QTest::qWait(20);
        }
    }
    void release(PlotWidget *plot, double at) const
    {
        const double y = 0.5 * (plot->yRange().begin + plot->yRange().end);
        QTest::mouseRelease(plot, Qt::LeftButton, {}, plot->pixelOf(at, y));
        settle();
    }
};

} // namespace dyncal::test
