// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/shock/shock_relations.h"

namespace dyncal {

/// What a laboratory would have written down about the simulated tube and day, unless a defect
/// has it written down wrongly.
struct RecordedConditions
{
    static constexpr double driverLength_m = 0.97; ///< thesis, appendix A
    static constexpr double drivenLength_m = 0.97;
    static constexpr double innerDiameter_m = 0.10;
    static constexpr double distance_m = 0.80; ///< side sensor to end wall
    static constexpr double u_distance_m = 0.2e-3;
    static constexpr double p1_Pa = 101100.0; ///< thesis, table 4.1
    static constexpr double u_p1_Pa = 30.0;
    static constexpr double T1_K = 294.15;
    static constexpr double u_T1_K = 0.3;
    static constexpr double T4_K = 295.35;
    static constexpr Gas gas{}; ///< in both sections
};

} // namespace dyncal
