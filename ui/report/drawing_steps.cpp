// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/drawing_steps.h"

#include "core/base/free_memory.h"

namespace dyncal {

namespace {

/// Length of one step: too short to be noticed at the mouse.
constexpr std::chrono::milliseconds kStepTime{15};
/// Memory that drawing takes at most.
constexpr std::size_t kDrawingBytes = std::size_t(96) << 20U;

} // namespace

DrawingSteps::DrawingSteps(QObject *parent)
    : QObject(parent)
{
    m_tick.setInterval(0);
    connect(&m_tick, &QTimer::timeout, this, &DrawingSteps::drawSome);
}

Result<void> DrawingSteps::checkMemory()
{
    if (isMemoryLeft(kDrawingBytes))
        return {};
    return fail(ErrorKind::Internal,
        {DYNCAL_TEXT("core",
             "There is not enough memory to draw the certificate and the plots, and nothing was written; close other programs or raise the memory limit."),
            {}});
}

void DrawingSteps::start(std::unique_ptr<ReportDrawing> drawing)
{
    m_drawing = std::move(drawing);
    m_tick.start();
}

void DrawingSteps::cancel()
{
    m_tick.stop();
    m_drawing.reset();
}

void DrawingSteps::drawSome()
{
    m_drawing->draw(kStepTime);
    if (!m_drawing->isDone()) {
        emit progress(m_drawing->fraction());
        return;
    }
    const Result<std::vector<DrawnFile>> files = m_drawing->take();
    cancel();
    if (files)
        emit drawn(*files);
    else
        emit failed(files.error());
}

} // namespace dyncal
