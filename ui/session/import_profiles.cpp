// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/session/import_profiles.h"

#include "core/base/writing/atomic_file.h"
#include "core/project/recipe.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>

namespace dyncal {

namespace {

constexpr const char *kSuffix = ".json";
constexpr qsizetype kLongestName = 80;

} // namespace

ImportProfiles::ImportProfiles(const QString &folder)
    : m_folder(folder)
{
}

QStringList ImportProfiles::names() const
{
    QStringList names;
    const QStringList files = QDir(m_folder).entryList(
        {QStringLiteral("*") + kSuffix}, QDir::Files, QDir::Name | QDir::IgnoreCase);
    for (const QString &file : files)
        names << file.chopped(static_cast<qsizetype>(std::string_view(kSuffix).size()));
    return names;
}

QString ImportProfiles::pathOf(const QString &name) const
{
    return QDir(m_folder).filePath(name + kSuffix);
}

Result<ImportSettings> ImportProfiles::load(const QString &name) const
{
    const Result<Recipe> recipe = readRecipeFile(pathOf(name).toStdString());
    if (!recipe)
        return tl::unexpected(recipe.error());
    return recipe->import;
}

Result<void> ImportProfiles::save(const QString &name, ImportSettings settings) const
{
    if (!isProfileName(name) || !QDir().mkpath(m_folder))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core", "The profile cannot be kept as \"%1\"; choose another name."),
                {name.toStdString()}});
    settings.levels.clear();
    settings.exclude.clear();
    settings.shots.clear();
    settings.files.clear();
    Recipe recipe;
    recipe.import = std::move(settings);
    const QJsonObject whole
        = QJsonDocument::fromJson(QByteArray::fromStdString(recipeJson(recipe))).object();
    QJsonObject profile;
    for (const char *key : {"schema", "import"})
        profile[QLatin1String(key)] = whole[QLatin1String(key)];
    return writeFileAtomically(
        pathOf(name).toStdString(), QJsonDocument(profile).toJson().toStdString());
}

bool isProfileName(const QString &name)
{
    return !name.isEmpty() && name.size() <= kLongestName && name == name.trimmed()
        && !name.startsWith('.') && !name.contains('/') && !name.contains('\\');
}

} // namespace dyncal
