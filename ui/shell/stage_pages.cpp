// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/stage_pages.h"

#include "core/project/template_choice.h"
#include "ui/shell/files/file_actions.h"
#include "ui/shell/import/capture_import.h"
#include "ui/stages/captures_page.h"
#include "ui/stages/certificate/certificate_page.h"
#include "ui/stages/checks_page.h"
#include "ui/stages/comparison/comparison_page.h"
#include "ui/stages/components_page.h"
#include "ui/stages/model/model_page.h"
#include "ui/stages/model_input_page.h"
#include "ui/stages/order/order_page.h"
#include "ui/stages/shock/shock_page.h"
#include "ui/stages/spectrum/spectrum_page.h"
#include "ui/stages/uncertainty/uncertainty_page.h"
#include "ui/stages/window/window_page.h"
#include "ui/text/shown_text.h"

#include <QFileInfo>

namespace dyncal {

namespace {

/// Beside the recordings, unless a template's file was chosen before.
void askForTemplate(CertificatePage &page, Prompts &prompts, const Session &session)
{
    const std::string &now = session.recipe().certificate.templateName;
    const auto &inputs = session.state().captures->inputs;
    const std::string beside = isTemplateFile(now) || inputs.empty() ? now : inputs.front().path;
    const QString path = prompts.openFile(&page,
        QCoreApplication::translate("dyncal::CertificatePage", "Template of the certificate"),
        QCoreApplication::translate("dyncal::CertificatePage", "Templates (*.json);;All files (*)"),
        QFileInfo(rawText(beside)).path());
    if (!path.isEmpty())
        page.takeTemplate(path);
}

} // namespace

std::vector<StagePage *> stagePages(
    Session &session, const CurrentUtc &currentUtc, Prompts &prompts, FileActions &files)
{
    auto *captures = new CapturesPage(session, prompts);
    QObject::connect(captures, &CapturesPage::addRequested, &files, &FileActions::addCaptures);
    QObject::connect(
        captures, &CapturesPage::importRequested, &files.captures(), &CaptureImport::edit);
    QObject::connect(
        captures, &CapturesPage::importChanged, &files.captures(), &CaptureImport::change);
    auto *certificate = new CertificatePage(session, currentUtc);
    QObject::connect(
        certificate, &CertificatePage::exportRequested, &files, &FileActions::exportCertificate);
    QObject::connect(certificate, &CertificatePage::templateFileRequested, certificate,
        [certificate, &prompts, &session] { askForTemplate(*certificate, prompts, session); });
    return {captures, new ShockPage(session), new WindowPage(session), new SpectrumPage(session),
        new ComponentsPage(session), new ModelInputPage(session), new OrderPage(session),
        new ModelPage(session), new ChecksPage(session), new UncertaintyPage(session, prompts),
        new ComparisonPage(session, prompts), certificate};
}

} // namespace dyncal
