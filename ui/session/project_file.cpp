// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/project_file.h"

#include "core/base/content_hash.h"
#include "core/base/writing/atomic_file.h"
#include "core/base/writing/write_problem.h"
#include "core/capture/capture_seal.h"
#include "core/project/strict_json.h"
#include "core/project/template_choice.h"
#include "core/reference/reference_source.h"
#include "ui/session/capture_edit.h"
#include "ui/session/capture_reading.h"
#include "ui/session/example.h"
#include "ui/session/project_checksum.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <set>

namespace dyncal {

namespace {

constexpr const char *kFormat = "dyncal-project";
constexpr int kOldestVersion = 1;
/// A project holds settings only; anything larger is another kind of file.
constexpr qint64 kLargestProject_bytes = 64 << 20;

struct CaptureReference
{
    QString path; ///< as it is found now, or as written when it is missing
    std::optional<QString> sha256; ///< none: not known yet when it was written
    bool found = false;
    std::set<Index> shots = {}; ///< those of the file that belong to the job; empty = all
};

/// Shots that were taken out of the job must stay out: everything goes by their number.
QJsonArray shotsOf(const CaptureSet &set, Index input)
{
    QJsonArray places;
    for (const Shot &shot : set.shots) {
        if (shot.input == input && shot.inFile > 0)
            places.append(static_cast<qint64>(shot.inFile));
    }
    return places;
}

/// The hash of the recording when the job took it in: saving does not accept later changes of it.
QJsonValue hashOf(const InputFile &input)
{
    const std::string hash = input.expectedSha256.value_or(input.sha256);
    return hash.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(hash));
}

/// `folder` empty: by name only.
QJsonArray captureReferences(const ProjectState &state, const QString &folder)
{
    QJsonArray list;
    for (std::size_t i = 0; i < state.captures->inputs.size(); ++i) {
        const InputFile &input = state.captures->inputs[i];
        const QString path = QString::fromStdString(input.path);
        QJsonObject entry{
            {"sha256", hashOf(input)}, {"shots", shotsOf(*state.captures, static_cast<Index>(i))}};
        if (input.path == kExamplePath) {
            entry["path"] = path;
        } else if (folder.isEmpty()) {
            entry["path"] = QFileInfo(path).fileName();
        } else {
            const QString absolute = QFileInfo(path).absoluteFilePath();
            entry["path"] = QDir(folder).relativeFilePath(absolute);
            entry["absolute_path"] = absolute;
        }
        list.append(entry);
    }
    return list;
}

/// A template's file below the project's folder is named from there, so that both move together;
/// one elsewhere, by its place.
Recipe asWritten(Recipe recipe, const QString &folder)
{
    std::string &name = recipe.certificate.templateName;
    const QString place = QString::fromStdString(name);
    if (folder.isEmpty() || !isTemplateFile(name) || QDir::isRelativePath(place))
        return recipe;
    const QString relative = QDir(folder).relativeFilePath(place);
    if (!relative.startsWith(QLatin1String("../")))
        name = relative.toStdString();
    return recipe;
}

/// The version as written in the file.
std::string versionText(const QJsonValue &version)
{
    const std::string text
        = QJsonDocument(QJsonArray{version}).toJson(QJsonDocument::Compact).toStdString();
    return version.isUndefined() ? "none" : text.substr(1, text.size() - 2);
}

Result<void> checkVersion(const std::string &project, const QJsonValue &version)
{
    const double number = version.toDouble(0.0);
    if (number > kProjectVersion)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "Project %1 was written by a newer program: it has version %2, and this program reads up to version %3; open it with the newer program."),
                {project, versionText(version), std::to_string(kProjectVersion)}});
    if (number >= kOldestVersion && number == std::floor(number))
        return {};
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "Project %1 has version %2, which no program writes (versions go from %3 to %4); take an unchanged copy of the project."),
            {project, versionText(version), std::to_string(kOldestVersion),
                std::to_string(kProjectVersion)}});
}

