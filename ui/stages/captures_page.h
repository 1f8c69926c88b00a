// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/stage_page.h"

#include <map>
#include <vector>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;
class QSplitter;
class QTableWidget;

namespace dyncal {

class OptionalEdit;
class OverviewStrip;
class Prompts;
class QuantityEdit;

/// Stage 1: the recordings, what each channel is, and which shots take part.
class CapturesPage : public StagePage
{
    Q_OBJECT

public:
    CapturesPage(Session &session, Prompts &prompts);

    /// Takes a shot (number from 1) in or out; out needs a reason, which the certificate prints.
    void setIncluded(Index shot, bool included);

signals:
    void addRequested();
    void importRequested(const QString &path); ///< to show how this file is read
    /// A change that may need the files to be read again.
    void importChanged(const dyncal::ImportSettings &next, const QString &step);

protected:
    void showRecipe() override;
    void showResults() override;

private:
    void buildInspector();
    void showPlots();
    PlotWidget *plotOf(ChannelRole role, std::size_t unit);
    void showTable();
    void fillRow(int row, const Shot &shot);
    void showChannels();
    void setRole(const QString &channel, ChannelRole role);
    void setLevel(Index shot, ShotLevel level);
    void tagByStepHeight();
    void removeSelected();
    void requestImport();
    void changeRate(const std::optional<double> &rate_Hz);
    const CaptureSet &shownSet() const;

    Prompts &m_prompts;
    QSplitter *m_split;
    OverviewStrip *m_overview;
    std::map<ChannelRole, std::vector<PlotWidget *>> m_plots; ///< one for each unit of a role
    int m_shownPlots = 0;
    QTableWidget *m_table;
    QWidget *m_channels;
    QLabel *m_otherRoles; ///< in single shots
    QStringList m_channelNames;
    std::vector<QComboBox *> m_roles;
    QLineEdit *m_unit;
    QuantityEdit *m_scale;
    QCheckBox *m_inverted;
    QComboBox *m_reference;
    OptionalEdit *m_rate;
    QPushButton *m_remove;
    QPushButton *m_tag;
};

} // namespace dyncal
