// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/prompts.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>

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
        tr("%1 has changes that are not saved. Save them?").arg(project),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
    if (button == QMessageBox::Save)
        return Answer::Save;
    return button == QMessageBox::Discard ? Answer::Discard : Answer::Cancel;
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

void Prompts::showProblem(QWidget *parent, const QString &sentence)
{
    m_problems << sentence;
    if (!m_scripted)
        QMessageBox::warning(parent, tr("Dyncal"), sentence);
}

} // namespace dyncal
