// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/findings/finding_answers.h"

#include "core/project/recipe_correction.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QCoreApplication>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct Answers
{
    Q_DECLARE_TR_FUNCTIONS(FindingAnswers)
};

} // namespace

void acknowledge(const Findings &findings, Session &session, Prompts &prompts, QWidget *parent)
{
    if (findings.empty())
        return;
    const QString id = rawText(findings.front().id);
    const std::optional<QString> reason
        = prompts.sentence(parent, Answers::tr("Reason for %1").arg(id),
            Answers::tr("Why is the result used all the same? The certificate prints the reason."));
    if (!reason)
        return;
    Recipe next = session.recipe();
    for (const Finding &finding : findings) {
        std::erase_if(next.acknowledge, [&](const Acknowledgement &entry) {
            return entry.finding == finding.id && entry.shot == finding.shot;
        });
        next.acknowledge.push_back({finding.id, finding.shot, reason->toStdString()});
    }
    session.apply(next, Answers::tr("Give a reason for %1").arg(id));
}

void applyCorrection(const OfferedCorrection &correction, Session &session, CaptureImport &captures,
    Prompts &prompts, QWidget *parent)
{
    if (!correction.importPath.isEmpty()) {
        captures.edit(correction.importPath);
        return;
    }
    if (correction.ofFinding) {
        if (const Result<Recipe> next = correctedRecipe(session.recipe(), *correction.ofFinding))
            session.apply(*next, correction.step);
        else
            prompts.showProblem(parent, translated(next.error().message));
        return;
    }
    std::optional<QString> reason = QString();
    if (!correction.question.isEmpty())
        reason = prompts.sentence(parent, correction.step, correction.question);
    if (!reason)
        return;
    Recipe next = session.recipe();
    correction.apply(next.import, reason->toStdString());
    session.apply(next, correction.step);
}

} // namespace dyncal
