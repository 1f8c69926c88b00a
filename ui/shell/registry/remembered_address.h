// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QString>
#include <QUrl>

namespace dyncal {

/// The address of a registry without the password of its server: passwords are not kept.
inline QString withoutPassword(const QString &address)
{
    if (!address.contains(QLatin1String("://")))
        return address;
    QUrl url(address);
    url.setPassword({});
    return url.toString();
}

} // namespace dyncal
