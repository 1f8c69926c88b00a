// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/realization/order/order_evidence.h"

namespace dyncal {

const char *poleStabilityName(PoleStability stability)
{
    switch (stability) {
    case PoleStability::New:
        return "new";
    case PoleStability::Frequency:
        return "frequency";
    case PoleStability::FrequencyAndDamping:
        return "frequency-and-damping";
    case PoleStability::Unstable:
        break;
    }
    return "unstable";
}

} // namespace dyncal
