// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/pipeline/pipeline.h"
#include "ui/stages/frame/inspector_form.h"

#include <QHash>
#include <QObject>

#include <functional>

class QLineEdit;
class QPushButton;

namespace dyncal {

class AutoEdit;
class QuantityEdit;

/// The inspector of the order page: the order and why, what it gives, how it is adopted, and the
/// settings of decomposition and strip.
class OrderInspector : public QObject
{
    Q_OBJECT

public:
    /// `change` applies an edit of the recipe as one undo step with a label.
    using Change
        = std::function<void(const QString &label, const std::function<void(Recipe &)> &edit)>;

    OrderInspector(InspectorForm &form, Change change, QObject *parent);

    void showRecipe(const Recipe &recipe, const CalibrationResults &results, Index order);
    /// `isAdopted`: the model on show is the one adopted.
    void showResults(const CalibrationResults &results, bool isCurrent, bool isAdopted);
    void adopt(); ///< with the reason typed, or the one proposed; nothing where it is not allowed
    void useSuggestion();
    void typeOrder(); ///< moves the focus to the field of the order

signals:
    void orderChosen(double order);
    void adopted(const QString &reason);

private:
    void buildOrder(InspectorForm &form);
    void buildModel(InspectorForm &form);
    void buildAdoption(InspectorForm &form);
    void buildSettings(InspectorForm &form);
    void showModel(const CalibrationResults &results, const SensorModel *model);
    void showAdoption(const CalibrationResults &results, bool isCurrent, bool isAdopted);

    Change m_change;
    Index m_suggested = 0;
    bool m_mayAdopt = false;
    QHash<Index, QString> m_remarks; ///< by order
    AutoEdit *m_order;
    QLabel *m_suggestion;
    QPushButton *m_useSuggestion;
    QLabel *m_of;
    QLabel *m_score;
    QLabel *m_gap;
    QLabel *m_resonance;
    QLabel *m_spread;
    QLabel *m_outside;
    QLabel *m_proposed; ///< the reason given where none is typed
    QLineEdit *m_reason;
    QPushButton *m_adopt;
    QLabel *m_adoption;
    QLabel *m_why;
    QuantityEdit *m_largest;
    AutoEdit *m_rows;
};

/// Why a model cannot be adopted: its blocking finding (MOD-001); empty where it can.
QString obstacleToAdopting(const SensorModel &model);

} // namespace dyncal
