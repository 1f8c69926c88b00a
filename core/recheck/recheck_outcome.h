// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/recheck/earlier_run.h"
#include "core/recheck/finding_changes.h"
#include "core/recheck/method_changes.h"
#include "core/recheck/quantity_differences.h"

#include <string>
#include <vector>

namespace dyncal {

/// What computing an earlier run again has shown.
struct RecheckedRun
{
    std::string createdUtc; ///< of the earlier results
    std::string software; ///< that made them: "0.1.0 (build 029ebed463)"
    bool areMethodsRecorded = true;
    std::vector<MethodChange> methods;
    std::string blockedThen; ///< why nothing could be issued; empty: it could
    std::string blockedNow;
    QuantityDifferences quantities;
    FindingChanges findings;
    std::vector<Message> remarks;

    bool isNewlyBlocked() const { return !blockedNow.empty() && blockedThen.empty(); }
    /// Something that was stated no longer holds: blocked, withdrawn, in another unit, or beyond
    /// its U.
    bool hasDifferences() const;
    /// Same methods, same findings, every value to the last bit: whatever is drawn from these
    /// values is as issued, too.
    bool isAsIssued() const;
    /// Differences of what could be issued.
    bool needsAmendment() const { return blockedThen.empty() && hasDifferences(); }
};

/// The earlier results beside `now`, the results.json of this program from the same recordings and
/// recipe; null where the recordings are refused today, which `refusal` then says. Where only one
/// of both is blocked, that stands for all that is stated on one side alone. `depth`: how far `now`
/// was computed.
RecheckedRun recheckedRun(const EarlierRun &run, const nlohmann::json &now,
    const std::string &refusal = {}, RecheckDepth depth = RecheckDepth::Whole);

/// A folder and what became of it; the error says why it could not be computed again.
struct RecheckAnswer
{
    std::string folder;
    Result<RecheckedRun> run;
};

/// What a line of the answer is about; the gravest first.
enum class RecheckKind {
    Unreadable,
    Blocked,
    Withdrawn,
    UnitChanged,
    OverU,
    StatedNow,
    FindingAppeared,
    FindingGone,
    Methods, ///< steps whose method changed, without regard to what it made
};

const char *recheckKindName(RecheckKind kind); ///< "over-u", ...

/// One line of the answer; the answers must outlive it.
struct RecheckRow
{
    const RecheckAnswer *answer = nullptr;
    RecheckKind kind = RecheckKind::Unreadable;
    const QuantityDifference *difference = nullptr; ///< of Withdrawn, UnitChanged, OverU, StatedNow
    std::string message = {}; ///< of the others

    bool needsAmendment() const;
};

/// All lines, worst first: by kind, those over U by their size. None of a run that is as it was.
std::vector<RecheckRow> recheckRows(const std::vector<RecheckAnswer> &answers);

/// A list of the rows as objects: `folder`, `number` (null), `kind`, `of`, `where`, `unit`,
/// `unit_now`, `issued`, `now`, `u_expanded`, `k`, `k_assumed`, `u_of_noise_alone`,
/// `difference_over_u`, `method_issued`, `method_now` ({step: version} of those that changed),
/// `amendment_needed`, `message`.
std::string recheckJson(const std::vector<RecheckAnswer> &answers);

/// "shock 1 -> 6, uncertainty 3 (new)", with a word where the results are of a later version or of
/// before versions were recorded; empty: the methods are the same.
std::string methodChangesText(const RecheckedRun &run);

} // namespace dyncal
