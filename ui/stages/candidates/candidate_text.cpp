// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/candidates/candidate_text.h"

#include "core/realization/hankel/hankel_gap.h"
#include "core/realization/order/order_words.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct CandidateText
{
    Q_DECLARE_TR_FUNCTIONS(CandidateText)
};

constexpr double kSmallestP = 1e-3; ///< smaller ones are not worth telling apart

int countOf(const SensorModel &model, PoleClass poleClass)
{
    return static_cast<int>(std::ranges::count(model.poles, poleClass, &Pole::poleClass));
}

QString noteOf(Index order, const ComparedOrder *compared, const CalibrationResults &results)
{
    if (compared && compared->error)
        return translated(compared->error->message);
    QStringList notes;
    const auto &decomposition = results.decomposition;
    if (decomposition && decomposition->suggestion.order == order)
        notes << CandidateText::tr("suggested");
    if (decomposition && splitsPair(decomposition->hankel, order))
        notes << CandidateText::tr("splits a pair");
    if (compared && compared->model && compared->model->diverges)
        notes << CandidateText::tr("diverges");
    return notes.join(", ");
}

void describe(const SensorModel &model, const ModelAssessment *assessment, CandidateRow &row)
{
    row.isKnown = true;
    row.diverges = model.diverges;
    row.unstable = countOf(model, PoleClass::Unstable);
    row.nyquist = countOf(model, PoleClass::Nyquist);
    if (!model.diverges)
        row.fit_percent = model.fit_percent;
    if (std::isfinite(model.fitAttainable_percent))
        row.attainable_percent = model.fitAttainable_percent;
    if (const auto pole = sensorResonance(&model, assessment)) {
        row.f0_Hz = pole->frequency_Hz;
        row.u_f0_Hz = pole->u_frequency_Hz;
        row.zeta = pole->dampingRatio;
        row.u_zeta = pole->u_dampingRatio;
    }
}

} // namespace

CandidateRow candidateRow(
    Index order, const ComparedOrder *compared, const CalibrationResults &results)
{
    CandidateRow row;
    row.order = order;
    row.note = noteOf(order, compared, results);
    if (!compared)
        return row;
    if (compared->model)
        describe(*compared->model, compared->assessment.get(), row);
    if (std::isfinite(compared->whiteness_p))
        row.whiteness_p = compared->whiteness_p;
    row.bic = compared->bic;
    return row;
}

QString probabilityShown(std::optional<double> p)
{
    if (!p)
        return QStringLiteral("–");
    return *p < kSmallestP ? QStringLiteral("< ") + shownNumber(kSmallestP, 1) : shownNumber(*p, 2);
}

QStringList cardLines(const CandidateRow &row)
{
    if (!row.isKnown)
        return {row.note.isEmpty() ? CandidateText::tr("computing...") : row.note};
    QStringList lines;
    if (row.diverges)
        lines << CandidateText::tr("diverges");
    else
        lines << CandidateText::tr("FIT %1 of %2 %")
                     .arg(row.fit_percent && *row.fit_percent >= 0.0
                             ? shownNumber(*row.fit_percent, 3)
                             : QStringLiteral("< 0"),
                         row.attainable_percent ? shownNumber(*row.attainable_percent, 3)
                                                : QStringLiteral("–"));
    lines << (row.f0_Hz ? QStringLiteral("%1, ζ %2")
                              .arg(shownResult(*row.f0_Hz, row.u_f0_Hz, "Hz").value,
                                  shownResult(*row.zeta, row.u_zeta, {}).value)
                        : CandidateText::tr("no resonance"));
    lines << CandidateText::tr("unstable %1, Nyquist %2, p %3")
                 .arg(row.unstable)
                 .arg(row.nyquist)
                 .arg(probabilityShown(row.whiteness_p));
    if (!row.note.isEmpty())
        lines << row.note;
    return lines;
}

QString proposedReason(const SensorModel &model, const CalibrationResults &results)
{
    if (results.evidence && lowestSufficientOrder(*results.evidence) == model.order)
        return CandidateText::tr("lowest order with FIT ≥ 98 % of attainable and no Nyquist pole");
    QString text
        = CandidateText::tr("FIT %1 % of attainable %2 %")
              .arg(shownNumber(model.fit_percent, 3), shownNumber(model.fitAttainable_percent, 3));
    if (results.decomposition && results.decomposition->suggestion.order == model.order)
        text = CandidateText::tr("order suggested by the information criterion; ") + text;
    return text;
}

} // namespace dyncal
