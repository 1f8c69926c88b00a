// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/stages/certificate/dcc_panel.h"

#include "ui/report/certificate_dcc.h"
#include "ui/stages/certificate/dcc_remarks.h"
#include "ui/stages/certificate/field_labels.h"
#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/status_text.h"
#include "ui/text/core_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/shown_text.h"

#include <QLabel>
#include <QPushButton>

namespace dyncal {

DccPanel::DccPanel(Session &session, InspectorForm &form, QObject *parent)
    : QObject(parent)
    , m_session(session)
    , m_note(nullptr)
    , m_job(this)
{
    form.addSection(tr("What a reader of the DCC would miss"));
    m_note = form.addNote("dccNote");
    m_note->setToolTip(tr(
        "dcc.xml says the same as the certificate, for machines; this is what its rules find missing"));
    for (const char *field : {"laboratory_country", "customer_country"}) {
        auto *button = new WrappedButton(tr("Fill in: %1").arg(fieldLabel(field)));
        button->setObjectName(QString("dccGoTo_%1").arg(field));
        button->setToolTip(tr("To its field of the form"));
        button->hide();
        form.addWide(button);
        connect(button, &QPushButton::clicked, this,
            [this, key = std::string(field)] { emit fieldRequested(key); });
        m_buttons[field] = button;
    }
}

void DccPanel::wait()
{
    m_job.cancel();
    m_isCurrent = false;
    m_note->setEnabled(false);
}

void DccPanel::check(const std::string &createdUtc, const ChosenTemplate &chosen)
{
    wait();
    if (!m_session.results().response) {
        say(tr("There is no DCC yet: it states a frequency response, and none was computed."));
        return;
    }
    m_job.start<DccCheck>(
        [results = m_session.results(), recipe = m_session.recipe(), createdUtc, chosen](
            const JobControl &) { return draftDccCheck(results, recipe, createdUtc, chosen); },
        [this](const Result<DccCheck> &check) { show(check); });
}

void DccPanel::show(const Result<DccCheck> &check)
{
    if (!check) {
        say(translated(check.error().message));
        return;
    }
    QStringList lines;
    std::map<std::string, bool> isAsked;
    for (const DccRemark &remark : dccRemarks(*check)) {
        lines << severityGlyph(Severity::Caution) + ' ' + remark.text;
        isAsked[remark.field] = true;
    }
    say(lines.isEmpty() ? statusGlyph(StageStatus::Done) + ' '
                + tr("Nothing: all rules hold that are known of a DCC.")
                        : lines.join('\n'));
    for (const auto &[field, button] : m_buttons)
        button->setVisible(isAsked[field]);
}

void DccPanel::say(const QString &text)
{
    m_isCurrent = true;
    m_note->setText(text);
    m_note->setEnabled(true);
    for (const auto &[field, button] : m_buttons)
        button->hide();
}

} // namespace dyncal
