// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The file that a recipe names for its reference transducer.

#include "core/base/content_hash.h"
#include "core/reference/reference_source.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace dyncal;

class TestReferenceSource : public QObject
{
    Q_OBJECT

private slots:
    void file_isReadRelativeToItsFolder_orByItsFullPath()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath("ref.csv"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("abc") == 3);
        file.close();
        ComparisonSettings settings;
        settings.source = "ref.csv";
        loadSource(folder.path().toStdString(), settings);
        QVERIFY(settings.loaded);
        QCOMPARE(settings.loaded->content, std::string("abc"));
        QCOMPARE(settings.loaded->sha256, sha256Hex(std::string_view("abc")));
        settings.source = file.fileName().toStdString();
        loadSource("/elsewhere", settings);
        QVERIFY(settings.loaded);
    }

    void nothing_isLoaded_withoutAFile()
    {
        ComparisonSettings settings;
        settings.loaded = std::make_shared<const ReferenceSource>();
        loadSource("/", settings);
        QVERIFY(!settings.loaded);
        for (const char *source : {"none.csv", "."}) {
            settings.source = source;
            loadSource(QDir::tempPath().toStdString(), settings);
            QVERIFY(!settings.loaded);
        }
    }
};

DYNCAL_TEST(TestReferenceSource)
#include "tst_reference_source.moc"
