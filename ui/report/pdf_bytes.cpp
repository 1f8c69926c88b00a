// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/report/pdf_bytes.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QRegularExpression>

namespace dyncal {

namespace {

/// Replaces every match of `field` (Latin-1 text, one capture group) by text of the same length.
void replaceFields(QByteArray &pdf, const QString &field, const QByteArray &text)
{
    const QRegularExpression pattern(field);
    const QString readable = QString::fromLatin1(pdf); // one character per byte
    auto matches = pattern.globalMatch(readable);
    while (matches.hasNext()) {
        const QRegularExpressionMatch match = matches.next();
        if (match.capturedLength(1) == text.size())
            pdf.replace(match.capturedStart(1), text.size(), text);
    }
}

} // namespace

QByteArray withFixedDates(QByteArray pdf, const QString &createdUtc)
{
    QDateTime when = QDateTime::fromString(createdUtc, Qt::ISODate);
    if (!when.isValid())
        when = QDateTime::fromSecsSinceEpoch(0, Qt::UTC);
    const QString compact = when.toUTC().toString(QStringLiteral("yyyyMMddhhmmss"));
    const QString iso = when.toUTC().toString(QStringLiteral("yyyy-MM-ddThh:mm:ssZ"));
    replaceFields(pdf, QStringLiteral("Date \\((D:\\d{14})"), "D:" + compact.toLatin1());
    replaceFields(pdf, QStringLiteral("D:\\d{14}([^)]*)\\)"), "Z");
    replaceFields(pdf, QStringLiteral("Date>([-0-9T:]{19}Z)<"), iso.toLatin1());

    const QString idField = QStringLiteral("/ID \\[ <([0-9a-fA-F]{32})>");
    const QString secondIdField = QStringLiteral("/ID \\[ <[0-9a-fA-F]{32}> <([0-9a-fA-F]{32})>");
    for (const QString &field : {idField, secondIdField})
        replaceFields(pdf, field, QByteArray(32, '0'));
    const QByteArray id
        = QCryptographicHash::hash(pdf, QCryptographicHash::Sha256).left(16).toHex();
    for (const QString &field : {idField, secondIdField})
        replaceFields(pdf, field, id);
    return pdf;
}

} // namespace dyncal
