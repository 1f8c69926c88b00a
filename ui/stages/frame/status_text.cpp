// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/status_text.h"

#include <QCoreApplication>

#include <array>
#include <utility>

namespace dyncal {

namespace {

/// Gives the words below their translation context.
struct StatusText
{
    Q_DECLARE_TR_FUNCTIONS(StatusText)
};

/// The pages' own words: titles are translated once.
constexpr std::array<std::pair<const char *, const char *>, kPageCount> kTitles{{
    {"dyncal::CapturesPage", "Captures"},
    {"dyncal::ShockPage", "Reference step"},
    {"dyncal::WindowPage", "Window"},
    {"dyncal::SpectrumPage", "Spectrum"},
    {"dyncal::ComponentsPage", "PCA"},
    {"dyncal::ModelInputPage", "Model input"},
    {"dyncal::OrderPage", "Order"},
    {"dyncal::ModelPage", "Model"},
    {"dyncal::ChecksPage", "Checks"},
    {"dyncal::UncertaintyPage", "Uncertainty"},
    {"dyncal::ComparisonPage", "Comparison"},
    {"dyncal::CertificatePage", "Certificate"},
}};

QString incompleteWord(const PageStanding &standing)
{
    QStringList reasons;
    if (standing.emptyFields > 0)
        reasons << StatusText::tr("%n field(s) are empty", nullptr, standing.emptyFields);
    if (standing.wrongFields > 0)
        reasons << StatusText::tr("%n date(s) are none", nullptr, standing.wrongFields);
    return StatusText::tr("not complete: %1").arg(reasons.join(QStringLiteral(", ")));
}

} // namespace

QString statusGlyph(StageStatus status)
{
    switch (status) {
    case StageStatus::NotStarted:
        return QStringLiteral("–");
    case StageStatus::Blocked:
        return QStringLiteral("■");
    case StageStatus::Computing:
        return QStringLiteral("⟳");
    case StageStatus::Stale:
        return QStringLiteral("◌");
    case StageStatus::Incomplete:
        return QStringLiteral("□");
    case StageStatus::Done:
        return QStringLiteral("●");
    case StageStatus::DoneWithCautions:
        return QStringLiteral("▲");
    }
    return {};
}

QString statusWord(StageStatus status)
{
    switch (status) {
    case StageStatus::NotStarted:
        return StatusText::tr("not started");
    case StageStatus::Blocked:
        return StatusText::tr("blocked");
    case StageStatus::Computing:
        return StatusText::tr("computing");
    case StageStatus::Stale:
        return StatusText::tr("out of date");
    case StageStatus::Incomplete:
        return StatusText::tr("not complete");
    case StageStatus::Done:
        return StatusText::tr("done");
    case StageStatus::DoneWithCautions:
        return StatusText::tr("cautions");
    }
    return {};
}

QString standingWord(const PageStanding &standing, Page page)
{
    if (standing.blockedBy)
        return StatusText::tr("blocked by %1").arg(pageTitle(*standing.blockedBy));
    if (standing.status == StageStatus::Incomplete)
        return incompleteWord(standing);
    if (page == Page::Certificate && standing.status == StageStatus::DoneWithCautions)
        return StatusText::tr("%n caution(s) without a reason", nullptr, standing.cautions);
    return statusWord(standing.status);
}

QString pageTitle(Page page)
{
    const auto &[context, title] = kTitles[static_cast<std::size_t>(page)];
    return QCoreApplication::translate(context, title);
}

} // namespace dyncal
