// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/page_standing.h"

namespace dyncal {

class Session;

/// How the work of a session stands at the moment.
WorkState workStateOf(const Session &session);

} // namespace dyncal
