// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/formats/hdf5/hdf5_capture_reader.h"
#include "core/synthesis/defect_kinds.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using dyncal::DefectDescription;
using dyncal::defectDescriptions;

/// Files written by `simulate`, and what `info` says of them.
class TestSimulateAndInfo : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    static QStringList small(const QString &output)
    {
        return {"simulate", "-o", output, "--sample-rate-hz", "2e7", "--duration-s", "0.005"};
    }

private slots:
    void simulate_printsTheTruthOfEveryShot()
    {
        const Answer answer = runDyncal(small(path("a.h5")) << "--shots"
                                                            << "low,high");
        QCOMPARE(answer.exitCode, 0);
        QVERIFY2(answer.out.startsWith("Wrote " + path("a.h5").toUtf8()), answer.out);
        QVERIFY2(answer.out.contains("\n1     low ") && answer.out.contains("\n2     high "),
            answer.out);
        QVERIFY2(answer.out.contains("Hz"), answer.out);
        QCOMPARE(answer.err, QByteArray());
    }

    void simulate_withTheClockSet_isByteIdentical()
    {
        const QStringList epoch{"SOURCE_DATE_EPOCH=1767225600"};
        QCOMPARE(runDyncal(small(path("one.h5")), epoch).exitCode, 0);
        QCOMPARE(runDyncal(small(path("two.h5")), epoch).exitCode, 0);
        QVERIFY(!bytesOf(path("one.h5")).isEmpty());
        QVERIFY(bytesOf(path("one.h5")) == bytesOf(path("two.h5")));
        QCOMPARE(runDyncal(small(path("three.h5")) << "--seed"
                                                   << "2",
                     epoch)
                     .exitCode,
            0);
        QVERIFY(bytesOf(path("one.h5")) != bytesOf(path("three.h5")));
    }

    void simulate_customSensor_saysItsTruth()
    {
        const Answer answer = runDyncal(small(path("custom.h5")) << "--f0-hz"
                                                                 << "123000"
                                                                 << "--zeta"
                                                                 << "0.05");
        QCOMPARE(answer.exitCode, 0);
        QVERIFY2(answer.out.contains("123 kHz") && answer.out.contains("0.05"), answer.out);
    }

    void simulate_defectHelp_namesAllKindsWithTheirSizes()
    {
        const Answer answer = runDyncal({"simulate", "--defect", "help"});
        QCOMPARE(answer.exitCode, 0);
        QCOMPARE(answer.err, QByteArray());
        for (const DefectDescription &description : defectDescriptions())
            QVERIFY2(answer.out.contains("\n" + QByteArray(description.name)), description.name);
        QVERIFY2(answer.out.contains("\nheat=0.02:5e-04 "), answer.out);
    }

    void simulate_wrongDefect_isWrongUsageInOneSentence()
    {
        const QString file = path("wrong.h5");
        for (const char *defect : {"heats", "heat=x", "heat=2", "clip=1", "distance@2", "gain@9"}) {
            const Answer answer = runDyncal(small(file) << "--defect" << defect);
            QCOMPARE(answer.exitCode, 4);
            QCOMPARE(answer.out, QByteArray());
            QCOMPARE(answer.complaints().size(), 1);
            QVERIFY(!QFile::exists(file));
        }
        const Answer unknown = runDyncal(small(file) << "--defect"
                                                     << "heats");
        for (const DefectDescription &description : defectDescriptions())
            QVERIFY2(unknown.err.contains(description.name), description.name);
    }

    void simulate_everyDefect_isReadByInfo()
    {
        for (const DefectDescription &description : defectDescriptions()) {
            const QString file = path(description.name) + ".h5";
            const Answer written = runDyncal(small(file) << "--defect" << description.name);
            QVERIFY2(written.exitCode == 0, description.name + written.err);
            QCOMPARE(written.err, QByteArray());
            const Answer info = runDyncal({"info", "--json", file});
            QVERIFY2(info.exitCode <= 2, description.name + info.err);
            const QJsonObject read = info.json();
            QCOMPARE(read["shots"].toArray().size(), 3);
            QCOMPARE(read["shots"][1]["channels"].toArray().size(), 3);
            QVERIFY2(read["shots"][1]["channels"][0]["samples"].toInt() > 10000, description.name);
        }
    }

    void simulate_recordsGasAndHumidity()
    {
        const QString file = path("noted.h5");
        QCOMPARE(runDyncal(small(file)).exitCode, 0);
        const auto set = dyncal::readHdf5Capture(file.toStdString(), {}, {});
        QVERIFY(set.has_value());
        QCOMPARE(set->tube.at("driven_gas"), std::string("air"));
        QCOMPARE(set->tubeNumber("gamma1").value(), 1.402);
        QCOMPARE(set->tubeNumber("M1").value(), 0.028966);
        for (const dyncal::Shot &shot : set->shots)
            QCOMPARE(shot.environment.relativeHumidity, 0.0);
    }

    void simulate_intoAMissingFolder_isRefusedAndLeavesNothing()
    {
        const Answer answer = runDyncal(small(path("none/a.h5")));
        QVERIFY(answer.exitCode >= 3);
        QVERIFY2(answer.err.contains("none/a.h5"), answer.err);
        QVERIFY(!QDir(path("none")).exists());
    }

    void simulate_interrupted_leavesNoFile()
    {
        QDir().mkpath(path("stopped"));
        QProcess process;
        process.start(qEnvironmentVariable("DYNCAL_BINARY"),
            {"simulate", "-o", path("stopped/big.h5"), "--duration-s", "0.4"});
        QVERIFY(process.waitForStarted());
        QVERIFY(waitUntilAwaited(process, SIGINT));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QCOMPARE(
            QDir(path("stopped")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden),
            QStringList());
    }

    void info_listsShotsAndChannels()
    {
        QCOMPARE(runDyncal(small(path("info.h5"))).exitCode, 0);
        const Answer answer = runDyncal({"info", path("info.h5")});
        QVERIFY2(answer.exitCode <= 1, answer.err);
        QVERIFY2(answer.out.startsWith("info.h5: dyncal-capture, sha256 "), answer.out);
        QVERIFY2(answer.out.contains("Shot 3"), answer.out);
        QVERIFY2(answer.out.contains("dut") && answer.out.contains("20 MHz"), answer.out);
        QVERIFY2(answer.out.contains("100000 samples"), answer.out);
    }

    void info_asJson_holdsTheSame()
    {
        QCOMPARE(runDyncal(small(path("json.h5"))).exitCode, 0);
        const QJsonObject info = runDyncal({"info", "--json", path("json.h5")}).json();
        QCOMPARE(info["schema"].toString(), QStringLiteral("dyncal-info/1"));
        QCOMPARE(info["files"].toArray().size(), 1);
        QCOMPARE(info["files"][0]["sha256"].toString().size(), 64);
        QCOMPARE(info["shots"].toArray().size(), 3);
        QCOMPARE(info["shots"][2]["shot"].toInt(), 3);
        QCOMPARE(info["shots"][2]["level"].toString(), QStringLiteral("high"));
        QStringList roles;
        for (const QJsonValue &channel : info["shots"][0]["channels"].toArray()) {
            roles << channel["role"].toString();
            QCOMPARE(channel["sample_rate_hz"].toDouble(), 2e7);
            QCOMPARE(channel["samples"].toInt(), 100000);
            QCOMPARE(channel["duration_s"].toDouble(), 0.005);
        }
        QVERIFY2(roles.contains("dut"), qPrintable(roles.join(',')));
    }

    void info_ofAFolder_takesEveryReadableFileInNaturalOrder()
    {
        QDir().mkpath(path("set"));
        for (const char *name : {"set/shot10.h5", "set/shot2.h5"})
            QCOMPARE(runDyncal(small(path(name)) << "--shots"
                                                 << "low")
                         .exitCode,
                0);
        const QJsonObject info = runDyncal({"info", "--json", path("set")}).json();
        QCOMPARE(info["files"].toArray().size(), 2);
        QCOMPARE(info["files"][0]["file"].toString(), QStringLiteral("shot2.h5"));
        QCOMPARE(info["files"][1]["file"].toString(), QStringLiteral("shot10.h5"));
    }
};

DYNCAL_TEST(TestSimulateAndInfo)
#include "tst_simulate_and_info.moc"
