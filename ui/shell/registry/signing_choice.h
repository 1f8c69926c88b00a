// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QCoreApplication>
#include <QStringList>

namespace dyncal {

enum class SigningWay { Unsigned, KeyFile, Token, Service };

/// Who signs a certificate that is issued from the window: what `dyncal issue` is told of it. The
/// passphrase or PIN is no part of it.
struct SigningChoice
{
    Q_DECLARE_TR_FUNCTIONS(dyncal::SigningChoice)

public:
    SigningWay way = SigningWay::Unsigned;
    QString keyFile = {}; ///< PKCS#12 or PEM
    QString token = {}; ///< pkcs11:URI
    QString service = {}; ///< command
    QString authority = {}; ///< http://..., of time stamps; empty: none

    bool isSigned() const { return way != SigningWay::Unsigned; }
    /// Whether a passphrase or PIN may be needed.
    bool hasSecret() const { return way == SigningWay::KeyFile || way == SigningWay::Token; }

    /// What keeps the way from being gone, a sentence each, in the language of the window.
    QStringList obstacles() const;

    /// Options of `dyncal issue`; `isSecretGiven`: its standard input holds the secret.
    QStringList words(bool isSecretGiven) const;
};

/// "unsigned", "key-file", "token", "service": as it is remembered.
QString signingWayName(SigningWay way);
/// Unsigned for what is none.
SigningWay signingWayOf(const QString &name);

} // namespace dyncal
