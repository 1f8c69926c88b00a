// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/import_verdict.h"

#include "ui/session/import_choices.h"
#include "ui/text/core_text.h"
#include "ui/text/quantity_format.h"

#include <QCoreApplication>

#include <algorithm>

namespace dyncal {

namespace {

/// Gives the sentences below their translation context.
struct VerdictText
{
    Q_DECLARE_TR_FUNCTIONS(ImportVerdict)
};

/// What the file itself leaves open; empty if nothing.
QString questionOfFile(const ImportView &view, const ImportSettings &settings)
{
    const bool complete = view.isComplete(settings);
    if (view.headerRate_Hz && view.timesRate_Hz)
        return VerdictText::tr("The header says %1, the time column %2. Which one is right?")
            .arg(shownQuantity(*view.headerRate_Hz, "Hz"), shownQuantity(*view.timesRate_Hz, "Hz"));
    if (view.problem)
        return translated(view.problem->message);
    if (view.text && view.text->unreadableCells > 0)
        return VerdictText::tr(
            "Cells that are no numbers are marked; change separator, decimal mark or header rows.");
    if (!complete && view.text && view.text->decimalAmbiguous)
        return VerdictText::tr(
            "The numbers can be read in two ways: choose the decimal mark; the table shows the effect.");
    if (!complete && view.sampleRate_Hz <= 0.0 && !settings.sampleRate_Hz)
        return VerdictText::tr("The file does not say its sample rate: type it.");
    return {};
}

/// What the operator still has to say; empty if nothing.
QString missingAnswer(const ImportView &view, const ImportSettings &settings, bool lacksName)
{
    const auto duts = std::ranges::count(view.channels, ChannelRole::Dut, &ImportChannel::role);
    if (needsRateReason(settings, view) && settings.sampleRateReason.empty())
        return VerdictText::tr(
            "The rate typed differs from that of the file: say why the file is wrong. The results record it.");
    if (view.isShotPerColumn() && duts == 0)
        return VerdictText::tr("The table has no column of samples.");
    if (view.text && duts == 0 && view.channels.size() > 1)
        return VerdictText::tr(
            "Choose which channel is the sensor under test (DUT), or tick that each column is a shot of it.");
    if (duts == 0)
        return VerdictText::tr("Choose which channel is the sensor under test (DUT).");
    if (duts > 1 && !view.isShotPerColumn())
        return VerdictText::tr("Only one channel can be the sensor under test (DUT).");
    if (lacksName)
        return VerdictText::tr("Give the profile a name that a file can have.");
    return {};
}

} // namespace

QString blockingSentence(const QString &sentence)
{
    return QStringLiteral("■ ") + sentence;
}

ImportVerdict importVerdict(const ImportView *view, const ImportSettings &settings, bool lacksName)
{
    if (!view)
        return {false, VerdictText::tr("Reading the file...")};
    const bool reasonMissing
        = needsRateReason(settings, *view) && settings.sampleRateReason.empty();
    const bool mayImport = view->isComplete(settings) && !lacksName && !reasonMissing;
    QString open = questionOfFile(*view, settings);
    if (open.isEmpty())
        open = missingAnswer(*view, settings, lacksName);
    if (!open.isEmpty())
        return {mayImport, blockingSentence(open)};
    if (view->text && *view->text->remark.text)
        return {mayImport, QStringLiteral("▲ ") + translated(view->text->remark)};
    return {mayImport, QStringLiteral("● ") + VerdictText::tr("The file can be imported.")};
}

} // namespace dyncal
