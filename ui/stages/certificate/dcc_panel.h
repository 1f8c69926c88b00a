// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_finding.h"
#include "core/project/template_choice.h"
#include "ui/session/job_runner.h"
#include "ui/session/session.h"

#include <map>
#include <string>

class QLabel;
class QPushButton;

namespace dyncal {

class InspectorForm;

/// What a reader of the DCC would miss: the draft's DCC, made and held against its rules in the
/// background for the document that the preview draws; with a button to each field that settles
/// something.
class DccPanel : public QObject
{
    Q_OBJECT

public:
    DccPanel(Session &session, InspectorForm &form, QObject *parent);

    void wait(); ///< what is said is of something older
    /// Of the results and the recipe as they are.
    void check(const std::string &createdUtc, const ChosenTemplate &chosen);
    bool isCurrent() const { return m_isCurrent; }

signals:
    void fieldRequested(const std::string &key); ///< of certificate.fields

private:
    void show(const Result<DccCheck> &check);
    void say(const QString &text);

    Session &m_session;
    QLabel *m_note;
    std::map<std::string, QPushButton *> m_buttons; ///< by the field they lead to
    bool m_isCurrent = false;
    JobRunner m_job;
};

} // namespace dyncal
