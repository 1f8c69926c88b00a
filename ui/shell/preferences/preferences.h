// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/plot/values/theme.h"

#include <QSettings>
#include <QStringList>

namespace dyncal {

/// What the program remembers between runs. Nothing here changes a result.
class Preferences
{
public:
    /// `path`: an ini file; empty = the user's own settings. Tests give a temporary one.
    explicit Preferences(const QString &path = {});

    QString language() const; ///< "en" or "sv"
    void setLanguage(const QString &language);

    ThemeKind theme() const; ///< dark where the desktop is, until one was chosen
    void setTheme(ThemeKind kind);

    QByteArray geometry() const;
    QByteArray layout() const;
    void setWindow(const QByteArray &geometry, const QByteArray &layout);

    /// Whether findings that are only good to know are opened.
    bool notesOpen() const;
    void setNotesOpen(bool open);

    /// Where profiles of import are kept: beside the settings.
    QString profileFolder() const;

    QString lastFolder() const;
    void setLastFolder(const QString &folder);

    /// Of issued certificates: who issues them, where their folders go, which registry (without a
    /// server's password), who signs (a SigningWay, its key, token, service and
    /// authority; never a PIN), and which certificates are trusted when verifying. Empty until they
    /// were given.
    enum class Issuing { By, Folder, Registry, Way, KeyFile, Token, Service, Authority, Trust };
    QString issuing(Issuing what) const;
    void setIssuing(Issuing what, const QString &text);

    /// Projects opened last, newest first, at most ten, only those that still exist.
    QStringList recentFiles() const;
    void addRecentFile(const QString &path);

private:
    mutable QSettings m_settings;
};

} // namespace dyncal
