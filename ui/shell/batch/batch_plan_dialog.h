// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/batch/batch_planning.h"

#include <QDialog>

class QCheckBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace dyncal {

class Preferences;
class Prompts;

/// What a plan is made of: the folder of the recordings, recipe, profile and the file of the plan.
class BatchPlanDialog : public QDialog
{
    Q_OBJECT

public:
    BatchPlanDialog(Prompts &prompts, Preferences &preferences, QWidget *parent);

    BatchRequest request() const;

private:
    QLineEdit *addPath(QFormLayout &form, const QString &name, const QString &label,
        const QString &hint, const std::function<QString()> &ask);
    void addPaths(QFormLayout &form);
    QString askForJson(const QString &title);
    void showReadiness();

    Prompts &m_prompts;
    Preferences &m_preferences;
    QLineEdit *m_root = nullptr;
    QLineEdit *m_recipe = nullptr;
    QLineEdit *m_profile = nullptr;
    QLineEdit *m_plan = nullptr;
    QCheckBox *m_eachFile;
    QPushButton *m_accept;
};

} // namespace dyncal
