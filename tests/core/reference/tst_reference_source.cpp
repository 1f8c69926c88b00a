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

    /// What a run keeps, for a recipe that lies beside it; never a file with another hash.
    void copyOfARun_isFoundByItsHash()
    {
        QTemporaryDir folder;
        ComparisonSettings settings;
        settings.source = "calibrations/ref.csv";
        settings.sha256 = sha256Hex(std::string_view("abc"));
        const std::string kept = keptSourceName(settings.source, settings.sha256);
        QCOMPARE(kept, "sources/" + settings.sha256.substr(0, 16) + "-ref.csv");
        QVERIFY(isKeptSourceName(kept));
        QVERIFY(QDir(folder.path()).mkdir("sources"));
        QFile file(folder.filePath(QString::fromStdString(kept)));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("abc") == 3);
        file.close();
        loadSource(folder.path().toStdString(), settings);
        QVERIFY(settings.loaded && settings.loaded->content == "abc");
        settings.sha256 = std::string(64, '0');
        loadSource(folder.path().toStdString(), settings);
        QVERIFY(!settings.loaded);
    }

    void otherNames_areNoCopies()
    {
        for (const char *name : {"sources/ref.csv", "sources/0123456789abcdef-", "sources/",
                 "csv/0123456789abcdef-a", "sources/0123456789abcdef0-a",
                 "sources/0123456789abcdef-a/b", "sources/0123456789ABCDEF-a"})
            QVERIFY2(!isKeptSourceName(name), name);
        QVERIFY(isKeptSourceName("sources/0123456789abcdef-a"));
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
