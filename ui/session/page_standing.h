// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/finding.h"
#include "core/certificate/certificate_data.h"
#include "core/project/recipe.h"
#include "ui/session/stage_status.h"

#include <array>
#include <optional>
#include <vector>

namespace dyncal {

/// The rows of the stage list. A page shows one or more stages of the method.
enum class Page {
    Captures,
    Shock,
    Window,
    Spectrum,
    Components,
    ModelInput,
    Order,
    Model,
    Checks,
    Uncertainty,
    Comparison,
    Certificate
};
inline constexpr int kPageCount = 12;

/// The stages on a page, the one that it is opened for first.
std::vector<StageId> stagesOf(Page page);

/// The page that answers for a finding: where it can be settled, or seen.
std::optional<Page> pageOfFinding(const std::string &id);

/// Whether a reason is given for using the result in spite of it.
bool isAccepted(const Finding &finding, const std::vector<Acknowledgement> &accepted);

/// All that says how the pages stand.
struct WorkState
{
    std::array<StageStatus, kStageCount> stages{};
    Findings findings; ///< of all stages, and the error that stopped the run
    bool stopped = false; ///< the last run ended with an error...
    StageId failedStage = StageId::Captures; ///< ...in this stage
    std::vector<Acknowledgement> accepted;
    std::vector<CertificateField> unfilled; ///< required by the certificate
};

/// Cautions that nobody gave a reason for; of one page, or of all.
int openCautions(const WorkState &work, std::optional<Page> page = {});

/// The page that a finding counts for; one without an id of the catalogue is what stopped the run.
Page pageOf(const Finding &finding, const WorkState &work);

/// How a page stands, as the stage list and the head of the page say it.
struct PageStanding
{
    StageStatus status = StageStatus::NotStarted;
    std::optional<Page> blockedBy = std::nullopt; ///< an earlier page that has to be settled first
    int cautions = 0; ///< no reason is given for yet
    int emptyFields = 0;
    int wrongFields = 0;

    bool operator==(const PageStanding &) const = default;
};

/// Never done with a finding of its own that blocks, with a caution that nobody gave a reason for,
/// behind a page that blocks it, or, for the certificate, with a required field empty.
PageStanding standingOf(Page page, const WorkState &work);

/// The finding that blocks a page: its own, or that of the page it is blocked by.
const Finding *blockOf(Page page, const WorkState &work);

} // namespace dyncal