CaptureReference locate(
    const QJsonObject &entry, const QDir &folder, const QStringList &otherFolders)
{
    CaptureReference reference{entry["path"].toString(), {}};
    if (!entry["sha256"].isNull()) // null: not sealed. A key taken out is not null
        reference.sha256 = entry["sha256"].toString();
    for (const auto &place : entry["shots"].toArray())
        reference.shots.insert(static_cast<Index>(place.toInteger()));
    if (reference.path == kExamplePath) {
        reference.found = true;
        return reference;
    }
    QStringList candidates{
        folder.absoluteFilePath(reference.path), entry["absolute_path"].toString()};
    for (const QString &other : otherFolders)
        candidates << QDir(other).filePath(QFileInfo(reference.path).fileName());
    for (const QString &candidate : candidates) {
        if (!reference.found && !candidate.isEmpty() && QFileInfo(candidate).isFile()) {
            reference.path = QDir::cleanPath(candidate);
            reference.found = true;
        }
    }
    return reference;
}

/// Without the shots that do not belong to the job.
CaptureSet onlyReferenced(CaptureSet set, const std::vector<CaptureReference> &references)
{
    return withoutShots(std::move(set), [&](const Shot &shot) {
        const auto input = static_cast<std::size_t>(shot.input);
        const bool known = input < references.size() && !references[input].shots.empty();
        return known && !references[input].shots.contains(shot.inFile);
    });
}

/// A project is whole or not opened at all.
Result<CaptureSet> readReferenced(const std::vector<CaptureReference> &references,
    const ImportSettings &settings, const JobControl &control)
{
    std::vector<std::string> paths;
    paths.reserve(references.size());
    for (const CaptureReference &reference : references)
        paths.push_back(reference.path.toStdString());
    Result<CapturesRead> read = readEach(paths, settings, control);
    if (!read)
        return tl::unexpected(read.error());
    if (!read->problems.empty())
        return tl::unexpected(read->problems.front().error);
    return std::move(read->set);
}

/// Whether the bytes still have these hashes is known once they are sealed.
void expectHashes(CaptureSet &set, const std::vector<CaptureReference> &references)
{
    for (std::size_t i = 0; i < references.size() && i < set.inputs.size(); ++i)
        if (references[i].sha256)
            set.inputs[i].expectedSha256 = references[i].sha256->toStdString();
    reportUnexpected(set);
}

} // namespace

Result<ProjectFile> readProjectFile(const QString &path)
{
    const std::string name = QFileInfo(path).fileName().toStdString();
    // Opening a pipe would wait until somebody writes to it, perhaps for ever.
    if (const QFileInfo place(path); place.exists() && !place.isFile())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT(
                 "core", "Project %1 is a folder or a device, not a file; name a project file."),
                {name}});
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core", "Project %1 cannot be opened (%2)."),
                {name, file.errorString().toStdString()}});
    const QByteArray bytes = file.read(kLargestProject_bytes);
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &problem);
    if (!document.isObject() || document["format"].toString() != kFormat)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT(
                 "core", "%1 is not a Dyncal project; recordings are opened with Open captures."),
                {name}});
    const std::string text = bytes.toStdString();
    const Result<void> isStrict = checkStrictJson(text, "Project " + name);
    if (!isStrict)
        return fail(ErrorKind::FileUnreadable, isStrict.error().message);
    const QJsonValue version = document["version"];
    if (const Result<void> isKnown = checkVersion(name, version); !isKnown)
        return tl::unexpected<Error>(isKnown.error());
    return ProjectFile{path, document.object(), sha256Hex(text), version.toInt()};
}

std::optional<Finding> olderVersion(const ProjectFile &file)
{
    if (file.version >= kProjectVersion)
        return std::nullopt;
    return Finding{.id = kOlderProject,
        .severity = Severity::Caution,
        .message
        = {DYNCAL_TEXT("core",
               "Project %1 was written by an older program, as version %2; saving it writes version %3, which that program cannot open. Save it under another name to keep the old one."),
            {QFileInfo(file.path).fileName().toStdString(), std::to_string(file.version),
                std::to_string(kProjectVersion)}}};
}

