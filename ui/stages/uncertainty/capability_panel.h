// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QObject>

class QComboBox;

namespace dyncal {

class EntryList;
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
    void buildFields(InspectorForm &form);
    void showRecipe(const Recipe &recipe);
    void showEntry(); ///< the selected one in the fields
    void useUnit(); ///< that of the quantity and of how it is counted
    void allowWhatIsComplete();
    CapabilityEntry typed() const;
    std::size_t selected() const { return static_cast<std::size_t>(row()); }
    int row() const;

    Session &m_session;
    EntryList *m_list;
    QComboBox *m_of;
    QComboBox *m_counted;
    OptionalEdit *m_expanded;
    OptionalEdit *m_from;
    OptionalEdit *m_to;
    CapabilityEntry m_typed; ///< as the fields have it
};

} // namespace dyncal
