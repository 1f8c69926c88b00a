// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <QTemporaryDir>
#include <QTest>

namespace {

/// The text between the next two fences behind `where`.
QString blockBehind(const QString &page, const QString &where)
{
    const QString fence = "```\n";
    const qsizetype place = page.indexOf(where);
    const qsizetype begin = page.indexOf(fence, place) + fence.size();
    return place < 0 ? QString() : page.mid(begin, page.indexOf(fence, begin) - begin);
}

} // namespace

/// What the front page shows is what a newcomer sees.
class TestReadme : public QObject
{
    Q_OBJECT

private slots:
    void shownAnswers_areThoseOfTheProgram()
    {
        const QString page = bytesOf(qEnvironmentVariable("DYNCAL_SOURCE_DIR", ".") + "/README.md");
        const QTemporaryDir folder;
        const QString file = folder.filePath("example.h5");

        const Answer simulated = runDyncal({"simulate", "-o", file});
        QCOMPARE(simulated.exitCode, 0);
        const QString told = QString(simulated.out).replace(file, "example.h5");
        QVERIFY(told.startsWith("Wrote example.h5"));
        QVERIFY(page.contains("```\n" + told + "```\n"));

        const Answer run = runDyncal({"run", file, "-o", folder.filePath("out")});
        QCOMPARE(run.exitCode, 0);
        const QString results = QString(run.out).section("Written:", 0, 0);
        QVERIFY(!results.isEmpty());
        QCOMPARE(blockBehind(page, "prints the key results"), results);
    }
};

DYNCAL_TEST(TestReadme)
#include "tst_readme.moc"
