// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/support/python_answer.h"
#include "tests/system/dyncal_process.h"

#include <QDir>
#include <QJsonArray>

// Judges of a folder's dcc.xml: xmllint with the schemas where they are, the program's own rules,
// and a script of its own that looks for the numbers of PDF and results.json.

inline QString sourcePath(const QString &name)
{
    return qEnvironmentVariable("DYNCAL_SOURCE_DIR") + name;
}

inline QString schemas()
{
    const QDir folder(sourcePath("/../shared/dcc"));
    return folder.exists("catalog.xml") ? folder.absolutePath() : QString();
}

/// "" where the folder's DCC is valid by xmllint and by the program; no network for either.
inline QByteArray faultsOf(const QString &folder)
{
    const QString file = folder + "/dcc.xml";
    if (!schemas().isEmpty()) {
        const auto lint = dyncal::testing::answerOf("/usr/bin/env",
            {"XML_CATALOG_FILES=" + schemas() + "/catalog.xml", "xmllint", "--nonet", "--noout",
                "--schema", "https://ptb.de/dcc/v3.3.0/dcc.xsd", file});
        if (!lint.ran)
            return lint.out + lint.err;
    }
    QStringList check{"dcc", "check", file, "--json"};
    if (!schemas().isEmpty())
        check << "--schemas" << schemas();
    const Answer own = runDyncal(check);
    for (const QJsonValue finding : QJsonDocument::fromJson(own.out)["findings"].toArray())
        if (finding["rule"] != "country") // nobody has typed one
            return own.out + own.err;
    return own.exitCode == 0 || own.exitCode == 2 ? QByteArray() : own.out + own.err;
}

/// "" where every number is there.
inline QByteArray missingNumbers(const QString &folder, const QString &language)
{
    const dyncal::testing::PythonAnswer answer
        = dyncal::testing::python({sourcePath("/tests/audit/dcc_numbers.py"), folder, language});
    return answer.ran ? QByteArray() : answer.out + answer.err;
}
