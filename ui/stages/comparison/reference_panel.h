// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QObject>

#include <optional>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QPushButton;

namespace dyncal {

class InspectorForm;
class NeededNumbers;
class OptionalEdit;

/// The controls of recipe section "comparison" besides the file: whether it is compared, what S(f)
/// is stated against, the channel, its unit, the model instead of a file, delay and correlation.
class ReferencePanel : public QObject
{
    Q_OBJECT

public:
    ReferencePanel(Session &session, InspectorForm &form, QObject *parent);

    void buildUse(); ///< above the file
    void buildModel(); ///< below it
    void buildMounting();

private:
    void setEnabled(bool on);
    void setAgainst(int choice);
    void showChannels(const Recipe &recipe);
    void setUnit();
    void showUnit(const Recipe &recipe);
    void takeModel(const std::vector<double> &values, QWidget *field);
    void showModel(const Recipe &recipe);
    void showUse(const Recipe &recipe);
    /// Why it cannot be switched on; empty where nothing is in the way.
    QString obstacle() const;

    Session &m_session;
    InspectorForm &m_form;
    QCheckBox *m_enabled = nullptr;
    QComboBox *m_against = nullptr;
    QComboBox *m_channel = nullptr;
    QLineEdit *m_unit = nullptr;
    NeededNumbers *m_model = nullptr;
    OptionalEdit *m_sensitivity = nullptr;
    OptionalEdit *m_u_sensitivity = nullptr;
    QPushButton *m_dropModel = nullptr;
};

} // namespace dyncal
