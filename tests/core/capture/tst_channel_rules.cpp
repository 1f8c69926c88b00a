// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/capture/channel_rules.h"
#include "tests/support/signals.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace dyncal;
using testing::hasFinding;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A DUT of 1 V/bar behind an amplifier, or another channel.
Channel channelOf(const char *unit, ChannelRole role = ChannelRole::Dut)
{
    Channel channel = testing::doubleChannel(Eigen::Vector3d(0.5, -2.0, 4.0), 1e6);
    channel.name = "ai0";
    channel.role = role;
    channel.unit = unit;
    return channel;
}

ImportSettings ofTheDut(std::string unit)
{
    ImportSettings settings;
    settings.unit = std::move(unit);
    settings.scale = 3.0;
    settings.polarity = -1;
    settings.reference = "absolute";
    return settings;
}

struct Shaped
{
    Channel channel;
    Findings findings;
    Result<void> done;

    double first() const { return physicalValues(channel, 0, 1)[0]; }
};

Shaped shaped(Channel channel, const ImportSettings &settings, const Attributes &card = {})
{
    Shaped result{std::move(channel), {}, {}};
    result.done = shapeChannel(result.channel, 3, settings, card, result.findings);
    return result;
}

struct Rated
{
    double rate_Hz = 0.0;
    Findings findings;
    Result<void> done;
};

Rated rated(double stated_Hz, std::optional<double> typed_Hz, const char *reason = "",
    double mismatch_percent = 0.1)
{
    Channel channel = channelOf("V");
    channel.sampleRate_Hz = stated_Hz;
    ImportSettings settings;
    settings.sampleRate_Hz = typed_Hz;
    settings.sampleRateReason = reason;
    CheckSettings checks;
    checks.rateMismatch_percent = mismatch_percent;
    Rated result;
    result.done = setSampleRate(channel, 2, settings, checks, result.findings);
    result.rate_Hz = channel.sampleRate_Hz;
    return result;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-14 * std::abs(b);
}

} // namespace

