// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/order_comparison.h"
#include "ui/session/job_runner.h"

#include <map>
#include <memory>
#include <set>
#include <string>

namespace dyncal {

/// What the models are computed from, as it is on show.
struct CandidateBasis
{
    std::shared_ptr<const CaptureSet> captures;
    Recipe recipe; ///< that the results are computed from
    CalibrationResults results; ///< its keys are each result's own
    bool isFirstTriplets = false; ///< the decomposition is of the first singular values only
};

/// The models of the orders that the recipe has pinned for comparison, computed in the background
/// from the decomposition on show. They do not depend on the order chosen: a drag computes
/// nothing here.
class OrderCandidates : public QObject
{
    Q_OBJECT

public:
    OrderCandidates();

    /// To be called whenever recipe or results changed.
    void follow(CandidateBasis basis);

    /// Null while the model is being computed, or if it cannot be.
    const ComparedOrder *find(Index order) const;
    /// Whether the order is beyond the singular values computed so far.
    bool waitsForWholeSet(Index order) const;
    bool isComputing() const { return m_jobs.isRunning(); }
    /// Whether the operator wants the model drawn over the chosen one; not part of the recipe.
    bool isDrawn(Index order) const { return !m_hidden.contains(order); }
    void setDrawn(Index order, bool drawn);
    /// Why the last comparison failed as a whole, if it did.
    const std::optional<Error> &error() const { return m_error; }

signals:
    void changed();

private:
    void update();
    std::vector<Index> missing() const;
    void take(const std::string &basisOfModels, Result<std::vector<ComparedOrder>> compared);

    CandidateBasis m_basis;
    std::string m_basisOfModels; ///< hash of what the models were computed from
    std::map<Index, ComparedOrder> m_models;
    std::set<Index> m_hidden;
    std::optional<Error> m_error;
    JobRunner m_jobs;
};

} // namespace dyncal
