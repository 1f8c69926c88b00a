// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/project/recipe_sections.h"
#include "ui/stages/frame/wrapped_controls.h"

#include <QLabel>
#include <QWidget>

#include <functional>
#include <vector>

class QComboBox;
class QFormLayout;

namespace dyncal {

/// The inspector of a stage: sections of labelled controls and read-outs. Every control gets an
/// object name (tests, scripts) and an accessible name (screen readers).
class InspectorForm : public QWidget
{
    Q_OBJECT

public:
    explicit InspectorForm(QWidget *parent = nullptr);

    void addSection(const QString &title);

    template <typename Control>
    Control *add(const QString &label, const QString &objectName, Control *control)
    {
        name(control, label, objectName);
        addRow(label, control);
        return control;
    }
    /// A choice among words; the item data are the positions.
    QComboBox *addChoice(
        const QString &label, const QString &objectName, const QStringList &choices);
    /// A value that can only be read (and selected, to be copied).
    QLabel *addReadout(const QString &label, const QString &objectName);
    /// A sentence over the full width.
    QLabel *addNote(const QString &objectName);
    /// A control that says by itself what it is (a button, a check box).
    void addWide(QWidget *control);
    /// For a control that only its own key needs: `show` sets it from each recipe.
    void follow(std::function<void(const Recipe &)> show);
    void showRecipe(const Recipe &recipe); ///< to all that follow it
    /// Pale read-outs are out of date.
    void setReadoutsEnabled(bool enabled);

private:
    template <typename Control>
    static void name(Control *control, const QString &label, const QString &objectName)
    {
        if constexpr (requires { control->setNames(objectName, label); }) {
            control->setNames(objectName, label);
        } else {
            control->setObjectName(objectName);
            control->setAccessibleName(label);
        }
    }
    void addRow(const QString &label, QWidget *control);
    QFormLayout *m_layout;
    std::vector<QLabel *> m_readouts;
    std::vector<std::function<void(const Recipe &)>> m_followers;
};

} // namespace dyncal
