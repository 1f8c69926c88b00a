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

/// Where the cross-reference table ("xref", its number of entries, entries of 20 bytes) begins.
const QByteArray kTable = QByteArrayLiteral("\nxref\n");

/// Removes `count` bytes at `at`, and corrects the offsets in the table and the stated place of the
/// table. False if there is no table.
bool cutOut(QByteArray &pdf, qsizetype at, qsizetype count)
{
    constexpr qsizetype kEntry = 20, kDigits = 10;
    const auto moved = [&](qint64 offset) { return offset > at ? offset - count : offset; };
    const qsizetype table = pdf.lastIndexOf(kTable);
    const qsizetype begin = table < 0 ? -1 : pdf.indexOf('\n', table + kTable.size()) + 1;
    const qsizetype end = pdf.indexOf("trailer", begin);
    if (begin <= 0 || end < 0)
        return false;
    for (qsizetype entry = begin; entry + kEntry <= end; entry += kEntry) {
        const qint64 offset = pdf.mid(entry, kDigits).toLongLong();
        pdf.replace(entry, kDigits, QByteArray::number(moved(offset)).rightJustified(kDigits, '0'));
    }
    const QByteArray mark = QByteArrayLiteral("startxref\n");
    const qsizetype stated = pdf.indexOf(mark, end) + mark.size();
    qsizetype length = 0; // of the digits: what Qt writes behind them stays
    while (
        stated + length < pdf.size() && pdf[stated + length] >= '0' && pdf[stated + length] <= '9')
        ++length;
    const qint64 offset = pdf.mid(stated, length).toLongLong();
    pdf.replace(stated, length, QByteArray::number(moved(offset)));
    pdf.remove(at, count);
    return true;
}

/// Qt writes its dates in local time: "D:20260101120000+02'00'" becomes "D:20260101120000Z".
void writeUtc(QByteArray &pdf)
{
    static const QRegularExpression zone(
        QStringLiteral("Date \\(D:\\d{14}([-+]\\d\\d'\\d\\d')\\)"));
    for (;;) {
        const QRegularExpressionMatch match = zone.match(QString::fromLatin1(pdf));
        if (!match.hasMatch())
            return;
        const qsizetype at = match.capturedStart(1);
        if (!cutOut(pdf, at + 1, match.capturedLength(1) - 1))
            return;
        pdf[at] = 'Z';
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
    writeUtc(pdf);
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
