// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/cli/drawing_process.h"

#include "app/base/interrupt.h"
#include "app/base/open_files.h"

#include "core/base/guarded_run.h"
#include "ui/report/document_pdf.h"
#include "ui/report/report_drawing.h"

#include <QApplication>
#include <QHashSeed>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace dyncal {
namespace {

/// Qt's remarks about its platform are not meant for the operator.
void ignoreMessage(QtMsgType, const QMessageLogContext &, const QString &) { }

/// Drawing needs an application object but no display, and must come out the same on every
/// machine: no display scaling, no random order of hashes.
void prepareForQt()
{
    for (const char *name : {"QT_SCALE_FACTOR", "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI",
             "QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME"})
        qunsetenv(name);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Without such a folder Qt makes one, and the folder for temporary files that it is in: drawing
    // needs none, and what is no folder is left alone.
    qputenv("XDG_RUNTIME_DIR", "/dev/null");
    qInstallMessageHandler(ignoreMessage);
    QHashSeed::setDeterministicGlobalSeed();
}

/// What the drawing process sends: heartbeats while it draws, then the files (a line with name and
/// size before the bytes of each), then the mark that all is there.
constexpr char kAlive = '.';
constexpr char kFiles = 'F';
constexpr char kEnd = 'E';

/// Draws, and calls its argument now and then meanwhile.
using Drawing = std::function<Result<std::vector<DrawnFile>>(const std::function<void()> &beat)>;

void sendDrawing(const Drawing &draw, GuardedOutput &output)
{
    prepareForQt();
    // Neither is what a library prints before it gives up.
    if (const int nowhere = ::open("/dev/null", O_WRONLY); nowhere >= 0)
        ::dup2(nowhere, STDERR_FILENO);
    int argc = 1;
    std::array<char, 7> name{"dyncal"};
    std::array<char *, 2> argv{name.data(), nullptr};
    const QApplication application(argc, argv.data());
    const Result<std::vector<DrawnFile>> drawn
        = draw([&] { output.write(std::string_view(&kAlive, 1)); });
    if (!drawn)
        return;
    output.write(std::string_view(&kFiles, 1));
    for (const DrawnFile &file : *drawn) {
        output.write(file.name + '\n' + std::to_string(file.bytes.size()) + '\n');
        output.write(file.bytes);
    }
    output.write(std::string_view(&kEnd, 1));
}

/// The files of such a message; empty if it is not whole.
std::optional<std::vector<DrawnFile>> filesIn(std::string_view message)
{
    message.remove_prefix(std::min(message.find_first_not_of(kAlive), message.size()));
    if (message.size() < 2 || message.front() != kFiles || message.back() != kEnd)
        return std::nullopt;
    message = message.substr(1, message.size() - 2);
    std::vector<DrawnFile> files;
    while (!message.empty()) {
        const std::size_t name = message.find('\n');
        const std::size_t line = name == message.npos ? name : message.find('\n', name + 1);
        if (line == message.npos)
            return std::nullopt;
        const std::string_view digits = message.substr(name + 1, line - name - 1);
        std::size_t size = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), size);
        if (size == 0 || size > message.size() - line - 1)
            return std::nullopt;
        files.push_back(
            {std::string(message.substr(0, name)), std::string(message.substr(line + 1, size))});
        message.remove_prefix(line + 1 + size);
    }
    return files;
}

Result<std::vector<DrawnFile>> drawnElsewhere(const Drawing &draw)
{
    constexpr GuardedLimits kLimits{std::uint64_t(4) << 30U, std::chrono::minutes(2)};
    constexpr int kFilesOfDrawing = 10;
    if (!areFilesLeft(kFilesOfDrawing))
        return tl::unexpected<Error>(tooFewFiles());
    std::string message;
    const GuardedOutcome outcome
        = runGuarded([&](GuardedOutput &output) { sendDrawing(draw, output); },
            [&](std::span<const std::byte> bytes) {
                message.append(reinterpret_cast<const char *>(bytes.data()), bytes.size());
                return true;
            },
            kLimits, interruptToken());
    if (outcome == GuardedOutcome::Stopped)
        return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
    if (outcome == GuardedOutcome::Killed)
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "The documents were not drawn because the system or another program ended the helper process that draws them, most likely for want of memory, and nothing was written; close other programs and try again."),
                {}});
    std::optional<std::vector<DrawnFile>> files
        = outcome == GuardedOutcome::Finished ? filesIn(message) : std::nullopt;
    if (!files)
        return fail(ErrorKind::Internal,
            {DYNCAL_TEXT("core",
                 "The documents could not be drawn, most likely because there is not enough memory, and nothing was written; close other programs or raise the memory limit."),
                {}});
    return std::move(*files);
}

Result<std::vector<DrawnFile>> drawnInSteps(
    ReportDrawing &drawing, const std::function<void()> &beat)
{
    constexpr std::chrono::milliseconds kBeat{200};
    while (!drawing.isDone()) {
        drawing.draw(kBeat);
        beat();
    }
    return drawing.take();
}

} // namespace

Result<std::vector<DrawnFile>> drawWithoutWindow(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const ChosenTemplate &chosen)
{
    return drawnElsewhere([&](const std::function<void()> &beat) {
        ReportDrawing drawing(
            results, recipe, createdUtc, ReportParts::CertificateAndPlots, chosen);
        return drawnInSteps(drawing, beat);
    });
}

Result<std::vector<DrawnFile>> drawWithoutWindow(const CalibrationResults &results,
    const Recipe &recipe, const std::string &createdUtc, const ChosenTemplate &chosen,
    const CertificateIssue &issue, const std::vector<FigureMaker> &moreFigures)
{
    return drawnElsewhere([&](const std::function<void()> &beat) {
        ReportDrawing drawing(
            results, recipe, createdUtc, ReportParts::Certificate, chosen, issue, moreFigures);
        return drawnInSteps(drawing, beat);
    });
}

Result<std::vector<DrawnFile>> drawWithoutWindow(
    const CertificateData &document, const std::string &name)
{
    return drawnElsewhere([&](const std::function<void()> &) {
        return documentPdf(document).map([&](const std::string &bytes) {
            return std::vector<DrawnFile>{{name, bytes}};
        });
    });
}

} // namespace dyncal
