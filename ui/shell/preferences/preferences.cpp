// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/preferences/preferences.h"

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocale>

namespace dyncal {

namespace {

constexpr int kMostRecentFiles = 10;
/// Raised when docks are added or renamed, so that an old layout is not restored onto new docks.
constexpr int kLayoutVersion = 2;

QString issuingKey(Preferences::Issuing what)
{
    constexpr const char *kKeys[]{"issuing/by", "issuing/folder", "issuing/registry",
        "issuing/signature", "issuing/key", "issuing/token", "issuing/service", "issuing/authority",
        "issuing/trust"};
    return kKeys[static_cast<std::size_t>(what)];
}

} // namespace

Preferences::Preferences(const QString &path)
    : m_settings(path.isEmpty() ? QSettings().fileName() : path,
        path.isEmpty() ? QSettings::NativeFormat : QSettings::IniFormat)
{
}

QString Preferences::language() const
{
    const QString system = QLocale::system().language() == QLocale::Swedish ? "sv" : "en";
    const QString chosen = m_settings.value("language", system).toString();
    return chosen == "sv" ? chosen : QString("en");
}

void Preferences::setLanguage(const QString &language)
{
    m_settings.setValue("language", language);
}

ThemeKind Preferences::theme() const
{
    const QVariant chosen = m_settings.value("theme");
    return chosen.isValid() ? themeKindFromName(chosen.toString())
                            : themeKindOf(QGuiApplication::palette());
}

void Preferences::setTheme(ThemeKind kind)
{
    m_settings.setValue("theme", themeName(kind));
}

QByteArray Preferences::geometry() const
{
    return m_settings.value("window/geometry").toByteArray();
}

QByteArray Preferences::layout() const
{
    if (m_settings.value("window/layoutVersion").toInt() != kLayoutVersion)
        return {};
    return m_settings.value("window/layout").toByteArray();
}

void Preferences::setWindow(const QByteArray &geometry, const QByteArray &layout)
{
    m_settings.setValue("window/geometry", geometry);
    m_settings.setValue("window/layout", layout);
    m_settings.setValue("window/layoutVersion", kLayoutVersion);
}

bool Preferences::notesOpen() const
{
    return m_settings.value("findings/notesOpen", false).toBool();
}

void Preferences::setNotesOpen(bool open)
{
    m_settings.setValue("findings/notesOpen", open);
}

QString Preferences::profileFolder() const
{
    return QFileInfo(m_settings.fileName()).dir().filePath("import-profiles");
}

QString Preferences::lastFolder() const
{
    return m_settings.value("lastFolder", QDir::homePath()).toString();
}

void Preferences::setLastFolder(const QString &folder)
{
    m_settings.setValue("lastFolder", folder);
}

QString Preferences::issuing(Issuing what) const
{
    return m_settings.value(issuingKey(what)).toString();
}

void Preferences::setIssuing(Issuing what, const QString &text)
{
    m_settings.setValue(issuingKey(what), text);
}

QStringList Preferences::recentFiles() const
{
    QStringList files = m_settings.value("recentFiles").toStringList();
    files.removeIf([](const QString &path) { return !QFileInfo::exists(path); });
    return files;
}

void Preferences::addRecentFile(const QString &path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings.setValue("recentFiles", files.mid(0, kMostRecentFiles));
}

} // namespace dyncal
