// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/key_results.h"
#include "ui/shell/next_steps.h"

#include <QWidget>

class QLabel;
class QMenu;
class QToolButton;

namespace dyncal {

class Session;

/// Always in view, below everything: what a certificate still lacks, each item a link to its field,
/// and the key results. As many items as there is room for; the others in a menu behind them.
class NextBar : public QWidget
{
    Q_OBJECT

public:
    explicit NextBar(QWidget *parent = nullptr);

    void showWork(const WorkState &work, const Session &session);
    /// `isOpen`: there are recordings.
    void showSteps(const std::vector<NextStep> &steps, bool isOpen);
    /// `areCurrent`: they belong to what is set on the screen.
    void showResults(const std::vector<KeyResult> &results, bool areCurrent);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {1, sizeHint().height()}; }

signals:
    void stepRequested(const dyncal::NextStep &step);

protected:
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void arrange();
    int placeResults();
    void placeSteps(int width);
    void addLink();

    QLabel *m_heading;
    QToolButton *m_more;
    QMenu *m_menu;
    std::vector<NextStep> m_steps;
    std::vector<QToolButton *>
        m_links; ///< as many as there ever were steps; the first are those of m_steps
    std::vector<QLabel *> m_results;
    int m_height = 0;
};

} // namespace dyncal
