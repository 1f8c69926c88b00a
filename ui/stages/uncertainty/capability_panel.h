// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QObject>

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace dyncal {

class InspectorForm;
class OptionalEdit;

/// The controls of recipe key uncertainty.cmc: the entries, and the fields that one is added from
/// or replaced by.
class CapabilityPanel : public QObject
{
    Q_OBJECT

public:
    CapabilityPanel(Session &session, InspectorForm &form, QObject *parent);

private:
    void buildList(InspectorForm &form);
    void buildFields(InspectorForm &form);
    QPushButton *addButton(InspectorForm &form, const QString &text, const char *name);
    void showRecipe(const Recipe &recipe);
    void showEntry(); ///< the selected one in the fields
    void useUnit(); ///< that of the quantity and of how it is counted
    void allowWhatIsComplete();
    void add();
    void replace();
    void remove();
    bool change(QWidget *field, const QString &label,
        const std::function<void(std::vector<CapabilityEntry> &)> &edit);
    CapabilityEntry typed() const;
    std::size_t selected() const { return static_cast<std::size_t>(selectedRow()); }
    int selectedRow() const;

    Session &m_session;
    QListWidget *m_list;
    QComboBox *m_of;
    QComboBox *m_counted;
    OptionalEdit *m_expanded;
    OptionalEdit *m_from;
    OptionalEdit *m_to;
    QPushButton *m_add;
    QPushButton *m_replace;
    QPushButton *m_remove;
    CapabilityEntry m_typed; ///< as the fields have it
};

} // namespace dyncal
