// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/tube_mode_choice.h"

#include "ui/plot/curves/shock_curves.h"
#include "ui/stages/frame/inspector_form.h"

#include <QComboBox>

namespace dyncal {

TubeModeChoice::TubeModeChoice(InspectorForm &form, QObject *parent, bool shown)
    : QObject(parent)
    , m_isShown(shown)
{
    form.addSection(tr("Tube modes: computed, not identified"));
    m_shot = form.addChoice(tr("Ticks"), "tubeModes", {});
    m_shot->setToolTip(tr(
        "Where the tube may ring by its dimensions and the gas: computed, not identified. (m,n) across the tube, 5.1 its wall, 5.2 its gas before the burst, a5 and mix along it behind the shocks."));
    connect(m_shot, &QComboBox::activated, this, [this] {
        m_isChosen = true;
        emit changed();
    });
}

void TubeModeChoice::set(const CalibrationResults &results)
{
    m_expected = results.expected;
    const QVariant chosen = m_shot->currentData();
    m_shot->clear();
    m_shot->addItem(tr("none"), 0);
    if (m_expected) {
        for (const ShockConditions &shot : m_expected->conditions.shots) {
            if (!shot.resonances.empty())
                m_shot->addItem(tr("of shot %1").arg(shot.shot), static_cast<int>(shot.shot));
        }
    }
    const int again = m_shot->findData(chosen);
    const int first = m_isShown ? m_shot->count() - 1 : 0;
    m_shot->setCurrentIndex(!m_isChosen || again < 0 ? first : again);
}

PlotContent TubeModeChoice::with(PlotContent content) const
{
    const Index shot = m_shot->currentData().toInt();
    const ShockConditions *conditions
        = m_expected && shot > 0 ? m_expected->conditions.ofShot(shot) : nullptr;
    if (conditions)
        addTubeModes(content, *conditions);
    return content;
}

} // namespace dyncal
