// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"

#include <QWidget>

class QComboBox;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace dyncal {

class QuantityEdit;

/// Oscillations that are left out of the sensor's model: those of the recipe, and one to be added
/// from the tube's candidates, from the spectrum's peaks, or at a frequency marked or typed.
class NuisanceList : public QWidget
{
    Q_OBJECT

public:
    explicit NuisanceList(QWidget *parent = nullptr);

    /// The modes of the recipe, with what became of them where the model has been computed.
    void showModes(const std::vector<NuisanceMode> &modes, const CalibrationResults &results);
    /// What may be added: tube modes of the first shot that have two periods in its window, and the
    /// spectrum's peaks.
    void showCandidates(const CalibrationResults &results);
    /// Takes the frequency of a peak marked in the plot; it belongs to the shot chosen in the list.
    void mark(double frequency_Hz);

signals:
    void addRequested(const dyncal::NuisanceMode &mode);
    void removeRequested(int position);

private:
    void takeCandidate(int position);
    void requestAdd();
    void allowWhatIsComplete();

    QListWidget *m_modes;
    QPushButton *m_remove;
    QComboBox *m_candidates;
    QuantityEdit *m_frequency;
    QComboBox *m_shot; ///< where the frequency was read; item data: its number
    QComboBox *m_kind;
    QLineEdit *m_reason;
    QPushButton *m_add;
    std::vector<NuisanceMode> m_offered; ///< one per entry of m_candidates but the first
};

} // namespace dyncal
