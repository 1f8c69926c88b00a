// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/report/report_drawing.h"

#include <QTimer>

namespace dyncal {

/// Carries a ReportDrawing out on the thread of the window, some milliseconds at a time, so that
/// the window goes on answering.
class DrawingSteps : public QObject
{
    Q_OBJECT

public:
    explicit DrawingSteps(QObject *parent);

    /// What start() needs free: asked first, because Qt would end the program where it gets none.
    static Result<void> checkMemory();

    void start(std::unique_ptr<ReportDrawing> drawing);
    void cancel(); ///< nothing is emitted any more
    bool isRunning() const { return m_drawing != nullptr; }

signals:
    void progress(double fraction);
    void drawn(const std::vector<dyncal::DrawnFile> &files);
    void failed(const dyncal::Error &error);

private:
    void drawSome();

    std::unique_ptr<ReportDrawing> m_drawing;
    QTimer m_tick;
};

} // namespace dyncal
