// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "ui/plot/values/plot_content.h"

#include <QObject>

class QComboBox;

namespace dyncal {

class InspectorForm;

/// For the inspector of a page with spectra: the choice of the shot whose computed tube resonances
/// are marked by ticks. They change with the sound speed of the gas, so they belong to one shot.
class TubeModeChoice : public QObject
{
    Q_OBJECT

public:
    /// `shown`: whether those of the last shot are marked until the operator chooses.
    TubeModeChoice(InspectorForm &form, QObject *parent, bool shown = true);

    /// Takes over what is known of the shots.
    void set(const CalibrationResults &results);
    /// The content with the ticks of the chosen shot.
    PlotContent with(PlotContent content) const;

signals:
    void changed();

private:
    std::shared_ptr<const ExpectedShock> m_expected;
    QComboBox *m_shot;
    bool m_isShown;
    bool m_isChosen = false; ///< by the operator
};

} // namespace dyncal
