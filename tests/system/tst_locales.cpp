// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"
#include "tests/system/quick_recipe.h"

#include <QDir>
#include <QDirIterator>
#include <QMap>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

/// The same bytes come out wherever the program runs: with a decimal comma (de_DE) and with letters
/// whose case changes otherwise (tr_TR: I and i are different letters), in every time zone.
class TestLocales : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const QString &name) const { return m_folder.filePath(name); }

    static bool run(const QString &program, const QStringList &arguments, QByteArray *out = nullptr,
        const QStringList &extra = {})
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const QString &variable : extra)
            environment.insert(variable.section('=', 0, 0), variable.section('=', 1));
        process.setProcessEnvironment(environment);
        process.start(program, arguments);
        const bool done = process.waitForFinished(120000);
        if (out)
            *out = process.readAllStandardOutput();
        return done && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    }

    /// Environment of a locale made in the temporary folder; empty if it cannot be made.
    QStringList environmentOf(const QString &locale) const
    {
        const QString name = locale + ".UTF-8";
        const QString compiler = QStandardPaths::findExecutable(
            "localedef", {"/usr/bin", "/usr/sbin", "/bin", "/sbin"});
        if (compiler.isEmpty() || !run(compiler, {"-i", locale, "-f", "UTF-8", path(name)}))
            return {};
        return {"LOCPATH=" + m_folder.path(), "LC_ALL=" + name, "LANG=" + name,
            "SOURCE_DATE_EPOCH=1767225600"};
    }

    /// A ringing step with times, as a laboratory's recorder writes it.
    QString writeTable() const
    {
        QByteArray text = "Time [ms];DUT [mV]\n";
        for (int i = 0; i < 6000; ++i) {
            const double t = i < 2000 ? 0.0 : static_cast<double>(i - 2000);
            const double noise = 0.01 * std::sin(12.9898 * i * i);
            const double value = (i < 2000 ? 0.0 : 1.0 - std::exp(-t / 300.0) * std::cos(0.3 * t));
            text += QByteArray::number(0.001 * i, 'f', 3) + ';'
                + QByteArray::number(1000.0 * (value + noise), 'f', 6) + '\n';
        }
        text.replace('.', ',');
        writeBytes(path("decimal comma.csv"), text);
        return path("decimal comma.csv");
    }

private slots:
    void run_inEveryTimeZone_givesTheSameBytes()
    {
        const QString table = writeTable();
        const auto filesOf = [&](const QString &zone) {
            const QString folder = path("zone " + QString(zone).replace('/', '-'));
            const Answer answer
                = runDyncal(QStringList{"run", table, "--order", "4", "-o", folder} + quickly(),
                    {"TZ=" + zone, "SOURCE_DATE_EPOCH=1767225600"});
            QMap<QString, QByteArray> files;
            QDirIterator entry(folder, QDir::Files, QDirIterator::Subdirectories);
            while (answer.exitCode <= 1 && entry.hasNext()) {
                const QString file = entry.next();
                files[QDir(folder).relativeFilePath(file)] = bytesOf(file);
            }
            return files;
        };
        const QMap<QString, QByteArray> utc = filesOf("UTC");
        QVERIFY(utc.size() > 10 && utc["certificate.pdf"].size() > 10000);
        // As names of the time zone data and as rules that need no data.
        for (const char *zone : {"Pacific/Kiritimati", "Etc/GMT+12", "X-14", "X+12", "X-5:45"}) {
            const QMap<QString, QByteArray> there = filesOf(zone);
            QCOMPARE(there.keys(), utc.keys());
            for (const QString &file : utc.keys())
                QVERIFY2(there[file] == utc[file], qPrintable(file + " in " + zone));
        }
    }

    void run_ofATableWithDecimalCommas_givesTheSameBytes_data()
    {
        QTest::addColumn<QString>("locale");
        QTest::newRow("de_DE") << "de_DE";
        QTest::newRow("tr_TR") << "tr_TR";
    }

    void run_ofATableWithDecimalCommas_givesTheSameBytes()
    {
        QFETCH(QString, locale);
        const QStringList environment = environmentOf(locale);
        if (environment.isEmpty())
            QSKIP("NOT TESTED: localedef or the source of the locale is missing (package locales)");
        QByteArray one;
        QVERIFY(run("/usr/bin/printf", {"%.1f", "1"}, &one, environment));
        QCOMPARE(one, QByteArray("1,0")); // else the locale is not in force and nothing is tested

        const QString table = writeTable();
        const Answer there
            = runDyncal(QStringList{"run", table, "-o", path(locale)} + quickly(), environment);
        const Answer here
            = runDyncal(QStringList{"run", table, "-o", path(locale + "-C")} + quickly(),
                {"LC_ALL=C", "LANG=C", "SOURCE_DATE_EPOCH=1767225600"});
        QVERIFY2(here.exitCode == 0 || here.exitCode == 1, here.err);
        QCOMPARE(there.exitCode, here.exitCode);
        const QByteArray results = bytesOf(path(locale) + "/results.json");
        QVERIFY(results.size() > 1000);
        QVERIFY(results == bytesOf(path(locale + "-C") + "/results.json"));
        QVERIFY(bytesOf(path(locale) + "/csv/singular_values.csv")
            == bytesOf(path(locale + "-C") + "/csv/singular_values.csv"));
        QCOMPARE(there.err, here.err);

        const Answer checked = runDyncal({"check", table, "--json"}, environment);
        QVERIFY(checked.json()["schema"] == QLatin1String("dyncal-check/1"));
        QCOMPARE(checked.out, runDyncal({"check", table, "--json"}, {"LC_ALL=C"}).out);
    }
};

DYNCAL_TEST(TestLocales)
#include "tst_locales.moc"
