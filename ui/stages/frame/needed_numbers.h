// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/stages/frame/inspector_form.h"
#include "ui/stages/frame/optional_edit.h"

#include <QObject>

#include <optional>
#include <vector>

namespace dyncal {

/// Numbers of which a recipe holds all or none. What is typed is kept here until the last of them
/// is there; a note says which ones are still needed.
class NeededNumbers : public QObject
{
    Q_OBJECT

public:
    NeededNumbers(InspectorForm &form, QObject *parent);

    /// The numbers stand in the order in which they are added.
    OptionalEdit *add(const QString &label, const QString &objectName, OptionalEdit *edit);
    void addNote(const QString &objectName); ///< behind the last of them
    /// What the recipe holds. With nothing in it, what was typed stays, unless the recipe held all
    /// before: then they are gone.
    void show(const std::optional<std::vector<double>> &known);
    void forget(); ///< what was typed and is in no recipe
    std::size_t typed() const; ///< how many are there

signals:
    void completed(const std::vector<double> &values, QWidget *field); ///< the last one typed

private:
    void take(std::size_t at, const std::optional<double> &value);
    void showAll();

    struct Number
    {
        QString label;
        OptionalEdit *edit = nullptr;
        std::optional<double> value = {};
    };
    InspectorForm &m_form;
    std::vector<Number> m_numbers;
    QLabel *m_note = nullptr;
    bool m_isKnown = false;
};

} // namespace dyncal
