// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/import/capture_import.h"

#include "ui/session/capture_edit.h"
#include "ui/session/import_view.h"
#include "ui/shell/import/import_dialog.h"
#include "ui/shell/preferences/preferences.h"
#include "ui/text/shown_text.h"

#include <algorithm>
#include <iterator>

namespace dyncal {

/// What was read in the background.
struct CaptureImport::Outcome
{
    std::optional<CapturesRead> again; ///< the files of the job, where they had to be read again
    CapturesRead fresh;
    std::string question; ///< file that needs an answer, or empty
};

namespace {

std::string questionIn(const CapturesRead &read, const ImportSettings &settings)
{
    for (const FileProblem &problem : read.problems)
        if (isQuestion(problem.error))
            return problem.path;
    return fileWithQuestion(read.set, settings);
}

std::vector<std::string> strings(const QStringList &paths)
{
    std::vector<std::string> list;
    for (const QString &path : paths)
        list.push_back(path.toStdString());
    return list;
}

} // namespace

CaptureImport::CaptureImport(Session &session, Preferences &preferences, QWidget *window)
    : QObject(window)
    , m_session(session)
    , m_preferences(preferences)
    , m_window(window)
    , m_jobs(this)
{
}

void CaptureImport::read(const QStringList &paths, bool add)
{
    start({paths, add, add ? m_session.recipe().import : ImportSettings{}, true,
        tr("Add recordings")});
}

void CaptureImport::change(const ImportSettings &next, const QString &step)
{
    if (needsReading(*m_session.state().captures, m_session.recipe().import, next)) {
        start({{}, true, next, false, step});
        return;
    }
    Recipe recipe = m_session.recipe();
    recipe.import = next;
    m_session.apply(recipe, step);
}

void CaptureImport::rereadJob(const QString &folder)
{
    Request request{{}, true, m_session.recipe().import, false, tr("Read recordings again")};
    request.again = true;
    request.folder = folder;
    start(request);
}

void CaptureImport::edit(const QString &path)
{
    const auto &inputs = m_session.state().captures->inputs;
    const bool ofTheJob
        = std::ranges::find(inputs, path.toStdString(), &InputFile::path) != inputs.end();
    const bool add = m_session.state().hasShots();
    ImportDialog *dialog = openDialog(path, add ? m_session.recipe().import : ImportSettings{}, 1);
    connect(dialog, &ImportDialog::accepted, this, [this, dialog, path, add, ofTheJob] {
        if (ofTheJob)
            change(dialog->settings(), tr("Change the import settings"));
        else
            start({{path}, add, dialog->settings(), false, tr("Add recordings")});
    });
}

void CaptureImport::start(const Request &request)
{
    emit busy(tr("Reading recordings"));
    const std::shared_ptr<const CaptureSet> earlier
        = request.add ? m_session.state().captures : std::make_shared<const CaptureSet>();
    const bool again
        = request.again || needsReading(*earlier, m_session.recipe().import, request.settings);
    m_jobs.start<std::shared_ptr<const Outcome>>(
        [paths = strings(request.paths), settings = request.settings, earlier, again,
            folder = request.folder.toStdString()](
            const JobControl &control) -> Result<std::shared_ptr<const Outcome>> {
            auto outcome = std::make_shared<Outcome>();
            if (again) {
                Result<CapturesRead> read
                    = readAgain(relocated(*earlier, folder), settings, control);
                if (!read)
                    return tl::unexpected(read.error());
                outcome->again = std::move(*read);
            }
            Result<CapturesRead> read = readEach(paths, settings, control);
            if (!read)
                return tl::unexpected(read.error());
            outcome->fresh = std::move(*read);
            outcome->question = questionIn(outcome->fresh, settings);
            return std::shared_ptr<const Outcome>(std::move(outcome));
        },
        [this, request](const Result<std::shared_ptr<const Outcome>> &outcome) {
            emit idle({});
            if (outcome)
                deliver(request, *outcome);
            else // an unexpected condition, which belongs to no file
                emit problemsChanged({},
                    {{request.paths.join(QStringLiteral(", ")).toStdString(), outcome.error()}});
        },
        [this](double done) { emit progress(done); });
}

void CaptureImport::deliver(const Request &request, const std::shared_ptr<const Outcome> &outcome)
{
    const QString question = rawText(outcome->question);
    if (request.mayAsk && !question.isEmpty() && question != request.asked)
        ask(question, request, outcome);
    else
        take(request, *outcome);
}

/// Without an answer, what can be read is taken all the same.
void CaptureImport::ask(
    const QString &path, const Request &request, const std::shared_ptr<const Outcome> &outcome)
{
    ImportDialog *dialog
        = openDialog(path, request.settings, static_cast<int>(request.paths.size()));
    connect(dialog, &ImportDialog::accepted, this, [this, dialog, request, path] {
        Request answered = request;
        answered.settings = dialog->settings();
        answered.asked = path; // the answer may be for this file only, then the next one asks
        start(answered);
    });
    connect(dialog, &ImportDialog::rejected, this,
        [this, request, outcome] { take(request, *outcome); });
}

void CaptureImport::take(const Request &request, const Outcome &outcome)
{
    std::vector<std::string> tried = strings(request.paths);
    if (request.again)
        std::ranges::transform(
            m_session.state().captures->inputs, std::back_inserter(tried), &InputFile::path);
    if (outcome.again && !outcome.again->problems.empty()) {
        // The files of the job do not read this way: it stays as it is.
        std::vector<FileProblem> problems = outcome.again->problems;
        problems.insert(
            problems.end(), outcome.fresh.problems.begin(), outcome.fresh.problems.end());
        emit problemsChanged(tried, problems);
        return;
    }
    if (request.add)
        addToJob(request, outcome);
    else if (!outcome.fresh.set.shots.empty()) {
        ProjectState state{std::make_shared<const CaptureSet>(outcome.fresh.set), {}};
        state.recipe.import = request.settings;
        forgetMissingNames(state.recipe.import, *state.captures);
        emit newJob(state);
    }
    if (!outcome.fresh.set.shots.empty())
        emit idle(tr("%n shot(s) read", nullptr, static_cast<int>(outcome.fresh.set.shots.size())));
    emit problemsChanged(tried, outcome.fresh.problems);
}

void CaptureImport::addToJob(const Request &request, const Outcome &outcome)
{
    if (outcome.fresh.set.shots.empty() && !request.paths.isEmpty())
        return;
    ProjectState next = m_session.state();
    const CaptureSet &earlier = outcome.again ? outcome.again->set : *next.captures;
    next.captures = std::make_shared<const CaptureSet>(
        addedCaptures(earlier, outcome.fresh.set, request.settings));
    next.recipe.import = request.settings;
    forgetMissingNames(next.recipe.import, *next.captures);
    if (!next.recipe.import.levels.empty()) // one for each shot
        next.recipe.import.levels.resize(next.captures->shots.size());
    if (!next.recipe.window.ownEnds_s.empty())
        next.recipe.window.ownEnds_s.resize(next.captures->shots.size());
    m_session.applyState(next, request.step);
}

ImportDialog *CaptureImport::openDialog(
    const QString &path, const ImportSettings &settings, int files)
{
    auto *dialog = new ImportDialog(path, settings, files, m_preferences.profileFolder(), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
    return dialog;
}

} // namespace dyncal
