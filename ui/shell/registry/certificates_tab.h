// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/base/index.h"

#include <QJsonArray>
#include <QWidget>

class QPushButton;

namespace dyncal {

class Prompts;
class RegistryCaller;
class RowsView;

/// Every number of the registry and what has become of it; certificates are withdrawn and reserved
/// numbers given up here, each with a reason.
class CertificatesTab : public QWidget
{
    Q_OBJECT

public:
    CertificatesTab(RegistryCaller &caller, Prompts &prompts, QWidget *parent);

    void refresh();
    void showWords();

signals:
    void changed(const QString &sentence); ///< the registry is another, as the sentence says

private:
    QString selectedState() const; ///< "" where none is selected
    void showButtons();
    void withdraw();
    void giveUp();
    void changeWithReason(const QStringList &command, const QString &title, const QString &done);

    RegistryCaller &m_caller;
    Prompts &m_prompts;
    QJsonArray m_records;
    RowsView *m_table;
    QPushButton *m_withdraw;
    QPushButton *m_giveUp;
};

} // namespace dyncal
