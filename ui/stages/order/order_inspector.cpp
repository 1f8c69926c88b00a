// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/order/order_inspector.h"

#include "core/realization/order/order_spread.h"
#include "ui/stages/candidates/candidate_text.h"
#include "ui/stages/frame/quantity_edit.h"
#include "ui/stages/model/model_text.h"
#include "ui/text/core_text.h"
#include "ui/text/kept_together.h"
#include "ui/text/quantity_format.h"
#include "ui/text/shown_text.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace dyncal {

QString obstacleToAdopting(const SensorModel &model)
{
    const auto block = std::ranges::find(model.findings, Severity::Block, &Finding::severity);
    return block == model.findings.end()
        ? QString()
        : rawText(block->id) + QStringLiteral(": ") + translated(block->message);
}

OrderInspector::OrderInspector(InspectorForm &form, Change change, QObject *parent)
    : QObject(parent)
    , m_change(std::move(change))
{
    buildOrder(form);
    buildModel(form);
    buildAdoption(form);
    buildSettings(form);
}

void OrderInspector::buildOrder(InspectorForm &form)
{
    form.addSection(tr("Order"));
    m_order = form.add(tr("Order"), "order", new AutoEdit({}, 1, 1000, 0));
    connect(m_order, &AutoEdit::edited, this, [this](const Auto<double> &order) {
        if (order.value)
            emit orderChosen(*order.value);
        else
            m_change(tr("Order: automatic"), [](Recipe &r) {
                r.realization.order = {};
                r.realization.adoptedReason.clear();
            });
    });
    m_suggestion = form.addNote("orderSuggestion");
    m_useSuggestion = new WrappedButton(tr("Use suggestion"));
    m_useSuggestion->setObjectName("useSuggestion");
    form.addWide(m_useSuggestion);
    connect(m_useSuggestion, &QPushButton::clicked, this, &OrderInspector::useSuggestion);
}

void OrderInspector::buildModel(InspectorForm &form)
{
    form.addSection(tr("Model on show"));
    m_of = form.addReadout(tr("Order"), "modelOrderReadout");
    m_score = form.addReadout(tr("FIT"), "fitReadout");
    m_gap = form.addReadout(tr("Gap"), "gapReadout");
    m_resonance = form.addReadout(tr("Natural frequency"), "resonanceReadout");
    m_spread = form.addReadout(tr("Over orders"), "spreadReadout");
    m_outside = form.addReadout(tr("Poles"), "polesReadout");
}

void OrderInspector::buildAdoption(InspectorForm &form)
{
    form.addSection(tr("Adopt"));
    m_reason = form.add(tr("Reason"), "adoptReason", new QLineEdit);
    m_proposed = form.addReadout(tr("Else"), "proposedReason");
    m_adopt = new WrappedButton(tr("Adopt"));
    m_adopt->setObjectName("adoptOrder");
    form.addWide(m_adopt);
    m_adoption = form.addNote("adoption");
    connect(m_adopt, &QPushButton::clicked, this, &OrderInspector::adopt);
    connect(m_reason, &QLineEdit::returnPressed, this, &OrderInspector::adopt);
    form.addSection(tr("Why the suggested order"));
    m_why = form.addNote("orderWhy");
}

void OrderInspector::buildSettings(InspectorForm &form)
{
    form.addSection(tr("Stable within"));
    auto *frequency = form.add(
        tr("Frequency"), "stableFrequency", new QuantityEdit({"%", 0.01}, 1e-5, 0.99, 3));
    auto *damping
        = form.add(tr("Damping"), "stableDamping", new QuantityEdit({"%", 0.01}, 1e-5, 0.99, 3));
    form.follow([=](const Recipe &r) {
        frequency->setSi(r.realization.stableFrequency);
        damping->setSi(r.realization.stableDamping);
    });
    connect(frequency, &QuantityEdit::edited, this, [this](double share) {
        m_change(tr("Change the tolerance of stable frequencies"),
            [&](Recipe &r) { r.realization.stableFrequency = share; });
    });
    connect(damping, &QuantityEdit::edited, this, [this](double share) {
        m_change(tr("Change the tolerance of stable damping"),
            [&](Recipe &r) { r.realization.stableDamping = share; });
    });

    form.addSection(tr("Decomposition"));
    m_largest = form.add(tr("Orders offered"), "maxOrder", new QuantityEdit({}, 1, 1000, 0));
    connect(m_largest, &QuantityEdit::edited, this, [this](double orders) {
        m_change(tr("Change the orders offered"),
            [&](Recipe &r) { r.realization.maxOrder = std::lround(orders); });
    });
    m_rows = form.add(tr("Hankel rows"), "hankelRows", new AutoEdit({}, 2, 100000, 0));
    connect(m_rows, &AutoEdit::edited, this, [this](const Auto<double> &rows) {
        m_change(tr("Change the Hankel rows"), [&](Recipe &r) {
            r.realization.rows = rows.value ? Auto<Index>(std::lround(*rows.value)) : Auto<Index>();
        });
    });
    auto *refine = new WrappedCheckBox(tr("Refine the poles (least squares)"));
    refine->setObjectName("refinePoles");
    form.addWide(refine);
    form.follow([refine](const Recipe &r) { refine->setChecked(r.realization.refine); });
    connect(refine, &QCheckBox::clicked, this, [this](bool on) {
        m_change(tr("Refine the poles"), [&](Recipe &r) { r.realization.refine = on; });
    });
}

void OrderInspector::useSuggestion()
{
    if (m_suggested > 0)
        emit orderChosen(static_cast<double>(m_suggested));
}

