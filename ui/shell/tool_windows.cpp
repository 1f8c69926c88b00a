// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/tool_windows.h"

#include "ui/shell/files/file_actions.h"
#include "ui/shell/preferences/language.h"
#include "ui/shell/registry/issue_dialog.h"
#include "ui/shell/registry/registry_window.h"
#include "ui/shell/selftest_dialog.h"

namespace dyncal {

namespace {

void bringToFront(QWidget &window)
{
    window.show();
    window.raise();
    window.activateWindow();
}

} // namespace

ToolWindows::ToolWindows(Parts parts, QWidget *window)
    : QObject(window)
    , m_parts(std::move(parts))
    , m_window(window)
{
}

ToolWindows::~ToolWindows()
{
    delete m_correction;
    delete m_registry;
}

void ToolWindows::testInstallation()
{
    auto *dialog = new SelfTestDialog(m_parts.currentUtc, m_parts.prompts, m_parts.preferences,
        m_parts.language.code(), m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
    dialog->start();
}

void ToolWindows::correctRecording()
{
    if (!m_correction)
        m_correction = new CorrectionWindow(
            m_parts.session, m_parts.currentUtc, m_parts.prompts, m_parts.preferences, m_window);
    bringToFront(*m_correction);
}

void ToolWindows::showRegistry()
{
    if (!m_registry) {
        m_registry = new RegistryWindow(m_parts.prompts, m_parts.preferences, m_window);
        connect(m_registry, &RegistryWindow::plotExport, &m_parts.files, &FileActions::exportPlot);
    }
    bringToFront(*m_registry);
}

void ToolWindows::issueCertificate()
{
    auto *dialog = new IssueDialog(m_parts.session, m_parts.currentUtc, m_parts.files,
        m_parts.prompts, m_parts.preferences, m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
    dialog->lookUp();
}

} // namespace dyncal
