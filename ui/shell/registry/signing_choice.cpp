// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/shell/registry/signing_choice.h"

#include "core/signing/http_post.h"
#include "core/signing/key_token.h"
#include "core/signing/seal_command.h"
#include "ui/text/core_text.h"
#include "ui/text/shown_text.h"

#include <QFileInfo>

#include <algorithm>
#include <array>

namespace dyncal {

namespace {

constexpr std::array<const char *, 4> kWays{"unsigned", "key-file", "token", "service"};

template <typename Value>
QStringList sentenceOf(const Result<Value> &fit)
{
    return fit ? QStringList() : QStringList(translated(fit.error().message));
}

QStringList obstaclesOfFile(const QString &path)
{
    if (path.isEmpty())
        return {SigningChoice::tr("Name the file of the key that signs.")};
    if (!QFileInfo(path).isFile())
        return {SigningChoice::tr("There is no key file %1; choose another.").arg(shownText(path))};
    return {};
}

QStringList obstaclesOfToken(const QString &uri)
{
    if (!isTokenUri(uri.toStdString()))
        return {SigningChoice::tr(
            "Name the key of the token that signs, as pkcs11:token=NAME;object=LABEL.")};
    return sentenceOf(checkTokenUri(uri.toStdString()));
}

QStringList obstaclesOfService(const QString &command)
{
    if (command.isEmpty())
        return {SigningChoice::tr("Name the command of the service that signs.")};
    return sentenceOf(wordsOfCommand(command.toStdString()));
}

} // namespace

QStringList SigningChoice::obstacles() const
{
    QStringList found;
    switch (way) {
    case SigningWay::Unsigned:
        return {};
    case SigningWay::KeyFile:
        found = obstaclesOfFile(keyFile);
        break;
    case SigningWay::Token:
        found = obstaclesOfToken(token);
        break;
    case SigningWay::Service:
        found = obstaclesOfService(service);
        break;
    }
    return authority.isEmpty() ? found
                               : found + sentenceOf(checkHttpAddress(authority.toStdString()));
}

QStringList SigningChoice::words(bool isSecretGiven) const
{
    QStringList words;
    switch (way) {
    case SigningWay::Unsigned:
        return {"--unsigned"};
    case SigningWay::KeyFile:
        words << "--key=" + keyFile;
        break;
    case SigningWay::Token:
        words << "--key=" + token;
        break;
    case SigningWay::Service:
        words << "--seal-command=" + service;
        break;
    }
    if (isSecretGiven)
        words << "--pin-fd=0";
    if (!authority.isEmpty())
        words << "--tsa=" + authority;
    return words;
}

QString signingWayName(SigningWay way)
{
    return QLatin1String(kWays.at(static_cast<std::size_t>(way)));
}

SigningWay signingWayOf(const QString &name)
{
    const auto *const known
        = std::ranges::find_if(kWays, [&](const char *one) { return name == QLatin1String(one); });
    return known == kWays.end() ? SigningWay::Unsigned
                                : static_cast<SigningWay>(known - kWays.begin());
}

} // namespace dyncal
