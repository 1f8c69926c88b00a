// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/run_output.h"

#include "ui/report/report_drawing.h"

#include <QApplication>
#include <QHashSeed>

#include <array>

namespace dyncal {
namespace {

/// Qt's remarks about its platform are no answer to the operator.
void ignoreMessage(QtMsgType, const QMessageLogContext &, const QString &) { }

/// Drawing needs an application object but no display, and must come out the same on every
/// machine: no display scaling, no random order of hashes.
Result<std::vector<DrawnFile>> drawWithoutWindow(
    const CalibrationResults &results, const Recipe &recipe, const std::string &createdUtc)
{
    for (const char *name : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI",
             "QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME"})
        qunsetenv(name);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler(ignoreMessage);
    QHashSeed::setDeterministicGlobalSeed();
    int argc = 1;
    std::array<char, 7> name{"dyncal"};
    std::array<char *, 2> argv{name.data(), nullptr};
    const QApplication application(argc, argv.data());
    return drawReport(results, recipe, createdUtc);
}

} // namespace

Result<std::vector<std::string>> writeRun(const PipelineOutcome &outcome, const Recipe &recipe,
    const std::string &createdUtc, const std::string &folder)
{
    RunFiles run{outcome, recipe, createdUtc, {}};
    if (!outcome.error) {
        Result<std::vector<DrawnFile>> drawn
            = drawWithoutWindow(outcome.results, recipe, createdUtc);
        if (!drawn)
            return tl::unexpected<Error>(drawn.error());
        run.drawn = std::move(*drawn);
    }
    return writeRunFiles(run, folder);
}

} // namespace dyncal
