// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/gas_model.h"

#include <QObject>

#include <optional>

class QComboBox;

namespace dyncal {

class InspectorForm;
class QuantityEdit;

/// The controls of one gas in an inspector: which gas it is, and its constants. These can be typed
/// for a custom gas; for other gases they are read-outs of the values used, with their source.
class GasEdit : public QObject
{
    Q_OBJECT

public:
    /// `name` begins the object names: "driven" -> "drivenGas", "drivenGamma", "drivenMolarMass".
    GasEdit(InspectorForm &form, const QString &label, const QString &name, QObject *parent);

    /// `used` is the gas of the last run.
    void set(const GasSettings &settings, const std::optional<GasModel> &used);

signals:
    void edited(const dyncal::GasSettings &settings);

private:
    void choose(int choice);

    GasSettings m_settings;
    QComboBox *m_substance;
    QuantityEdit *m_gamma;
    QuantityEdit *m_molarMass;
};

} // namespace dyncal