Result<Recipe> recipeOfProject(const QJsonObject &project)
{
    if (!project["recipe"].isObject())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "The project holds no recipe: the key \"recipe\" is missing or no object; take "
                 "another copy of the project."),
                {}});
    return parseRecipe(
        QJsonDocument(project["recipe"].toObject()).toJson(QJsonDocument::Compact).toStdString());
}

QByteArray projectBytes(
    const ProjectState &state, const QString &folder, const QJsonObject &moreKeys)
{
    const QJsonDocument recipe = QJsonDocument::fromJson(
        QByteArray::fromStdString(recipeJson(asWritten(state.recipe, folder))));
    QJsonObject project = moreKeys;
    project["format"] = kFormat;
    project["version"] = kProjectVersion;
    project["recipe"] = recipe.object();
    project["captures"] = captureReferences(state, folder);
    return QJsonDocument(withChecksums(project)).toJson();
}

QByteArray frozenProjectBytes(const ProjectState &state)
{
    return projectBytes(state, {});
}

ProjectFileHash projectFileHash(const QString &path)
{
    const QFileInfo file(path);
    if (!file.exists() && !file.isSymLink())
        return std::nullopt;
    return sha256OfFile(path.toStdString());
}

Result<std::string> saveProject(const QString &path, const ProjectState &state,
    const ProjectFileHash &expected, const QJsonObject &moreKeys)
{
    const std::string bytes
        = projectBytes(state, QFileInfo(path).absolutePath(), moreKeys).toStdString();
    const Result<void> written = replaceUnchangedFile(path.toStdString(), bytes, expected);
    if (written)
        return sha256Hex(bytes);
    if (written.error().findingId == kChangedMeanwhile)
        return tl::unexpected(written.error());
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core", "The project could not be saved as %1 (%M1); choose another place."),
            {path.toStdString()}, {written.error().message}});
}

Result<ProjectState> openProject(
    const QString &path, const JobControl &control, const QStringList &otherFolders)
{
    const Result<ProjectFile> file = readProjectFile(path);
    if (!file)
        return tl::unexpected(file.error());
    return openProject(*file, control, otherFolders);
}

Result<ProjectState> openProject(
    const ProjectFile &file, const JobControl &control, const QStringList &otherFolders)
{
    Result<Recipe> recipe = recipeOfProject(file.content);
    if (!recipe)
        return tl::unexpected(recipe.error());

    const QDir folder = QFileInfo(file.path).absoluteDir();
    loadSource(folder.path().toStdString(), recipe->comparison);
    loadSource(folder.path().toStdString(), recipe->chain);
    locateTemplate(folder.filePath(QStringLiteral("project")).toStdString(), *recipe);
    std::vector<CaptureReference> references;
    QStringList missing;
    for (const auto &entry : file.content["captures"].toArray()) {
        references.push_back(locate(entry.toObject(), folder, otherFolders));
        if (!references.back().found)
            missing << QDir::cleanPath(folder.absoluteFilePath(references.back().path));
    }
    if (!missing.isEmpty())
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 recordings of this project were not found: %2. Put them back where they were, or beside the project, and open it again."),
                {std::to_string(missing.size()), missing.join(", ").toStdString()}},
            kMissingRecordings);
    Result<CaptureSet> set = readReferenced(references, recipe->import, control);
    if (!set)
        return tl::unexpected(set.error());
    expectHashes(*set, references);
    const Findings ofProject = checkProject(file.content, QFileInfo(file.path).fileName());
    set->findings.insert(set->findings.begin(), ofProject.begin(), ofProject.end());
    CaptureSet kept = onlyReferenced(std::move(*set), references);
    return ProjectState{std::make_shared<const CaptureSet>(std::move(kept)), std::move(*recipe)};
}

} // namespace dyncal