class TestChannelRules : public QObject
{
    Q_OBJECT

private slots:
    void unitInTheName_isReadWhereNoneIsStated_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<double>("factor");
        QTest::newRow("millivolt") << "DUT_mV"
                                   << "V" << 1e-3;
        QTest::newRow("volt") << "ai0_V"
                              << "V" << 1.0;
        QTest::newRow("in words") << "p5 in kPa"
                                  << "Pa" << 1e3;
        QTest::newRow("bar") << "Side bar"
                             << "Pa" << 1e5;
        QTest::newRow("a numeral") << "Channel V"
                                   << "" << 1.0;
        QTest::newRow("other letters") << "DUT_mv2"
                                       << "" << 1.0;
        QTest::newRow("nothing but a unit") << "_mV"
                                            << "" << 1.0;
        QTest::newRow("a unit alone") << "mV"
                                      << "" << 1.0;
    }
    void unitInTheName_isReadWhereNoneIsStated()
    {
        QFETCH(QString, name);
        QFETCH(QString, unit);
        QFETCH(double, factor);
        Channel channel = channelOf("");
        channel.name = name.toStdString();
        Shaped found = shaped(channel, {});
        QCOMPARE(found.channel.name, name.toStdString());
        QCOMPARE(found.channel.unit, unit.toStdString());
        QVERIFY(isNear(found.first(), 0.5 * factor));
        QCOMPARE(hasFinding(found.findings, "CAP-033"), !unit.isEmpty());
    }

    /// What the file or the recipe states counts, and a scale is a conversion already.
    void unitInTheName_isNotReadElsewhere()
    {
        Channel channel = channelOf("");
        channel.name = "DUT_mV";
        ImportSettings settings;
        settings.scale = 1e-3;
        Shaped found = shaped(channel, settings);
        QVERIFY(isNear(found.first(), 0.5e-3) && found.findings.empty());
        settings = {};
        settings.unit = "V";
        found = shaped(channel, settings);
        QVERIFY(isNear(found.first(), 0.5) && found.findings.empty());
        channel.unit = "V";
        found = shaped(channel, {});
        QVERIFY(isNear(found.first(), 0.5) && found.findings.empty());
    }

    void statedRate_stays()
    {
        const Rated found = rated(1e6, {});
        QVERIFY(found.done.has_value());
        QCOMPARE(found.rate_Hz, 1e6);
        QVERIFY(found.findings.empty());
    }

    void typedRate_takesItsPlaceAsFarAsItAgrees_data()
    {
        QTest::addColumn<double>("typed");
        QTest::addColumn<bool>("isSaid");
        QTest::addColumn<bool>("contradicts");
        QTest::newRow("the same") << 1e6 << false << false;
        QTest::newRow("written as an interval") << 1e6 * (1.0 + 5e-10) << false << false;
        QTest::newRow("5e-9 off") << 1e6 * (1.0 + 5e-9) << true << false;
        QTest::newRow("0.0999 % more") << 1.000999e6 << true << false;
        QTest::newRow("0.0999 % less") << 0.999001e6 << true << false;
        QTest::newRow("0.1001 % more") << 1.001001e6 << true << true;
        QTest::newRow("0.1001 % less") << 0.998999e6 << true << true;
        QTest::newRow("ten times") << 1e7 << true << true;
    }
    void typedRate_takesItsPlaceAsFarAsItAgrees()
    {
        QFETCH(double, typed);
        QFETCH(bool, isSaid);
        QFETCH(bool, contradicts);
        Rated found = rated(1e6, typed);
        QCOMPARE(found.done.has_value(), !contradicts);
        QCOMPARE(found.rate_Hz, contradicts ? 1e6 : typed);
        QCOMPARE(found.findings.size(), std::size_t(isSaid && !contradicts));
        if (contradicts) {
            QCOMPARE(found.done.error().findingId, std::string("CAP-003"));
            QCOMPARE(found.done.error().shot, Index(2));
            const std::string text = english(found.done.error().message);
            QVERIFY2(text.find("'ai0'") != std::string::npos, text.c_str());
            QVERIFY2(text.find("1 MHz") != std::string::npos, text.c_str());
        }
        found = rated(1e6, typed, "clock divider");
        QVERIFY(found.done.has_value());
        QCOMPARE(found.rate_Hz, typed);
        QCOMPARE(found.findings.size(), std::size_t(isSaid));
        if (isSaid) {
            QCOMPARE(found.findings[0].id, std::string("CAP-025"));
            QVERIFY((found.findings[0].severity == Severity::Caution) == contradicts);
            const std::string text = english(found.findings[0].message);
            QCOMPARE(text.find("clock divider") != std::string::npos, contradicts);
            QCOMPARE(found.findings[0].value.value(), typed);
            QCOMPARE(found.findings[0].limit.value(), 1e6);
        }
    }

    void unitInPlaceOfTheFiles_isSaid_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("recipe");
        QTest::addColumn<double>("scale");
        QTest::addColumn<QString>("severity"); // "" = nothing said
        QTest::newRow("another quantity") << "V"
                                          << "A" << 1.0 << "caution";
        QTest::newRow("what nobody knows") << "V"
                                           << "foo" << 1.0 << "caution";
        QTest::newRow("another size") << "V"
                                      << "mV" << 1.0 << "caution";
        QTest::newRow("volts as bar") << "V"
                                      << "bar" << 1.0 << "caution";
        QTest::newRow("volts as bar, by a factor") << "V"
                                                   << "bar" << 20.0 << "info";
        QTest::newRow("the same") << "V"
                                  << "V" << 1.0 << "";
        QTest::newRow("the same, spelt out") << "V"
                                             << "Volts" << 1.0 << "";
        QTest::newRow("pascal of the same size") << "hPa"
                                                 << "mbar" << 1.0 << "";
        QTest::newRow("file without a unit") << "1"
                                             << "V" << 1.0 << "";
        QTest::newRow("empty in the file") << ""
                                           << "V" << 1.0 << "";
        QTest::newRow("counts") << "counts"
                                << "V" << 1.0 << "";
    }
    void unitInPlaceOfTheFiles_isSaid()
    {
        QFETCH(QString, file);
        QFETCH(QString, recipe);
        QFETCH(double, scale);
        QFETCH(QString, severity);
        ImportSettings settings;
        settings.unit = recipe.toStdString();
        settings.scale = scale;
        Channel channel = channelOf(file.toUtf8().constData());
        const Findings said = shaped(channel, settings).findings;
        QCOMPARE(said.size(), std::size_t(!severity.isEmpty()));
        if (!said.empty()) {
            QCOMPARE(said[0].id, std::string("CAP-030"));
            QCOMPARE(severityName(said[0].severity), severity.toStdString());
            QCOMPARE(said[0].shot, Index(0)); // the same of all shots
            const std::string text = english(said[0].message);
            QVERIFY2(text.find("'ai0'") != std::string::npos, text.c_str());
            QVERIFY2(text.find(recipe.toStdString()) != std::string::npos, text.c_str());
        }
        channel.role = ChannelRole::Other; // import.unit is the DUT's
        QVERIFY(shaped(channel, settings).findings.empty());
    }

    void sameContradiction_isSaidOnce()
    {
        ImportSettings settings;
        settings.unit = "A";
        Findings findings;
        for (Index shot = 1; shot <= 3; ++shot) {
            Channel channel = channelOf("V");
            QVERIFY(shapeChannel(channel, shot, settings, {}, findings));
        }
        QCOMPARE(findings.size(), std::size_t(1));
    }

    void sensitivityOfTheRecipe_isHeldAgainstTheCard()
    {
        ImportSettings settings;
        settings.channelDetails["ai0"].sensitivity = 2e-5;
        const Attributes card{{"sensitivity", "10"}, {"sensitivity_unit", "mV/kPa"}};
        const Shaped other = shaped(channelOf("mV"), settings, card);
        QCOMPARE(other.findings.size(), std::size_t(1));
        QCOMPARE(other.findings[0].id, std::string("CAP-032"));
        QVERIFY(std::abs(other.first() / (0.5e-3 / 2e-5) - 1.0) < 1e-12); // the recipe's is used
        settings.channelDetails["ai0"].sensitivity = 1e-5;
        QVERIFY(shaped(channelOf("mV"), settings, card).findings.empty());
        QVERIFY(shaped(channelOf("mV"), settings).findings.empty());
    }

    void mismatch_limitIsTheLaboratorys()
    {
        QVERIFY(rated(1e6, 1.02e6, "", 3.0).done.has_value());
        QVERIFY(!rated(1e6, 1.02e6, "", 1.0).done.has_value());
    }

    void fileWithoutRate_takesTheTypedOneSilently()
    {
        for (const double none : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()}) {
            const Rated found = rated(none, 2e5);
            QVERIFY(found.done.has_value());
            QCOMPARE(found.rate_Hz, 2e5);
            QVERIFY(found.findings.empty());
            const Rated neither = rated(none, {});
            QVERIFY(!neither.done);
            QCOMPARE(neither.done.error().findingId, std::string("CAP-003"));
        }
        for (const double nonsense : {0.0, -1e6, kNaN})
            QVERIFY(!rated(1e6, nonsense, "because").done);
    }

    void sameFinding_isSaidOnce()
    {
        Findings findings;
        ImportSettings settings;
        settings.sampleRate_Hz = 1.0005e6;
        for (int shot = 1; shot <= 3; ++shot) {
            Channel channel = channelOf("V");
            channel.sampleRate_Hz = shot == 3 ? 1.0001e6 : 1e6;
            QVERIFY(setSampleRate(channel, shot, settings, {}, findings).has_value());
        }
        QCOMPARE(findings.size(), std::size_t(2)); // one per pair of rates
    }

    void unit_becomesSi_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("si");
        QTest::addColumn<double>("factor");
        QTest::newRow("bar") << "bar"
                             << "Pa" << 1e5;
        QTest::newRow("psi") << "psi"
                             << "Pa" << 6894.757; // NIST SP 811
        QTest::newRow("mbar") << "mbar"
                              << "Pa" << 100.0;
        QTest::newRow("hPa") << "hPa"
                             << "Pa" << 100.0;
        QTest::newRow("kPa") << "kPa"
                             << "Pa" << 1e3;
        QTest::newRow("MPa") << "MPa"
                             << "Pa" << 1e6;
        QTest::newRow("mV") << "mV"
                            << "V" << 1e-3;
        QTest::newRow("uV") << "uV"
                            << "V" << 1e-6;
        QTest::newRow("micro V") << QString(QChar(0xB5)) + "V"
                                 << "V" << 1e-6;
        QTest::newRow("kV") << "kV"
                            << "V" << 1e3;
    }
    void unit_becomesSi()
    {
        QFETCH(QString, unit);
        QFETCH(QString, si);
        QFETCH(double, factor);
        const Shaped found = shaped(channelOf(qPrintable(unit)), {});
        QCOMPARE(QString::fromStdString(found.channel.unit), si);
        QCOMPARE(QString::fromStdString(found.channel.recordedUnit), unit);
        QVERIFY(isNear(found.first(), 0.5 * factor));
    }

    void unitsThatAreSiOrUnknown_stay()
    {
        for (const char *unit : {"Pa", "V", "K", "g", "degC", "", "BAR", "mv"}) {
            const Shaped found = shaped(channelOf(unit), {});
            QCOMPARE(found.channel.unit, std::string(unit));
            QVERIFY(found.channel.recordedUnit.empty());
            QCOMPARE(found.first(), 0.5);
        }
    }

    void everythingTogether_isOneFactor()
    {
        // -1 x 2 x value / 10 in mV, and 4 mV per Pa... of the sensor: 4e-3 V/Pa.
        ImportSettings settings;
        ChannelImport &details = settings.channelDetails["ai0"];
        details.unit = "mV";
        details.scale = 2.0;
        details.gain = 10.0;
        details.polarity = -1;
        details.sensitivity = 4e-3;
        details.reference = "gauge";
        const Shaped found = shaped(channelOf("furlong"), settings);
        QVERIFY(found.done.has_value());
        QVERIFY(isNear(found.first(), -0.5 * 2.0 / 10.0 * 1e-3 / 4e-3));
        QCOMPARE(found.channel.unit, std::string("Pa"));
        QCOMPARE(found.channel.quantity, std::string("pressure"));
        QVERIFY(found.channel.recordedUnit.empty());
        QVERIFY(found.channel.reference == PressureReference::Gauge);
    }

    void whatIsSaidOfTheDut_completesWhatIsSaidOfTheChannel()
    {
        ImportSettings settings = ofTheDut("bar");
        Shaped found = shaped(channelOf("V"), settings);
        QVERIFY(isNear(found.first(), -0.5 * 3.0 * 1e5));
        QVERIFY(found.channel.reference == PressureReference::Absolute);
        found = shaped(channelOf("V", ChannelRole::DrivenSide), settings); // of the DUT only
        QCOMPARE(found.first(), 0.5);
        QVERIFY(found.channel.reference == PressureReference::Unknown);
        settings.channelDetails["ai0"].scale = 7.0; // the channel's own wins
        settings.channelDetails["ai0"].reference = "gauge";
        found = shaped(channelOf("V"), settings);
        QVERIFY(isNear(found.first(), -0.5 * 7.0 * 1e5));
        QVERIFY(found.channel.reference == PressureReference::Gauge);
        found = shaped(channelOf("V", ChannelRole::DrivenSide), settings);
        QVERIFY(isNear(found.first(), 0.5 * 7.0));
    }

    void sensitivityOfAPressure_isRefused()
    {
        for (const char *unit : {"bar", "Pa"}) {
            ImportSettings settings;
            settings.channelDetails["ai0"].sensitivity = 1e-5;
            const Shaped found = shaped(channelOf(unit), settings);
            QVERIFY(!found.done);
            QVERIFY(found.done.error().kind == ErrorKind::Usage);
            const std::string text = english(found.done.error().message);
            QVERIFY2(text.find(std::string("(") + unit + ")") != std::string::npos, text.c_str());
        }
    }

    void sensitivityOfAnUnknownUnit_isRefused()
    {
        const auto divided = [](const char *unit) {
            ImportSettings settings;
            settings.channelDetails["ai0"].sensitivity = 1e-3;
            return shaped(channelOf(unit), settings);
        };
        for (const char *unit : {"mv", "MV", "counts", "kpa", "mA", "pC", "N/mm2", "Milivolt"}) {
            const Shaped found = divided(unit);
            QVERIFY2(!found.done, unit);
            QVERIFY(found.done.error().kind == ErrorKind::Usage);
            const std::string text = english(found.done.error().message);
            QVERIFY2(text.find(std::string("\"") + unit + "\"") != std::string::npos
                    && text.find("V, mV, uV, kV") != std::string::npos,
                text.c_str());
        }
        const struct
        {
            const char *unit;
            double factor;
        } known[] = {{"V", 1.0}, {"Volt", 1.0}, {"Volts", 1.0}, {"volts", 1.0}, {"mV", 1e-3},
            {"uV", 1e-6}, {"\u00B5V", 1e-6}, {"\u03BCV", 1e-6}, {"A", 1.0}, {"C", 1.0}, {"1", 1.0}};
        for (const auto &row : known) {
            const Shaped found = divided(row.unit);
            QVERIFY2(found.done.has_value(), row.unit);
            QVERIFY2(isNear(found.first(), 0.5 * row.factor / 1e-3), row.unit);
        }
    }

    void gaps_ofTheDutAreFilledAndSaid()
    {
        ImportSettings settings;
        settings.interpolateInvalid = 1;
        for (const ChannelRole role : {ChannelRole::Dut, ChannelRole::DrivenSide}) {
            Channel channel = channelOf("mV", role);
            channel.samples = RawSamples(std::vector<double>{1.0, kNaN, 3.0});
            channel.sha256 = "of the recording";
            const Shaped found = shaped(channel, settings);
            const bool isDut = role == ChannelRole::Dut;
            QCOMPARE(hasFinding(found.findings, "CAP-022"), isDut);
            QCOMPARE(std::isfinite(found.channel.samples.at(1)), isDut);
            QCOMPARE(found.channel.sha256, std::string("of the recording"));
            if (isDut) {
                QCOMPARE(found.channel.samples.at(1), 2.0);
                QCOMPARE(found.findings[0].value.value(), 1.0);
                QCOMPARE(found.findings[0].shot, Index(3));
            }
        }
    }
};

DYNCAL_TEST(TestChannelRules)
#include "tst_channel_rules.moc"