void OrderInspector::typeOrder()
{
    auto *field = m_order->findChild<QuantityEdit *>();
    field->setShownOnly(false); // what is typed takes the place of "auto"
    field->setFocus(Qt::ShortcutFocusReason);
    field->selectAll();
}

void OrderInspector::adopt()
{
    if (!m_mayAdopt)
        return;
    const QString typed = m_reason->text().trimmed();
    emit adopted(typed.isEmpty() ? m_proposed->text() : typed);
}

void OrderInspector::showRecipe(
    const Recipe &recipe, const CalibrationResults &results, Index order)
{
    const RealizationSettings &settings = recipe.realization;
    const auto asDouble = [](const Auto<Index> &setting) {
        return setting.value ? Auto<double>(static_cast<double>(*setting.value)) : Auto<double>();
    };
    m_remarks.clear();
    for (const OrderNote &note : settings.candidateNotes)
        m_remarks.insert(note.order, rawText(note.note));
    m_order->set(asDouble(settings.order), static_cast<double>(order));
    {
        const QSignalBlocker quiet(m_largest); // cannot be below the chosen order
        m_largest->setMinimum(static_cast<double>(settings.order.value.value_or(1)));
        m_largest->setSi(static_cast<double>(settings.maxOrder));
    }
    std::optional<double> rows;
    if (results.decomposition)
        rows = static_cast<double>(results.decomposition->hankel.rows);
    m_rows->set(asDouble(settings.rows), rows);
    if (!m_reason->hasFocus())
        m_reason->setText(rawText(settings.adoptedReason));
}

void OrderInspector::showResults(const CalibrationResults &results, bool isCurrent, bool isAdopted)
{
    const auto &decomposition = results.decomposition;
    m_suggested = decomposition ? decomposition->suggestion.order : 0;
    m_useSuggestion->setEnabled(m_suggested > 0);
    m_suggestion->setText(decomposition ? tr("Suggested: order %1. %2")
                                              .arg(m_suggested)
                                              .arg(translated(decomposition->suggestion.reason))
                                        : tr("No suggestion yet."));
    QStringList why;
    if (results.evidence)
        for (const Message &words : results.evidence->words)
            why << translated(words);
    m_why->setText(why.isEmpty() ? tr("Being gathered.") : why.join("\n"));
    showModel(results, results.model.get());
    showAdoption(results, isCurrent, isAdopted);
}

/// Shows only numbers of the model that there is, whose order stands above them, so that nothing is
/// mixed while a newer model is computed.
void OrderInspector::showModel(const CalibrationResults &results, const SensorModel *model)
{
    m_of->setText(model ? QString::number(model->order) : "–");
    m_score->setText(model ? fitText(*model) : "–");
    const auto pole = statedResonance(model, results.assessment.get(), results.uncertainty.get());
    // A sensor that is damped well has a natural frequency and no resonance: the spectrum says so.
    const bool hasNoPeak = results.spectrum && results.spectrum->resonances.empty();
    const QString words = hasNoPeak ? tr("%1, damping %2; no resonance") : tr("%1, damping %2");
    m_resonance->setText(pole ? withUnitsKept(words.arg(shownWithStandardU(pole->frequency_Hz,
                                                            pole->with.u_frequency_Hz, "Hz"),
                             shownWithStandardU(pole->dampingRatio, pole->with.u_dampingRatio, {})))
                              : "–");
    const auto countOf = [&](PoleClass poleClass) {
        return model ? std::ranges::count(model->poles, poleClass, &Pole::poleClass) : 0;
    };
    m_outside->setText(tr("%1 unstable, %2 at Nyquist")
                           .arg(countOf(PoleClass::Unstable))
                           .arg(countOf(PoleClass::Nyquist)));
    const auto &decomposition = results.decomposition;
    QString gap = "–";
    if (decomposition && model && model->order < decomposition->hankel.singularValues.size()) {
        const auto &values = decomposition->hankel.singularValues;
        gap = tr("factor %1 to the next")
                  .arg(shownNumber(values[model->order - 1] / values[model->order], 3));
    }
    m_gap->setText(gap);
    std::optional<OrderSpread> spread;
    if (results.evidence && model && pole
        && !model->secondOrder) // no order has that sensor's poles
        spread = spreadAround(*results.evidence, model->order, pole->frequency_Hz);
    m_spread->setText(spread
            ? withUnitsKept(
                tr("%1, ζ %2 (orders %3 to %4)")
                    .arg(shownWithU(spread->frequency_Hz, spread->frequencySpread_Hz, "Hz"),
                        shownWithU(spread->dampingRatio, spread->dampingSpread, {}))
                    .arg(spread->fromOrder)
                    .arg(spread->toOrder))
            : "–");
}

void OrderInspector::showAdoption(const CalibrationResults &results, bool isCurrent, bool isAdopted)
{
    const SensorModel *model = results.model.get();
    const QString obstacle = model ? obstacleToAdopting(*model) : tr("There is no model yet.");
    m_mayAdopt = isCurrent && obstacle.isEmpty() && !isAdopted;
    m_adopt->setEnabled(m_mayAdopt);
    m_adopt->setText(model ? tr("Adopt order %1 (Enter)").arg(model->order) : tr("Adopt"));
    m_adopt->setToolTip(obstacle);
    m_adopt->setAccessibleDescription(obstacle);
    m_proposed->setText(model && obstacle.isEmpty() ? proposedReason(*model, results) : QString());
    const QString remark = model ? m_remarks.value(model->order) : QString();
    QStringList lines{isAdopted ? tr("This order is adopted.") : obstacle};
    if (!remark.isEmpty())
        lines << tr("Note on order %1: %2").arg(model->order).arg(shownText(remark));
    lines.removeAll(QString());
    m_adoption->setText(lines.join('\n'));
}

} // namespace dyncal
