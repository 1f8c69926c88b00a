// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/spectrum/nuisance_list.h"

#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/frame/wrapped_controls.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kLowestNuisance_Hz = 1.0;
constexpr double kHighestNuisance_Hz = 1e9;
constexpr double kFewestPeriods = 2.0;

template <typename Control>
Control *named(Control *control, const char *objectName, const QString &accessibleName)
{
    control->setObjectName(objectName);
    control->setAccessibleName(accessibleName);
    return control;
}

/// "6.08/6.45/6.80 kHz taken out", from the model.
QString foundText(const NuisanceResult &result)
{
    QStringList frequencies;
    for (const NuisanceOfShot &shot : result.perShot)
        frequencies
            << NuisanceList::tr("shot %1: %2")
                   .arg(shot.shot)
                   .arg(shownResult(shot.term.frequency_Hz(), shot.u_frequency_Hz, "Hz").value);
    return frequencies.isEmpty() ? NuisanceList::tr("not taken out of any shot")
                                 : frequencies.join(", ");
}

} // namespace

NuisanceList::NuisanceList(QWidget *parent)
    : QWidget(parent)
    , m_modes(named(new QListWidget(this), "nuisanceModes", tr("Oscillations left out")))
    , m_remove(named(new WrappedButton(tr("Leave in again"), this), "nuisanceRemove",
          tr("Leave the selected oscillation in again")))
    , m_candidates(named(new WrappedComboBox(this), "nuisanceCandidates", tr("Candidates")))
    , m_frequency(
          named(new QuantityEdit({"kHz", 1e3}, kLowestNuisance_Hz, kHighestNuisance_Hz, 6, this),
              "nuisanceFrequency", tr("Frequency of the oscillation")))
    , m_shot(
          named(new WrappedComboBox(this), "nuisanceShot", tr("Shot where the frequency was read")))
    , m_kind(named(new WrappedComboBox(this), "nuisanceKind", tr("Kind of oscillation")))
    , m_reason(named(new QLineEdit(this), "nuisanceReason", tr("Reason")))
    , m_add(named(new WrappedButton(tr("Leave out of the model"), this), "nuisanceAdd",
          tr("Leave the oscillation out of the model")))
{
    m_modes->setMaximumHeight(90);
    m_kind->addItems({tr("gas in the tube: moves with the shot"), tr("anything else")});
    setWholePlaceholder(*m_reason, tr("needed, is printed"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_modes);
    layout->addWidget(m_remove);
    auto *form = new QFormLayout;
    addWrappedRow(*form, tr("From"), m_candidates);
    addWrappedRow(*form, tr("Frequency"), m_frequency);
    addWrappedRow(*form, tr("In shot"), m_shot);
    addWrappedRow(*form, tr("Kind"), m_kind);
    addWrappedRow(*form, tr("Reason"), m_reason);
    layout->addLayout(form);
    layout->addWidget(m_add);
    connect(m_candidates, &QComboBox::activated, this, &NuisanceList::takeCandidate);
    connect(m_reason, &QLineEdit::textChanged, this, &NuisanceList::allowWhatIsComplete);
    connect(m_modes, &QListWidget::currentRowChanged, this, &NuisanceList::allowWhatIsComplete);
    connect(m_frequency, &QuantityEdit::edited, this, [this] { m_candidates->setCurrentIndex(0); });
    connect(m_add, &QPushButton::clicked, this, &NuisanceList::requestAdd);
    connect(m_remove, &QPushButton::clicked, this,
        [this] { emit removeRequested(m_modes->currentRow()); });
    m_candidates->addItem(tr("marked or typed"));
    allowWhatIsComplete();
}

void NuisanceList::showModes(
    const std::vector<NuisanceMode> &modes, const CalibrationResults &results)
{
    const int row = m_modes->currentRow();
    m_modes->clear();
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const NuisanceMode &mode = modes[i];
        QString text = shownText(mode.label);
        if (!mode.frequency_Hz.empty())
            text
                += (text.isEmpty() ? "" : ", ") + shownQuantity(mode.frequency_Hz.front(), "Hz", 4);
        const bool known = results.model && i < results.model->nuisance.size()
            && results.model->nuisance[i].mode == mode;
        if (known)
            text += "\n" + foundText(results.model->nuisance[i]);
        auto *item = new QListWidgetItem(text, m_modes);
        item->setToolTip(shownText(mode.reason));
    }
    m_modes->setCurrentRow(std::min(row, m_modes->count() - 1));
    allowWhatIsComplete();
}

