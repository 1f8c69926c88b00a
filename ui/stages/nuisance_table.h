// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/realization/sensor_model.h"
#include "ui/stages/value_table.h"

namespace dyncal {

/// What leaving the nuisance modes out has changed: residual, FIT, f0, zeta and plateau with them
/// left in and left out, then each mode in each shot. Hidden where there is none.
class NuisanceTable : public ValueTable
{
    Q_OBJECT

public:
    explicit NuisanceTable(QWidget *parent = nullptr);

    void showModel(const SensorModel *model); ///< null = no model
};

} // namespace dyncal
