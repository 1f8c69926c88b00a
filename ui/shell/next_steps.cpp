// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/next_steps.h"

#include "ui/shell/findings/finding_places.h"
#include "ui/stages/frame/status_text.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_group.h"
#include "ui/text/finding_text.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct Steps
{
    Q_DECLARE_TR_FUNCTIONS(NextSteps)
};

void addBlocks(const WorkState &work, std::vector<NextStep> &steps)
{
    for (const FindingGroup &group : grouped(work.findings)) {
        const Finding &first = group.front();
        if (first.severity != Severity::Block)
            continue;
        const FindingPlace place
            = placeOfFinding(first.id).value_or(FindingPlace{pageOf(first, work), ""});
        const QString what = first.id.empty() ? severityWord(Severity::Block) : rawText(first.id);
        steps.push_back({severityGlyph(Severity::Block) + " "
                + Steps::tr("%1: %2").arg(pageTitle(place.page), what),
            place.page, QString::fromLatin1(place.control)});
    }
}

void addCautions(const WorkState &work, std::vector<NextStep> &steps)
{
    if (const int open = openCautions(work); open > 0)
        steps.push_back({severityGlyph(Severity::Caution) + " "
                + Steps::tr("reasons for %n caution(s)", nullptr, open),
            Page::Certificate, {}});
}

} // namespace

std::vector<NextStep> nextSteps(const WorkState &work)
{
    std::vector<NextStep> steps;
    addBlocks(work, steps);
    addCautions(work, steps);
    for (const CertificateField &field : work.unfilled)
        steps.push_back({translated(field.label), Page::Certificate, "field_" + rawText(field.id)});
    return steps;
}

} // namespace dyncal
