// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "registry/store/registry_address.h"

#include <QStandardPaths>
#include <QUrl>

namespace dyncal {
namespace {

std::string fileOfUser()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation).toStdString()
        + "/dyncal/registry.sqlite";
}

bool isServerUrl(const QUrl &url)
{
    return (url.scheme() == "postgresql" || url.scheme() == "postgres") && !url.host().isEmpty()
        && url.path().size() > 1;
}

} // namespace

std::string RegistryAddress::shown() const
{
    if (!isServer())
        return file;
    return "postgresql://" + host + (port < 0 ? "" : ':' + std::to_string(port)) + '/' + database;
}

Result<RegistryAddress> registryAddress(const std::string &text)
{
    RegistryAddress address;
    if (text.find("://") == std::string::npos) {
        address.file = text.empty() ? fileOfUser() : text;
        return address;
    }
    const QUrl url(QString::fromStdString(text));
    if (!isServerUrl(url))
        return fail(ErrorKind::Usage,
            {DYNCAL_TEXT("core",
                 "%1 is no registry; name a file, or a database as postgresql://USER@HOST:PORT/DATABASE."),
                {url.toString(QUrl::RemovePassword).toStdString()}});
    address.host = url.host().toStdString();
    address.user = url.userName(QUrl::FullyDecoded).toStdString();
    address.password = url.password(QUrl::FullyDecoded).toStdString();
    address.database = url.path(QUrl::FullyDecoded).mid(1).toStdString();
    address.port = url.port();
    return address;
}

} // namespace dyncal
