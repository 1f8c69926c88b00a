// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/correction/correction_task.h"
#include "ui/stages/frame/inspector_form.h"

class QCheckBox;
class QComboBox;

namespace dyncal {

class OptionalEdit;

/// The fields of a correction: which calibration, which recordings, which filter. It keeps what was
/// put in; files are asked for by the window.
class CorrectionForm : public InspectorForm
{
    Q_OBJECT

public:
    explicit CorrectionForm(QWidget *parent = nullptr);

    const CorrectionChoice &choice() const { return m_choice; }
    void setChoice(const CorrectionChoice &choice); ///< without a signal

signals:
    void edited(); ///< what is on show is not of this choice any more
    void readingEdited(); ///< likewise, and the recordings are to be opened again
    void resultsWanted(); ///< the operator wants to choose a file
    void recordingsWanted();

private:
    using Number = std::optional<double> CorrectionChoice::*;

    void addCalibration();
    void addRecordings();
    void addFilter();
    void addStretches();
    OptionalEdit *addNumber(const QString &label, const QString &objectName, OptionalEdit *edit,
        const QString &empty, const std::function<std::optional<double> &(CorrectionChoice &)> &of);
    void showChoice();

    CorrectionChoice m_choice;
    QComboBox *m_from;
    QPushButton *m_chooseResults;
    QLabel *m_results;
    QLabel *m_recordings;
    QComboBox *m_channel;
    QCheckBox *m_asProject;
    QComboBox *m_lowPass;
    std::vector<std::function<void()>> m_shows; ///< of each number
};

/// A sentence of the method with the options of the command replaced by the labels of these fields.
QString withFieldLabels(QString sentence);

} // namespace dyncal
