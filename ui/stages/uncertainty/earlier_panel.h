// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/history/earlier_response.h"
#include "ui/session/job_runner.h"

#include <QObject>

#include <optional>

class QLabel;
class QPushButton;

namespace dyncal {

class InspectorForm;
class Prompts;
class Session;

/// An earlier result that is laid over the present S(f): chosen here, and how the two agree. It is
/// only looked at: neither recipe nor results know of it.
class EarlierPanel : public QObject
{
    Q_OBJECT

public:
    EarlierPanel(Session &session, Prompts &prompts, InspectorForm &form, QObject *parent);

    const std::optional<EarlierResponse> &earlier() const { return m_earlier; }
    QString name() const; ///< "Sensor 17, 2025-03-01"
    /// Says how it agrees with these rows, which are in `unit`; what differs from it in a prefix
    /// only is converted.
    void compareWith(const std::vector<ResponseRow> &present, const std::string &unit);

signals:
    void changed();

private:
    void askForFile();
    void take(Result<EarlierResponse> read);
    void setEarlier(std::optional<EarlierResponse> earlier, const QString &sentence);
    QString notAssigned() const; ///< what of a certificate was not understood, line by line

    Session &m_session;
    Prompts &m_prompts;
    std::optional<EarlierResponse> m_earlier;
    QPushButton *m_choose;
    QPushButton *m_remove;
    QLabel *m_note;
    JobRunner m_job; ///< last: it stops before what its delivery uses is destroyed
};

} // namespace dyncal
