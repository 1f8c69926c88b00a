// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/widget/plot_widget.h"

#include <QJsonObject>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace dyncal {

class Preferences;
class Prompts;
class RegistryCaller;
class RowsView;

/// What the calibrations of a sensor say over the years: a quantity with U and the lines of a
/// control chart, E_n against the calibration before, drift (`dyncal history`). Certificates that
/// the registry says are withdrawn or replaced take no part.
class HistoryTab : public QWidget
{
    Q_OBJECT

public:
    HistoryTab(RegistryCaller &caller, Prompts &prompts, Preferences &preferences, QWidget *parent);

    /// Reads which sensors there are, then the history of the one that is chosen; while the tab is
    /// not looked at, only once it is: a folder of certificates is a lot to read.
    void refresh();
    void showWords();

signals:
    void plotExport(const dyncal::PlotWidget *plot);
    void written(const QString &sentence);

protected:
    void showEvent(QShowEvent *event) override;

private:
    QStringList command() const; ///< of the history on show
    void takeSensors(const QJsonObject &answer);
    void read();
    void show(const QJsonObject &history);
    void showSeries();
    void askForFolder();
    void save();

    RegistryCaller &m_caller;
    Prompts &m_prompts;
    Preferences &m_preferences;
    QJsonObject m_history;
    bool m_isRead = false; ///< since refresh() was asked for
    QLabel *m_folderLabel;
    QLineEdit *m_folder;
    QPushButton *m_choose;
    QLabel *m_sensorLabel;
    QComboBox *m_sensor;
    QLabel *m_frequenciesLabel;
    QLineEdit *m_frequencies;
    QLabel *m_seriesLabel;
    QComboBox *m_series;
    QPushButton *m_save;
    PlotWidget *m_plot;
    RowsView *m_table;
    QLabel *m_summary;
};

} // namespace dyncal
