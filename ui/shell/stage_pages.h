// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "ui/session/current_utc.h"

#include <vector>

namespace dyncal {

class FileActions;
class Prompts;
class Session;
class StagePage;

/// The pages in their order, without a parent; what they ask for is done by `files`.
std::vector<StagePage *> stagePages(
    Session &session, const CurrentUtc &currentUtc, Prompts &prompts, FileActions &files);

} // namespace dyncal
