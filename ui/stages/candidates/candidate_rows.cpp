// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/candidates/candidate_rows.h"

#include "ui/session/order_candidates.h"
#include "ui/session/session.h"
#include "ui/text/shown_text.h"

namespace dyncal {

Index chosenOrder(const Session &session)
{
    const CalibrationResults &results = session.results();
    if (session.recipe().realization.order.value)
        return *session.recipe().realization.order.value;
    if (results.model)
        return results.model->order;
    return results.decomposition ? results.decomposition->suggestion.order : 1;
}

std::optional<Index> adoptedOrder(const Session &session)
{
    if (session.recipe().realization.adoptedReason.empty())
        return std::nullopt;
    return chosenOrder(session);
}

std::vector<CandidateRow> candidateRows(const Session &session)
{
    const OrderCandidates &candidates = session.candidates();
    const Index onShow = session.results().model ? session.results().model->order : 0;
    std::vector<CandidateRow> rows;
    std::size_t drawn = 0;
    for (const Index order : session.recipe().realization.candidates) {
        CandidateRow row = candidateRow(order, candidates.find(order), session.results());
        row.remark = rawText(noteOnOrder(session.recipe(), order));
        if (candidates.waitsForWholeSet(order))
            row.note = QObject::tr("waits for all singular values");
        row.isChosen = order == chosenOrder(session);
        row.isAdopted = order == adoptedOrder(session);
        // The order on show is drawn as the model already.
        if (row.isKnown && !row.diverges && order != onShow && candidates.isDrawn(order)
            && drawn < kMostOverlaid)
            row.overlaid = candidateRole(drawn++);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<OverlaidModel> overlaidModels(const Session &session)
{
    std::vector<OverlaidModel> models;
    for (const CandidateRow &row : candidateRows(session))
        if (const ComparedOrder *compared = session.candidates().find(row.order);
            row.overlaid && compared)
            models.push_back({*row.overlaid, compared->model, compared->response});
    return models;
}

} // namespace dyncal
