// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "ui/plot/values/plot_content.h"

#include <QObject>

class QComboBox;

namespace dyncal {

class InspectorForm;

/// The choice in an inspector of a page with spectra: whose shot's computed resonances of the tube
/// are ticked in them. They move with the sound speed of the gas, so they are one shot's.
class TubeModeChoice : public QObject
{
    Q_OBJECT

public:
    /// `shown`: whether the last shot's are ticked before anything is chosen.
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
