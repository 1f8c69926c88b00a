// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/shell/main_window.h"

#include <QTemporaryDir>

#include <memory>

namespace dyncal::test {

/// The main window in English over a pipeline of the test's own, with scripted dialogs, its own
/// settings file and a clock that stands still; not shown yet.
struct WindowBench
{
    QTemporaryDir folder;
    Preferences preferences{folder.filePath("settings.ini")};
    Prompts prompts;
    Language language;
    std::unique_ptr<MainWindow> window;

    explicit WindowBench(Session::Pipeline pipeline)
    {
        language.install("en");
        prompts.setScripted();
        preferences.setLastFolder(folder.path());
        window = std::make_unique<MainWindow>(
            std::move(pipeline), [] { return Result<std::string>("2026-01-31T12:00:00Z"); },
            preferences, prompts, language);
    }

    template <typename T>
    T *find(const QString &name) const
    {
        T *found = window->findChild<T *>(name);
        if (!found)
            qFatal("no %s", qPrintable(name));
        return found;
    }
};

} // namespace dyncal::test
