// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringDecoder>

#include <string>

namespace dyncal::testing {

/// What is wrong with the diagnostics of a run with this exit code; empty if nothing is.
inline QString faultOfStderr(const std::string &err, int exitCode)
{
    constexpr int kBlocked = 2;
    static const QRegularExpression bareNumber(
        R"((?<![\w/.\\-])[+-]?(nan|inf)(?![\w/.]))", QRegularExpression::CaseInsensitiveOption);
    const QByteArray bytes = QByteArray::fromStdString(err);
    if (exitCode >= kBlocked && bytes.trimmed().isEmpty())
        return "says nothing";
    QStringDecoder decoder(QStringDecoder::Utf8);
    const QString text = decoder(bytes);
    if (decoder.hasError())
        return "is no UTF-8";
    for (const QChar c : text) {
        if (c.category() == QChar::Other_Control && c != '\n')
            return QString("holds the control character %1").arg(c.unicode());
    }
    if (exitCode >= kBlocked && !text.trimmed().endsWith('.'))
        return "does not end in a sentence: " + text.trimmed().right(80);
    const QRegularExpressionMatch bare = bareNumber.match(text);
    return bare.hasMatch() ? "says " + bare.captured() + ": " + text.left(200) : QString();
}

} // namespace dyncal::testing
