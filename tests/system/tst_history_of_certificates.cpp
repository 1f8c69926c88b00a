// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/made_dcc.h"
#include "tests/support/test_program.h"
#include "tests/system/dyncal_process.h"

#include <nlohmann/json.hpp>

#include <QtTest>

using namespace dyncal::testing;

/// Certificates (DCC) of other laboratories in the history of a sensor, by the built program.
class TestHistoryOfCertificates : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString write(const QString &name, const std::string &text) const
    {
        const QString path = m_folder.filePath(name);
        return writeBytes(path, QByteArray::fromStdString(text)) ? path : QString();
    }
    /// Sensor 4711 in this year.
    QString writeYear(const QString &year, const std::string &sensitivity) const
    {
        std::string text = dccOf(dccQuantity(sensitivity, "\\volt\\mega\\pascal\\tothe{-1}", "0.1")
            + dccList(dccQuantity("1000 10000", "\\hertz")
                + dccQuantity("5 5.1", "\\volt\\mega\\pascal\\tothe{-1}", "0.1 0.2"))
            + dccQuantity("1", "\\furlong"));
        text.replace(text.find("2025-03-04"), 4, year.toStdString());
        return write(year + ".xml", text);
    }

private slots:
    void years_areCompared()
    {
        const Answer answer = runDyncal({"history", writeYear("2024", "5.0"),
            writeYear("2025", "5.3"), "--at", "10000", "--json"});
        QCOMPARE(answer.exitCode, 1); // E_n of the sensitivity: 0.3/hypot(0.1, 0.1)
        const auto root = nlohmann::json::parse(answer.out.toStdString());
        QCOMPARE(root["sensor"].get<std::string>(), std::string("4711"));
        QCOMPARE(root["points"][0]["dcc"]["number"].get<std::string>(), std::string("K-17"));
        QCOMPARE(root["points"][1]["time"].get<std::string>(), std::string("2025-03-04"));
        QVERIFY(std::abs(root["series"][2]["values"][1]["e_n"].get<double>() - 2.1213203) < 1e-6);
        QCOMPARE(root["series"][3]["values"][1]["e_n"].get<double>(), 0.0);
        QCOMPARE(root["left_out"].size(), std::size_t(2));
        QCOMPARE(root["left_out"][0]["why"].get<std::string>(), std::string("not_understood"));
        const Answer text = runDyncal({"history", m_folder.filePath("2024.xml")});
        QVERIFY2(text.out.contains("K-17") && text.out.contains("\\furlong"), text.out);
    }

    void otherXml_isRefusedInASentence()
    {
        const QString cut = write("cut.xml", "<dcc:digitalCalibrationCertificate>");
        const QString bomb = write("bomb.xml", "<!DOCTYPE x [<!ENTITY e 'e'>]>" + dccOf(""));
        const Answer answer = runDyncal({"history", cut, bomb, writeYear("2024", "5.0"), "--json"});
        QCOMPARE(answer.exitCode, 3);
        QVERIFY2(answer.err.contains("malformed") && answer.err.contains("DOCTYPE"), answer.err);
        const auto root = nlohmann::json::parse(answer.out.toStdString());
        QCOMPARE(root["unread"].size(), std::size_t(2));
        QCOMPARE(root["points"].size(), std::size_t(1));
    }
};

DYNCAL_TEST(TestHistoryOfCertificates)
#include "tst_history_of_certificates.moc"
