// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/base/writing/stray_cleaning.h"

#include "core/base/writing/file_identity.h"
#include "core/base/writing/write_problem.h"

#include <unistd.h>

namespace dyncal {

Result<void> clearStray(int folder, const ClaimText &claim, const NameRule &mayWrite)
{
    const auto identity = identityOf(folder, claim.temporary);
    if (!identity)
        return {};
    if (claim.kind == ClaimKind::Folder && identity->type == FileType::Folder)
        return recoverFolder(folder, claim.temporary, claim.target, mayWrite);
    const bool isOurs = claim.kind == ClaimKind::File && identity->type == FileType::Regular;
    if (isOurs && ::unlinkat(folder, claim.temporary.c_str(), 0) != 0)
        return cannotWrite(claim.temporary);
    return {}; // anything else was put there by somebody else
}

} // namespace dyncal
