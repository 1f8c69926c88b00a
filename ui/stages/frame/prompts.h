// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QCoreApplication>
#include <QQueue>
#include <QStringList>

#include <optional>

class QWidget;

namespace dyncal {

enum class Answer { Save, Discard, Cancel };
enum class ChangedProject { OtherName, Replace, Cancel };
enum class MissingRecordings { Locate, ViewResults, Cancel };

/// Every dialog that asks the operator something. Tests make it scripted: then nothing opens, the
/// answers put in are given in order (Cancel when there is none), and messages are kept.
class Prompts
{
    Q_DECLARE_TR_FUNCTIONS(Prompts)

public:
    QStringList openFiles(
        QWidget *parent, const QString &title, const QString &filter, const QString &folder);
    QString openFile(
        QWidget *parent, const QString &title, const QString &filter, const QString &folder);
    /// Path with `suffix` added when the operator typed none; empty = cancelled.
    QString saveFile(QWidget *parent, const QString &title, const QString &filter,
        const QString &proposed, const QString &suffix);
    QString folder(QWidget *parent, const QString &title, const QString &folder);
    Answer saveChanges(QWidget *parent, const QString &project);
    /// What to do where the project's file is not the one that this window read or saved: another
    /// window or program wrote it, or (not `isThere`) took it away.
    ChangedProject changedProject(QWidget *parent, const QString &path, bool isThere);
    /// What to do where recordings of a project are missing, as `sentence` says; `areKept`: there
    /// are results to look at.
    MissingRecordings missingRecordings(QWidget *parent, const QString &sentence, bool areKept);
    std::optional<QString> sentence(QWidget *parent, const QString &title, const QString &label);
    void showProblem(QWidget *parent, const QString &sentence);

    void setScripted() { m_scripted = true; }
    void setNextFile(const QString &path) { setNextFiles({path}); }
    void setNextFiles(const QStringList &paths) { m_files.enqueue(paths); }
    void setNextAnswer(Answer answer) { m_answers.enqueue(answer); }
    void setNextChangedProject(ChangedProject answer) { m_changedProjects.enqueue(answer); }
    void setNextMissing(MissingRecordings answer) { m_missing.enqueue(answer); }
    int changedProjectsAsked() const { return m_asked; }
    void dropAnswers(); ///< those that were put in and not asked for
    void setNextSentence(const QString &text) { m_sentences.enqueue(text); }
    const QStringList &shownProblems() const { return m_problems; }

private:
    QStringList nextFiles() { return m_files.isEmpty() ? QStringList() : m_files.dequeue(); }

    bool m_scripted = false;
    QQueue<QStringList> m_files;
    QQueue<Answer> m_answers;
    QQueue<ChangedProject> m_changedProjects;
    QQueue<MissingRecordings> m_missing;
    int m_asked = 0; ///< about changed projects
    QQueue<QString> m_sentences;
    QStringList m_problems;
};

} // namespace dyncal
