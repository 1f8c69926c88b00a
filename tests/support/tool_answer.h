// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <string>

namespace dyncal::testing {

/// What another program answers about a file of these bytes.
struct ToolAnswer
{
    int exitCode = -1; ///< -1: the program is not there, or was killed
    QByteArray out, error;
};

/// Runs `tool` with arguments, in which "FILE" is a file of these bytes, in a folder of its own;
/// `made`: a file that it is to write, whose bytes are its answer.
inline ToolAnswer askTool(
    const QString &tool, QStringList arguments, const std::string &bytes, const QString &made = {})
{
    const QTemporaryDir folder;
    QFile file(folder.filePath("file.pdf"));
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    file.close();
    arguments.replaceInStrings("FILE", file.fileName());
    QProcess process;
    process.setWorkingDirectory(folder.path());
    process.start(tool, arguments);
    if (!process.waitForFinished(60000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    ToolAnswer answer{
        process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    QFile output(folder.filePath(made));
    if (!made.isEmpty() && output.open(QIODevice::ReadOnly))
        answer.out = output.readAll();
    return answer;
}

} // namespace dyncal::testing