void NuisanceList::showCandidates(const CalibrationResults &results)
{
    const QVariant shotBefore = m_shot->currentData();
    const QString chosenBefore = m_candidates->currentText();
    m_candidates->clear();
    m_shot->clear();
    m_offered.clear();
    m_candidates->addItem(tr("marked or typed"));
    if (!results.window || results.window->responses.empty())
        return;
    const WindowedResponse &first = results.window->responses.front();
    for (const WindowedResponse &response : results.window->responses)
        m_shot->addItem(QString::number(response.shot), static_cast<int>(response.shot));
    m_shot->setCurrentIndex(std::max(0, m_shot->findData(shotBefore)));
    const double window_s = static_cast<double>(first.length) / first.sampleRate_Hz;
    const auto offer = [&](const std::string &label, double frequency_Hz, bool isTube) {
        if (frequency_Hz * window_s < kFewestPeriods)
            return;
        m_offered.push_back({{frequency_Hz}, first.shot, isTube, label, {}});
        m_candidates->addItem(shownText(label) + ", " + shownQuantity(frequency_Hz, "Hz", 4));
    };
    const ShockConditions *shock
        = results.expected ? results.expected->conditions.ofShot(first.shot) : nullptr;
    if (results.shock && results.shock->ofShot(first.shot))
        shock = results.shock->ofShot(first.shot);
    if (shock)
        for (const TubeResonance &resonance : shock->resonances)
            offer(resonance.label(), resonance.frequency_Hz, resonance.followsGas);
    if (results.spectrum)
        for (const Resonance &resonance : results.spectrum->resonances) {
            const auto &own = resonance.perShot_Hz;
            offer(tr("peak").toStdString(),
                !own.empty() && own.front() ? *own.front() : resonance.frequency_Hz, false);
        }
    m_candidates->setCurrentIndex(std::max(0, m_candidates->findText(chosenBefore)));
}

void NuisanceList::mark(double frequency_Hz)
{
    m_candidates->setCurrentIndex(0);
    m_frequency->setSi(frequency_Hz);
}

void NuisanceList::takeCandidate(int position)
{
    if (position < 1 || position > static_cast<int>(m_offered.size()))
        return;
    const NuisanceMode &mode = m_offered[static_cast<std::size_t>(position - 1)];
    m_frequency->setSi(mode.frequency_Hz.front());
    m_shot->setCurrentIndex(std::max(0, m_shot->findData(static_cast<int>(mode.shot))));
    m_kind->setCurrentIndex(mode.isTube ? 0 : 1);
}

void NuisanceList::requestAdd()
{
    NuisanceMode mode;
    const int position = m_candidates->currentIndex();
    if (position >= 1 && position <= static_cast<int>(m_offered.size()))
        mode = m_offered[static_cast<std::size_t>(position - 1)];
    mode.frequency_Hz = {m_frequency->si()};
    mode.shot = m_shot->currentData().toInt();
    mode.isTube = m_kind->currentIndex() == 0;
    mode.reason = m_reason->text().trimmed().toStdString();
    m_reason->clear();
    emit addRequested(mode);
}

void NuisanceList::allowWhatIsComplete()
{
    m_add->setEnabled(!m_reason->text().trimmed().isEmpty());
    m_remove->setEnabled(m_modes->currentRow() >= 0);
}

} // namespace dyncal
