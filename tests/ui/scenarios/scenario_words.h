// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "core/certificate/certificate.h"
#include "tests/ui/scenarios/scenario_bench.h"

namespace dyncal::test {

/// Every sentence of the certificate as it would be printed now.
inline QString certificateText(const ScenarioBench &bench)
{
    QString text;
    for (const CertificateSection &section :
        makeCertificate(bench.session().results(), bench.recipe(), {}).sections) {
        for (const Message &paragraph : section.paragraphs)
            text += QString::fromStdString(english(paragraph)) + '\n';
        for (const CertificateField &field : section.fields)
            text += QString::fromStdString(english(field.value)) + '\n';
        for (const CertificateTable &table : section.tables)
            for (const auto &row : table.rows)
                for (const Message &cell : row)
                    text += QString::fromStdString(english(cell)) + '\n';
    }
    return text;
}

/// The number that a cell begins with.
inline double number(const QString &cell)
{
    return cell.section(' ', 0, 0).toDouble();
}

} // namespace dyncal::test

/// A sentence that the operator reads holds these words.
#define DYNCAL_SAYS(sentence, words)                                                               \
    do {                                                                                           \
        const QString readText = (sentence);                                                       \
        QVERIFY2(readText.contains(words), qPrintable("read: " + readText));                       \
    } while (false)
