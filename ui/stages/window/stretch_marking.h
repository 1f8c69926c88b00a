// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"
#include "ui/session/session.h"
#include "ui/stages/window/stretch_list.h"

namespace dyncal {

/// Leaves stretches of the records out of the fit: marked in the plots or typed, shown in both as
/// the recipe has them. One that is not complete (no reason, not in the window) is kept here, shown
/// and not applied.
class StretchMarking : public QObject
{
    Q_OBJECT

public:
    /// The x axis of the plots is the time after the start.
    StretchMarking(
        Session &session, StretchList &list, std::vector<PlotWidget *> plots, QObject *parent);

    /// Updates list and bands from the recipe and the results.
    void show();
    /// The shot on show has changed: new stretches are of it, unless another is chosen.
    void setShot(Index shot);

private:
    void mark(Interval span_s);
    void takeEdit(int row, const MarkedStretch &stretch);
    void takeDraft(const MarkedStretch &stretch);
    void remove(int row);
    void moveBand(const QString &id, Interval span_s, bool finished);
    void takeBackDraft(const QString &id, Interval span_s);
    void apply(const std::vector<MarkedStretch> &stretches, const QString &label,
        const QString &mergeKey = {});

    std::vector<MarkedStretch> stretches() const;
    const std::vector<WindowedResponse> &responses() const;
    QString remark(const MarkedStretch &stretch, bool isDraft) const;
    QString whatTheRunSays(const MarkedStretch &stretch) const;
    std::vector<ShotChoice> choices() const;
    void showBands(const std::vector<StretchRow> &rows);

    Session &m_session;
    StretchList &m_list;
    std::vector<PlotWidget *> m_plots;
    std::optional<MarkedStretch> m_draft; ///< the list's last row while it is not applied
    Index m_shot = 1;
    int m_bands = 0; ///< drawn in the plots
};

} // namespace dyncal
