// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/template_choice.h"
#include "ui/report/drawing_steps.h"
#include "ui/session/current_utc.h"
#include "ui/session/job_runner.h"
#include "ui/session/session.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QScrollArea;

namespace dyncal {

class PageStack;

/// The certificate as an export would write it now, beside its form: drawn anew a moment after the
/// last change, while it is on show. Until then the pages before are there, pale. Nothing is drawn
/// from results of an older recipe.
class PreviewPanel : public QWidget
{
    Q_OBJECT

public:
    PreviewPanel(Session &session, CurrentUtc currentUtc, QWidget *parent = nullptr);

    /// Recipe or results are others.
    void follow();
    /// The document on show; empty until there is one.
    const std::string &pdf() const { return m_pdf; }
    /// Whether what is on show is what an export would write.
    bool isCurrent() const;

signals:
    /// The document is drawn of the results and the recipe as they are.
    void begun(const std::string &createdUtc, const dyncal::ChosenTemplate &chosen);
    void outdated(); ///< what was drawn is of something older

protected:
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QString refusal() const;
    void draw();
    void take(const std::vector<DrawnFile> &files);
    void showPages();
    void say(const QString &text);
    void sayPage();
    int pageWidth() const;
    void setZoom(int step);

    Session &m_session;
    CurrentUtc m_currentUtc;
    QLabel *m_note;
    QComboBox *m_zoom;
    QScrollArea *m_scroll;
    PageStack *m_stack;
    QTimer m_wait; ///< from a change to the drawing
    QTimer m_settle; ///< from a new width to sharp pages
    DrawingSteps m_drawing;
    JobRunner m_rendering;
    std::string m_pdf;
    int m_shownWidth = 0; ///< that the pictures were made for
};

} // namespace dyncal
