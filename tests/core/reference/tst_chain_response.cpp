// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The response of amplifier and converter as a file states it, and every reason to refuse it.

#include "core/base/content_hash.h"
#include "core/reference/chain_response.h"
#include "tests/support/near.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace dyncal;
using testing::isNear;

namespace {

constexpr const char *kTable = "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad\n"
                               "100,1,0.001,0,0.0001\n"
                               "1e6,0.5,0.002,-1,0.003\n";

ChainSettings settingsOf(const std::string &content)
{
    ChainSettings settings;
    settings.source = "amp.csv";
    settings.loaded
        = std::make_shared<const ReferenceSource>(ReferenceSource{sha256Hex(content), content});
    return settings;
}

std::string faultOf(const ChainSettings &settings, ErrorKind kind)
{
    const auto read = chainResponse(settings);
    return read || read.error().kind != kind ? "" : english(read.error().message);
}

} // namespace

class TestChainResponse : public QObject
{
    Q_OBJECT

private slots:
    void table_isTaken()
    {
        const ChainResponse chain = *chainResponse(settingsOf(kTable)).value();
        QCOMPARE(chain.sourceSha256, sha256Hex(std::string_view(kTable)));
        QVERIFY(isNear(chain.relative.at(1e4)->magnitude, 0.75));
        QVERIFY(!chain.relative.at(2e6));
    }

    void nothingStated_isNoChain() { QVERIFY(!chainResponse({}).value()); }

    void unreadableFile_isNamed()
    {
        ChainSettings settings = settingsOf(kTable);
        settings.loaded.reset();
        const std::string said = faultOf(settings, ErrorKind::FileUnreadable);
        QVERIFY(said.find("amp.csv") != said.npos && said.find("chain.source") != said.npos);
    }

    void otherHash_blocks()
    {
        ChainSettings settings = settingsOf(kTable);
        settings.sha256 = std::string(64, 'a');
        QVERIFY(
            faultOf(settings, ErrorKind::DataBlocked).find("chain.sha256") != std::string::npos);
        settings.sha256 = settings.loaded->sha256;
        QVERIFY(chainResponse(settings));
    }

    /// A gain of 100 in the table would be divided out of what the channel's scale has already.
    void absoluteGain_isRefused()
    {
        const std::string said = faultOf(
            settingsOf("frequency_hz,magnitude,u_magnitude\n100,99.8,0.1\n200,99.8,0.1\n"),
            ErrorKind::Usage);
        QVERIFY(said.find("99.8") != said.npos && said.find("100 Hz") != said.npos);
        QVERIFY(chainResponse(
            settingsOf("frequency_hz,magnitude,u_magnitude\n100,0.99,0.006\n200,0.99,0.006\n")));
        QVERIFY(!chainResponse(
            settingsOf("frequency_hz,magnitude,u_magnitude\n100,0.99,0.004\n200,0.99,0.004\n")));
    }

    void invertingOrTurnedPhase_isRefused_data()
    {
        QTest::addColumn<double>("phase_rad");
        QTest::addColumn<bool>("isTaken");
        QTest::newRow("delay") << -0.3 << true;
        QTest::newRow("inverting") << 3.14159 << false;
        QTest::newRow("a turn") << -6.2832 << false;
    }
    void invertingOrTurnedPhase_isRefused()
    {
        QFETCH(double, phase_rad);
        QFETCH(bool, isTaken);
        const QByteArray phase = QByteArray::number(phase_rad);
        const std::string table
            = "frequency_hz,magnitude,u_magnitude,phase_rad,u_phase_rad\n100,1,0,"
            + phase.toStdString() + ",0.01\n200,1,0," + phase.toStdString() + ",0.01\n";
        QCOMPARE(chainResponse(settingsOf(table)).has_value(), isTaken);
    }

    /// Between rows straight lines are drawn: a wrapped phase would be crossed by one.
    void wrappedPhase_isRefused()
    {
        const std::string said
            = faultOf(settingsOf("frequency_hz,magnitude,u_magnitude,phase_rad,"
                                 "u_phase_rad\n100,1,0,0,0.01\n200,1,0,-3.1,0.01\n"
                                 "300,1,0,3.1,0.01\n"),
                ErrorKind::Usage);
        QVERIFY2(said.find("half a turn") != said.npos, said.c_str());
    }

    void oneRow_isRefused()
    {
        QVERIFY(
            faultOf(settingsOf("frequency_hz,magnitude,u_magnitude\n100,1,0.1\n"), ErrorKind::Usage)
                .find("one row")
            != std::string::npos);
    }

    void malformedTable_isRefused()
    {
        const std::string said = faultOf(settingsOf("nonsense"), ErrorKind::Usage);
        QVERIFY(said.find("chain.source") != said.npos && said.find("column") != said.npos);
    }

    /// Below its first row and above its last nobody measured it.
    void ends_areTheTable()
    {
        const ReferenceSensitivity H = chainResponse(settingsOf(kTable)).value()->relative;
        QCOMPARE(H.lowest_Hz(), 100.0);
        QCOMPARE(H.highest_Hz(), 1e6);
        QVERIFY(!H.at(99.0) && !H.at(1.01e6));
        QCOMPARE(H.lowest().u_magnitude, 0.001);
    }

    void settings_differByTheFile()
    {
        const ChainSettings one = settingsOf(kTable);
        ChainSettings other = one;
        QVERIFY(one == other);
        other.quantityId = "a";
        QVERIFY(!(one == other));
        QVERIFY(!(one == settingsOf("x")));
    }
};

DYNCAL_TEST(TestChainResponse)
#include "tst_chain_response.moc"
