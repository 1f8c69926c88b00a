// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/made_keys.h"
#include "tests/system/issued_job.h"

/// Rows of `dyncal verify --json` in the order of the files, with what is trusted.
inline QJsonArray verifyRows(
    const QStringList &files, const QString &trusted, const QStringList &more = {})
{
    return QJsonDocument::fromJson(
        runDyncal(QStringList{"verify"} + files + QStringList{"--trust", trusted, "--json"} + more)
            .out)
        .array();
}

/// A DCC without its XML signature.
inline QByteArray withoutXmlSignature(QByteArray xml)
{
    const QByteArray last = "</ds:Signature>";
    const qsizetype begin = xml.indexOf("<ds:Signature");
    const qsizetype end = xml.indexOf(last);
    return begin < 0 || end < begin ? xml : xml.remove(begin, end + last.size() - begin);
}

/// A PDF before its incremental update: what it was when it was signed.
inline QByteArray firstRevision(const QByteArray &pdf)
{
    const QByteArray mark = "%%EOF\n";
    return pdf.left(pdf.indexOf(mark) + mark.size());
}
