// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/work_state.h"

#include "core/certificate/required_fields.h"
#include "ui/session/session.h"

namespace dyncal {

WorkState workStateOf(const Session &session)
{
    WorkState work;
    for (std::size_t i = 0; i < work.stages.size(); ++i)
        work.stages[i] = session.status(static_cast<StageId>(i));
    work.findings = session.findings();
    work.stopped = session.error().has_value();
    work.failedStage = session.failedStage();
    work.accepted = session.recipe().acknowledge;
    work.unfilled = unfilledFields(session.results(), session.recipe());
    return work;
}

} // namespace dyncal
