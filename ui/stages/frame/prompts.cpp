// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/frame/prompts.h"

#include "ui/text/shown_text.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>

namespace dyncal {

QStringList Prompts::openFiles(
    QWidget *parent, const QString &title, const QString &filter, const QString &folder)
{
    if (m_scripted)
        return nextFiles();
    return QFileDialog::getOpenFileNames(parent, title, folder, filter);
}

QString Prompts::openFile(
    QWidget *parent, const QString &title, const QString &filter, const QString &folder)
{
    if (m_scripted)
        return nextFiles().value(0);
    return QFileDialog::getOpenFileName(parent, title, folder, filter);
}

QString Prompts::saveFile(QWidget *parent, const QString &title, const QString &filter,
    const QString &proposed, const QString &suffix)
{
    QString path = m_scripted ? nextFiles().value(0)
                              : QFileDialog::getSaveFileName(parent, title, proposed, filter);
    if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty())
        path += "." + suffix;
    return path;
}

QString Prompts::folder(QWidget *parent, const QString &title, const QString &folder)
{
    if (m_scripted)
        return nextFiles().value(0);
    return QFileDialog::getExistingDirectory(parent, title, folder);
}

Answer Prompts::saveChanges(QWidget *parent, const QString &project)
{
    if (m_scripted)
        return m_answers.isEmpty() ? Answer::Cancel : m_answers.dequeue();
    const auto button = QMessageBox::warning(parent, tr("Unsaved changes"),
        tr("%1 has changes that are not saved. Save them?").arg(shownText(project)),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (button == QMessageBox::Save)
        return Answer::Save;
    return button == QMessageBox::Discard ? Answer::Discard : Answer::Cancel;
}

ChangedProject Prompts::changedProject(QWidget *parent, const QString &path, bool isThere)
{
    ++m_asked;
    if (m_scripted)
        return m_changedProjects.isEmpty() ? ChangedProject::Cancel : m_changedProjects.dequeue();
    QMessageBox box(QMessageBox::Warning, tr("Project changed"),
        isThere ? tr(
            "%1 was changed by another window or program since it was opened or saved here. Replacing it loses those changes.")
                      .arg(shownText(path))
                : tr("%1 was removed or moved since it was opened or saved here.")
                      .arg(shownText(path)),
        QMessageBox::Cancel, parent);
    box.setTextFormat(Qt::PlainText);
    const QPushButton *other
        = box.addButton(tr("Save under another name..."), QMessageBox::AcceptRole);
    const QPushButton *replace = box.addButton(
        isThere ? tr("Replace it") : tr("Save it there again"), QMessageBox::DestructiveRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() == other)
        return ChangedProject::OtherName;
    return box.clickedButton() == replace ? ChangedProject::Replace : ChangedProject::Cancel;
}

MissingRecordings Prompts::missingRecordings(QWidget *parent, const QString &sentence, bool areKept)
{
    m_problems << sentence;
    if (m_scripted)
        return m_missing.isEmpty() ? MissingRecordings::Cancel : m_missing.dequeue();
    QMessageBox box(
        QMessageBox::Warning, tr("Recordings missing"), sentence, QMessageBox::Cancel, parent);
    box.setTextFormat(Qt::PlainText);
    const QPushButton *locate = box.addButton(tr("Locate..."), QMessageBox::AcceptRole);
    QPushButton *view = box.addButton(tr("View kept results"), QMessageBox::ActionRole);
    view->setEnabled(areKept);
    box.exec();
    if (box.clickedButton() == locate)
        return MissingRecordings::Locate;
    return box.clickedButton() == view ? MissingRecordings::ViewResults : MissingRecordings::Cancel;
}

std::optional<QString> Prompts::sentence(
    QWidget *parent, const QString &title, const QString &label)
{
    if (m_scripted)
        return m_sentences.isEmpty() ? std::nullopt : std::optional(m_sentences.dequeue());
    bool accepted = false;
    const QString text
        = QInputDialog::getText(parent, title, label, QLineEdit::Normal, {}, &accepted).trimmed();
    return accepted && !text.isEmpty() ? std::optional(text) : std::nullopt;
}

void Prompts::dropAnswers()
{
    m_files.clear();
    m_answers.clear();
    m_changedProjects.clear();
    m_missing.clear();
    m_sentences.clear();
}

void Prompts::showProblem(QWidget *parent, const QString &sentence)
{
    m_problems << sentence;
    if (!m_scripted)
        QMessageBox::warning(parent, tr("Dyncal"), sentence);
}

} // namespace dyncal
