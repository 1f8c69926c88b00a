// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/hostile_text.h"
#include "tests/system/dyncal_process.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

/// What answers and files may hold when hostile text went into them.
namespace dyncal::test {

/// Nothing in the answer acts on a terminal, and the program ended by itself.
inline void judge(const Answer &answer, const std::string &text)
{
    const QByteArray about = answer.out.left(2000) + "|" + answer.err.left(2000) + "|"
        + QByteArray::fromStdString(text).toHex().left(200);
    QVERIFY2(answer.exitCode >= 0, about);
    QVERIFY2(isFitToShow(answer.out.toStdString(), LineBreaks::Keep), about.toHex());
    QVERIFY2(isFitToShow(answer.err.toStdString(), LineBreaks::Keep), about.toHex());
    QVERIFY2(!answer.err.contains("\nDone.\n") && !answer.out.contains("\nDone.\n"), about);
}

/// The text as a person reads it; pages need pdftotext.
inline QByteArray readableBytes(const QString &file)
{
    if (!file.endsWith(".pdf"))
        return bytesOf(file);
    QProcess toText;
    toText.start("pdftotext", {"-layout", file, "-"});
    if (!toText.waitForFinished(60000))
        return {};
    return toText.readAllStandardOutput().replace('\f', "");
}

/// A file that a run wrote.
inline void judgeFile(const QString &file, const std::string &text)
{
    const QByteArray about = file.toUtf8() + " " + QByteArray::fromStdString(text).left(60);
    if (file.endsWith(".mat")) // binary, and holds numbers alone
        return;
    const QByteArray bytes = readableBytes(file);
    QVERIFY2(!file.endsWith(".pdf") || !bytes.isEmpty(), about);
    QVERIFY2(isFitToShow(bytes.toStdString(), LineBreaks::Keep), about);
    if (file.endsWith(".json"))
        QVERIFY2(!QJsonDocument::fromJson(bytes).isNull(), about);
    if (file.endsWith(".svg")) {
        QXmlStreamReader xml(bytes);
        while (!xml.atEnd()) {
            xml.readNext();
            for (const char *foreign : {"script", "img", "b", "a", "table", "h1"})
                QVERIFY2(!xml.isStartElement() || xml.name() != QLatin1String(foreign), about);
        }
        QVERIFY2(!xml.hasError(), about);
    }
    if (file.endsWith(".csv"))
        for (const QByteArray &line : bytes.split('\n'))
            for (const QByteArray &cell : line.split(','))
                QVERIFY2(cell.isEmpty() || !QByteArray("=@").contains(cell.front()), about);
}

/// No number in it is nan or infinite.
inline void judgeNumbers(const QByteArray &shown)
{
    static const QRegularExpression word(
        "(?<![\\w.%])[-+]?(nan|inf|infinity)(?![\\w])", QRegularExpression::CaseInsensitiveOption);
    const QRegularExpressionMatch match = word.match(QString::fromUtf8(shown));
    QVERIFY2(!match.hasMatch(), (match.captured().toUtf8() + " in " + shown.left(3000)));
}

} // namespace dyncal::test
