// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QString>
#include <QVariantList>

#include <vector>

namespace dyncal {

/// What commands on the registry print as JSON, as rows of a table. Texts of the registry are fit
/// to show.

/// A list; empty where it is none.
QJsonArray listOf(const QByteArray &json);

/// `dyncal registry list`: number, state, sensor, customer, issued, by, reviewed by, amends,
/// replaced by, reason.
std::vector<QVariantList> certificateRows(const QJsonArray &records);

/// `dyncal registry trail`: number of the entry, time, who, action, object, reason.
std::vector<QVariantList> trailRows(const QJsonArray &entries);

/// `dyncal verify`: file, kind, status, number, state, signer, signed and stamped at, the first
/// difference or remarks.
std::vector<QVariantList> verifiedRows(const QJsonArray &verified);

/// How many of them are valid; changed, missing or unreadable; and neither: not signed, of an
/// unknown signer, expired.
struct VerifiedCounts
{
    int valid = 0;
    int bad = 0;
    int doubtful = 0;
};
VerifiedCounts countsOf(const QJsonArray &verified);

/// "issued", "replaced", ... in the language of the window.
QString certificateStateText(const QString &state);

/// Whether the laboratory stands by a certificate of this state: issued, or as an amendment.
bool isInForce(const QString &state);

/// "2026-01-31 12:00:00" for a time of the registry (UTC); "" for none.
QString timeText(const QString &utc);

} // namespace dyncal
