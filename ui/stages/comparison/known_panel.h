// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/session.h"

#include <QObject>

class QLineEdit;

namespace dyncal {

class EntryList;
class InspectorForm;
class OptionalEdit;

/// The controls of recipe key response.known: values that other calibrations state, and the fields
/// that one is added from or replaced by. U is typed as certificates have it, with k = 2.
class KnownPanel : public QObject
{
    Q_OBJECT

public:
    KnownPanel(Session &session, InspectorForm &form, QObject *parent);
    void suggestUnit(); ///< that of S(f), while none is typed

private:
    void buildFields(InspectorForm &form);
    QLineEdit *addLine(
        InspectorForm &form, const QString &label, const char *name, std::string *text);
    void showRecipe(const Recipe &recipe);
    void showEntry(int row);
    void showTyped();
    void allowWhatIsComplete();

    Session &m_session;
    EntryList *m_list;
    QLineEdit *m_label = nullptr;
    QLineEdit *m_certificate = nullptr;
    QLineEdit *m_unit = nullptr;
    OptionalEdit *m_frequency = nullptr;
    OptionalEdit *m_magnitude = nullptr;
    OptionalEdit *m_expanded = nullptr;
    KnownSensitivity m_typed; ///< as the fields have it
};

} // namespace dyncal
