// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/dcc/dcc_source.h"

namespace dyncal {

/// dcc:administrativeData of the DCC 3.3.0, without the definitions of refTypes: software, core
/// data, item, laboratory, persons, customer, statements. What nobody has typed has a placeholder,
/// and the statement of a draft names it.
XmlElement dccAdministration(const DccSource &source);

/// This program as dcc:software, with its build.
XmlElement dccSoftware(const DccSource &source);

} // namespace dyncal
