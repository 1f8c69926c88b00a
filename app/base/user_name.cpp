// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/base/user_name.h"

#include <pwd.h>
#include <unistd.h>

namespace dyncal {

std::string userName()
{
    const passwd *account = ::getpwuid(::getuid());
    return account && account->pw_name && *account->pw_name ? account->pw_name
                                                            : "user " + std::to_string(::getuid());
}

} // namespace dyncal
