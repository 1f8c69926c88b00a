// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// NI_Scale chains and DAQmx raw data. Expected values are written out from the definitions of the
// scales, not computed by the code under test.

#include "tests/core/capture/formats/tdms/tdms_test_support.h"
#include "tests/support/test_program.h"

#include <functional>

using namespace dyncal;
using namespace dyncal::testing;

namespace {

using Segment = TdmsSegment;
using Scaler = TdmsWriterScaler;

constexpr const char *kA = "/'group'/'a'";
constexpr const char *kB = "/'group'/'b'";
constexpr std::uint32_t kRaw = 0xFFFFFFFF;

std::string scale(int k, const std::string &name)
{
    return "NI_Scale[" + std::to_string(k) + "]_" + name;
}

/// Adds properties of scales to the object begun last.
class Scales
{
public:
    explicit Scales(Segment &segment)
        : m_segment(segment)
    {
        m_segment.property("NI_Scaling_Status", "unscaled");
    }

    Scales &number(std::uint32_t count)
    {
        m_segment.property("NI_Number_Of_Scales", count);
        return *this;
    }

    Scales &type(int k, const char *name)
    {
        m_segment.property(scale(k, "Scale_Type"), name);
        return *this;
    }

    Scales &linear(int k, double slope, double intercept, std::uint32_t input = kRaw)
    {
        type(k, "Linear");
        m_segment.property(scale(k, "Linear_Slope"), slope);
        m_segment.property(scale(k, "Linear_Y_Intercept"), intercept);
        m_segment.property(scale(k, "Linear_Input_Source"), input);
        return *this;
    }

    Scales &polynomial(int k, const std::vector<double> &coefficients, std::uint32_t input = kRaw)
    {
        type(k, "Polynomial");
        list(scale(k, "Polynomial_Coefficients"), coefficients);
        m_segment.property(scale(k, "Polynomial_Input_Source"), input);
        return *this;
    }

    Scales &table(int k, const std::vector<double> &inputs, const std::vector<double> &outputs,
        std::uint32_t input = kRaw)
    {
        type(k, "Table");
        list(scale(k, "Table_Pre_Scaled_Values"), inputs);
        list(scale(k, "Table_Scaled_Values"), outputs);
        m_segment.property(scale(k, "Table_Input_Source"), input);
        return *this;
    }

    Scales &pair(int k, const char *name, std::uint32_t left, std::uint32_t right)
    {
        type(k, name);
        m_segment.property(scale(k, name + std::string("_Left_Operand_Input_Source")), left);
        m_segment.property(scale(k, name + std::string("_Right_Operand_Input_Source")), right);
        return *this;
    }

private:
    void list(const std::string &name, const std::vector<double> &values)
    {
        m_segment.property(name + "_Size", static_cast<std::uint32_t>(values.size()));
        for (std::size_t i = 0; i < values.size(); ++i)
            m_segment.property(name + "[" + std::to_string(i) + "]", values[i]);
    }

    Segment &m_segment;
};

/// One int16 channel with scales.
std::string scaledFile(
    const std::vector<std::int16_t> &counts, const std::function<void(Scales)> &scales)
{
    Segment segment;
    segment.channel<std::int16_t>(kA, counts.size());
    scales(Scales(segment));
    segment.data().all(counts);
    return segment.bytes();
}

constexpr std::uint32_t kDaqmxSegment
    = Segment::kMetaData | Segment::kNewList | Segment::kRawData | Segment::kDaqmx;

} // namespace

class TestTdmsScales : public QObject
{
    Q_OBJECT

private slots:
    void linear_keepsTheCounts()
    {
        const auto set = m_folder.read(
            scaledFile({-3, 0, 7}, [](Scales s) { s.number(1).linear(0, 0.5, 2.0); }));
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.polynomial, numbers(2.0, 0.5));
        QCOMPARE(channel.samples.type(), SampleType::Int16);
        QCOMPARE(rawValuesOf(channel), numbers(-3, 0, 7));
        QCOMPARE(physicalValuesOf(channel), numbers(0.5, 2.0, 5.5));
    }

    void numberOfScales_absent_isTheHighestIndexPlusOne()
    {
        const auto set = m_folder.read(scaledFile(
            {1}, [](Scales s) { s.linear(0, 2.0, 0.0).linear(10, 3.0, 1.0).linear(2, 5.0, 0.0); }));
        QCOMPARE(set->shots[0].channels[0].polynomial, numbers(1.0, 3.0));
    }

    void polynomial_isTakenOver()
    {
        const auto set = m_folder.read(scaledFile({-2, 0, 3}, [](Scales s) {
            s.number(1).polynomial(0, {1.0, -2.0, 0.25, 0.125});
        }));
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.polynomial, numbers(1.0, -2.0, 0.25, 0.125));
        QCOMPARE(physicalValuesOf(channel), numbers(1 + 4 + 1 - 1, 1, 1 - 6 + 2.25 + 3.375));
    }

    void polynomialOfLinear_becomesOnePolynomialOfTheCounts()
    {
        // 1 + 2 (3 x + 1) + 4 (3 x + 1)^2 = 7 + 30 x + 36 x^2
        const auto set = m_folder.read(scaledFile({-5, 2}, [](Scales s) {
            s.number(2).linear(0, 3.0, 1.0).polynomial(1, {1.0, 2.0, 4.0}, 0);
        }));
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.polynomial, numbers(7, 30, 36));
        QCOMPARE(channel.samples.type(), SampleType::Int16);
        QCOMPARE(physicalValuesOf(channel), numbers(7 - 150 + 900, 7 + 60 + 144));
    }

    void linearOfLinear_isComposedForFloatsToo()
    {
        Segment segment;
        segment.channel<double>(kA, 1);
        Scales(segment).number(2).linear(0, 3.0, 1.0).linear(1, 0.5, -1.0, 0);
        segment.data().add(4.0);
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(set->shots[0].channels[0].polynomial, numbers(-0.5, 1.5));
    }

    void polynomialThatDiffersFromItsChain_isComputedLinkByLink()
    {
        // (y - 1e6)^3 with y = x + 1e6 cancels 18 digits, so the chain gives other values than the
        // x^3 that it stands for; what the file says is the chain.
        const auto set = m_folder.read(scaledFile({-32768, 1, 30000}, [](Scales s) {
            s.number(2).linear(0, 1.0, 1e6).polynomial(1, {-1e18, 3e12, -3e6, 1.0}, 0);
        }));
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.samples.type(), SampleType::Float64);
        QCOMPARE(channel.polynomial, numbers(0, 1));
        const auto chain = [](double x) {
            const double y = x + 1e6;
            return ((y - 3e6) * y + 3e12) * y - 1e18;
        };
        QCOMPARE(rawValuesOf(channel), numbers(chain(-32768), chain(1), chain(30000)));
    }

    void polynomialOfLinear_isComputedForFloats()
    {
        Segment segment;
        segment.channel<double>(kA, 1);
        Scales(segment).number(2).linear(0, 2.0, 1.0).polynomial(1, {0.0, 0.0, 1.0}, 0);
        segment.data().add(3.0);
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(rawValuesOf(set->shots[0].channels[0]), numbers(49));
    }

    void table_interpolatesAndHoldsItsEnds_inBothDirections()
    {
        for (const bool falling : {false, true}) {
            const auto inputs = falling ? numbers(30, 20, 10) : numbers(10, 20, 30);
            const auto outputs = falling ? numbers(8, 4, 2) : numbers(2, 4, 8);
            const auto set = m_folder.read(scaledFile({5, 10, 15, 20, 25, 30, 35},
                [&](Scales s) { s.number(1).table(0, inputs, outputs); }));
            const Channel &channel = set->shots[0].channels[0];
            QCOMPARE(channel.samples.type(), SampleType::Float64);
            QVERIFY(!channel.samples.isInMemory());
            QCOMPARE(physicalValuesOf(channel), numbers(2, 2, 3, 4, 6, 8, 8));
        }
    }

    void addAndSubtract_joinTwoScales()
    {
        // Scale 0: 2 x + 10, scale 1: 3 x; LabVIEW subtracts the left operand from the right one.
        for (const bool add : {true, false}) {
            const auto set = m_folder.read(scaledFile({1, -2}, [&](Scales s) {
                s.number(3).linear(0, 2.0, 10.0).linear(1, 3.0, 0.0);
                s.pair(2, add ? "Add" : "Subtract", 0, 1);
            }));
            QCOMPARE(physicalValuesOf(set->shots[0].channels[0]),
                add ? numbers(15, 0) : numbers(3 - 12, -6 - 6));
        }
    }

    void advancedApi_changesNothing()
    {
        const auto set = m_folder.read(scaledFile(
            {4}, [](Scales s) { s.number(2).linear(0, 2.0, 1.0).type(1, "AdvancedAPI"); }));
        QCOMPARE(physicalValuesOf(set->shots[0].channels[0]), numbers(4));
    }

    void statusScaled_ignoresTheScales()
    {
        Segment segment;
        segment.channel<double>(kA, 1);
        Scales(segment).number(1).linear(0, 2.0, 1.0);
        segment.property("NI_Scaling_Status", "scaled");
        segment.data().add(4.0);
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(physicalValuesOf(set->shots[0].channels[0]), numbers(4));
    }

    void scales_ofGroupAndFile_holdWhereTheChannelHasNone()
    {
        Segment segment;
        segment.object("/");
        Scales(segment).number(1).linear(0, 10.0, 0.0);
        segment.channel<std::int16_t>("/'own'/'p'", 1);
        Scales(segment).number(1).linear(0, 2.0, 0.0);
        segment.object("/'group'");
        Scales(segment).number(1).linear(0, 3.0, 0.0);
        segment.channel<std::int16_t>("/'group'/'q'", 1);
        segment.channel<std::int16_t>("/'other'/'r'", 1);
        segment.data().all<std::int16_t>({1, 1, 1});
        const auto set = m_folder.read(segment.bytes());
        const Shot &shot = set->shots[0];
        QCOMPARE(physicalValuesOf(*channelNamed(shot, "p")), numbers(2));
        QCOMPARE(physicalValuesOf(*channelNamed(shot, "q")), numbers(3));
        QCOMPARE(physicalValuesOf(*channelNamed(shot, "r")), numbers(10));
    }

    void laterProperties_overwrite()
    {
        Segment late(Segment::kMetaData);
        late.object(kA).property(scale(0, "Linear_Slope"), 8.0);
        const auto set = m_folder.read(
            scaledFile({1}, [](Scales s) { s.number(1).linear(0, 2.0, 1.0); }) + late.bytes());
        QCOMPARE(set->shots[0].channels[0].polynomial, numbers(1, 8));
    }

    void scalesThatAreNotApplied_areRefusedByName_data()
    {
        QTest::addColumn<QString>("kind");
        for (const char *kind : {"RTD", "Strain", "Thermistor", "Thermocouple", "Unheard", ""})
            QTest::newRow(kind) << kind;
    }

    void scalesThatAreNotApplied_areRefusedByName()
    {
        QFETCH(QString, kind);
        const std::string name = kind.toStdString();
        const auto set
            = m_folder.read(scaledFile({1}, [&](Scales s) { s.number(1).type(0, name.c_str()); }));
        QVERIFY(!set && contains(sentence(set), "Channel a"));
        QVERIFY(contains(sentence(set), "\"" + name + "\""));
    }

    void refusedChannel_leavesTheOthers()
    {
        Segment segment;
        segment.channel<std::int16_t>(kA, 1);
        Scales(segment).number(1).type(0, "RTD");
        segment.channel<std::int16_t>(kB, 1);
        segment.data().all<std::int16_t>({1, 2});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(set->shots[0].channels.size(), std::size_t{1});
        QCOMPARE(valuesIn(set, "b"), numbers(2));
        const Finding *finding = findingWith(set->findings, "CAP-026");
        QVERIFY(finding != nullptr && finding->severity == Severity::Caution);
        QVERIFY(contains(english(finding->message), "RTD"));
    }

    void brokenScales_areRefused_data()
    {
        QTest::addColumn<int>("which");
        for (int i = 0; i < 12; ++i)
            QTest::addRow("%d", i) << i;
    }

    void brokenScales_areRefused()
    {
        QFETCH(int, which);
        const std::vector<std::function<void(Scales)>> broken{
            [](Scales s) { s.number(1).type(0, "Linear"); },
            [](Scales s) { s.number(1).linear(0, kNan, 0.0); },
            [](Scales s) { s.number(1).linear(0, 1.0, 0.0, 0); },
            [](Scales s) { s.number(1).linear(0, 1.0, 0.0, 5); },
            [](Scales s) { s.number(2).linear(0, 1.0, 0.0, 1).linear(1, 1.0, 0.0, 0); },
            [](Scales s) { s.number(2).linear(1, 1.0, 0.0, 0); },
            [](Scales s) { s.number(4000000000U).linear(0, 1.0, 0.0); },
            [](Scales s) {
                s.number(1).table(0, {1, 3, 2}, {1, 2, 3});
            },
            [](Scales s) {
                s.number(1).table(0, {1, 2}, {1, 2, 3});
            },
            [](Scales s) { s.number(1).table(0, {}, {}); },
            [](Scales s) { s.number(1).polynomial(0, {}); },
            [](Scales s) { s.number(1).type(0, "Add"); },
        };
        const auto set = m_folder.read(scaledFile({1}, broken[static_cast<std::size_t>(which)]));
        QVERIFY(!set.has_value());
        QVERIFY2(contains(sentence(set), " a"), sentence(set).c_str());
        QCOMPARE(findingId(set), std::string("CAP-018"));
    }

    void listLengths_areNotBelieved()
    {
        Segment segment;
        segment.channel<std::int16_t>(kA, 1);
        Scales(segment).number(1).type(0, "Polynomial");
        segment.property(scale(0, "Polynomial_Coefficients_Size"), std::uint32_t{0xFFFFFFF0});
        segment.data().add<std::int16_t>(1);
        QVERIFY(!m_folder.read(segment.bytes()).has_value());
    }

    void manyScalesOnScales_takeNoExponentialTime()
    {
        const auto set = m_folder.read(scaledFile({1}, [](Scales s) {
            s.number(200).linear(0, 1e-60, 0.0);
            for (std::uint32_t k = 1; k < 200; ++k)
                s.pair(static_cast<int>(k), "Add", k - 1, k - 1);
        }));
        QCOMPARE(physicalValuesOf(set->shots[0].channels[0]),
            std::vector<double>{std::ldexp(1e-60, 199)});
    }

    void daqmx_buffersOfOtherWidthsAndLengths()
    {
        // Buffer 0: rows of 6 bytes (a: int16 at 0, b: int32 at 2), 3 rows per chunk. Buffer 1:
        // rows of 4 bytes (c: uint16 at 2), 2 rows.
        Segment segment(kDaqmxSegment);
        const std::vector<std::uint32_t> widths{6, 4};
        segment.object(kA, segment.daqmx(3, {Scaler{3, 0, 0, 0}}, widths));
        segment.object(kB, segment.daqmx(3, {Scaler{5, 0, 2, 0}}, widths));
        segment.object("/'group'/'c'", segment.daqmx(2, {Scaler{2, 1, 2, 0}}, widths));
        for (int chunk = 0; chunk < 2; ++chunk) {
            for (int row = 0; row < 3; ++row) {
                segment.data().add(static_cast<std::int16_t>(-100 * chunk - row));
                segment.data().add(100000 * (chunk + 1) + row);
            }
            for (int row = 0; row < 2; ++row) {
                segment.data().add<std::uint16_t>(9999);
                segment.data().add(static_cast<std::uint16_t>(50000 + 10 * chunk + row));
            }
        }
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(0, -1, -2, -100, -101, -102));
        QCOMPARE(valuesIn(set, "b"), numbers(100000, 100001, 100002, 200000, 200001, 200002));
        QCOMPARE(valuesIn(set, "c"), numbers(50000, 50001, 50010, 50011));
        QCOMPARE(set->shots[0].channels[2].samples.type(), SampleType::UInt16);
        QCOMPARE(set->shots[0].channels[0].unit, std::string("1"));
        QVERIFY(hasFinding(set->findings, "CAP-027")); // counts, and nothing says what they mean
    }

    void daqmx_cutWithinBuffers_keepsWholeRows()
    {
        Segment segment(kDaqmxSegment);
        const std::vector<std::uint32_t> widths{2, 2};
        segment.object(kA, segment.daqmx(3, {Scaler{3, 0, 0, 0}}, widths));
        segment.object(kB, segment.daqmx(3, {Scaler{3, 1, 0, 0}}, widths));
        segment.data().all<std::int16_t>({1, 2, 3, 11, 12, 13, 4, 5, 6, 14});
        const auto set = m_folder.read(segment.bytes(Segment::kUnclosed) + "x");
        QCOMPARE(valuesIn(set, "a"), numbers(1, 2, 3, 4, 5, 6));
        QCOMPARE(valuesIn(set, "b"), numbers(11, 12, 13, 14));
        QVERIFY(hasFinding(set->findings, "CAP-018"));
    }

    void daqmx_scalerAndScale_giveCountsAndPolynomial()
    {
        Segment segment(kDaqmxSegment);
        segment.object(kA, segment.daqmx(2, {Scaler{3, 0, 0, 0}}, {2}));
        Scales(segment).number(2).linear(1, 0.25, 1.0, 0); // scale 0 is the scaler
        segment.property("unit_string", "V");
        segment.data().all<std::int16_t>({-4, 8});
        const auto set = m_folder.read(segment.bytes());
        const Channel &channel = set->shots[0].channels[0];
        QCOMPARE(channel.polynomial, numbers(1.0, 0.25));
        QCOMPARE(rawValuesOf(channel), numbers(-4, 8));
        QCOMPARE(channel.unit, std::string("V"));
        QVERIFY(!hasFinding(set->findings, "CAP-027"));
    }

    void daqmx_twoScalersAdded()
    {
        // Coarse counts (scaler 0) times 256 and fine ones (scaler 7), as two-stage converters
        // have.
        Segment segment(kDaqmxSegment);
        segment.object(kA, segment.daqmx(2, {Scaler{3, 0, 0, 0}, Scaler{0, 1, 0, 7}}, {2, 1}));
        Scales(segment).number(10).linear(8, 256.0, 0.0, 0).pair(9, "Add", 8, 7);
        segment.data().all<std::int16_t>({-1, 2}).all<std::uint8_t>({5, 250});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(physicalValuesOf(set->shots[0].channels[0]), numbers(-251, 762));
    }

    void daqmx_twoScalersWithoutScale_areTwoChannelsOfCounts()
    {
        Segment segment(kDaqmxSegment);
        segment.object(kA, segment.daqmx(2, {Scaler{3, 0, 0, 0}, Scaler{3, 0, 2, 3}}, {4}));
        segment.data().all<std::int16_t>({1, 11, 2, 12});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a (counts 0)"), numbers(1, 2));
        QCOMPARE(valuesIn(set, "a (counts 3)"), numbers(11, 12));
    }

    void daqmx_scaleForUnstatedScaler_isRefused()
    {
        Segment segment(kDaqmxSegment);
        segment.object(kA, segment.daqmx(1, {Scaler{3, 0, 0, 0}, Scaler{3, 0, 2, 3}}, {4}));
        Scales(segment).number(2).linear(1, 1.0, 0.0, kRaw);
        segment.data().all<std::int16_t>({1, 11});
        QVERIFY(!m_folder.read(segment.bytes()).has_value());
        Segment twice(kDaqmxSegment);
        twice.object(kA, twice.daqmx(1, {Scaler{3, 0, 0, 0}, Scaler{3, 0, 2, 0}}, {4}));
        Scales(twice).number(2).linear(1, 1.0, 0.0, 0);
        twice.data().all<std::int16_t>({1, 11});
        QVERIFY(!m_folder.read(twice.bytes()).has_value());
    }

    void daqmx_digitalLines_areBits()
    {
        Segment segment(kDaqmxSegment);
        segment.object(kA, segment.daqmx(3, {Scaler{0, 0, 1, 0}}, {2}, true));
        segment.object(kB, segment.daqmx(3, {Scaler{0, 0, 15, 0}}, {2}, true));
        segment.data().all<std::uint8_t>({0b10, 0x00, 0b00, 0x80, 0b11, 0x7F});
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(1, 0, 1));
        QCOMPARE(valuesIn(set, "b"), numbers(0, 1, 0));
        QCOMPARE(set->shots[0].channels[0].samples.type(), SampleType::UInt8);
        QVERIFY(!hasFinding(set->findings, "CAP-027"));
    }

    void daqmx_typesWithoutSampleType_areExact()
    {
        Segment segment(kDaqmxSegment);
        const std::vector<std::uint32_t> widths{20};
        segment.object(kA, segment.daqmx(1, {Scaler{4, 0, 0, 0}}, widths));
        segment.object(kB, segment.daqmx(1, {Scaler{7, 0, 4, 0}}, widths));
        segment.object("/'group'/'c'", segment.daqmx(1, {Scaler{9, 0, 12, 0}}, widths));
        segment.data().add<std::uint32_t>(4000000000U).add<std::int64_t>(-5).add(0.75);
        const auto set = m_folder.read(segment.bytes());
        QCOMPARE(valuesIn(set, "a"), numbers(4e9));
        QCOMPARE(valuesIn(set, "b"), numbers(-5));
        QCOMPARE(valuesIn(set, "c"), numbers(0.75));
    }

    void daqmx_brokenBuffers_areRefused_data()
    {
        QTest::addColumn<int>("which");
        for (int i = 0; i < 6; ++i)
            QTest::addRow("%d", i) << i;
    }

    void daqmx_brokenBuffers_areRefused()
    {
        QFETCH(int, which);
        Segment s(kDaqmxSegment);
        const auto index
            = [&](const Scaler &scaler, const std::vector<std::uint32_t> &widths,
                  std::uint32_t type = kRaw) { return s.daqmx(1, {scaler}, widths, false, type); };
        const std::vector<std::function<void()>> broken{
            [&] {
                s.object(kA, index({3, 0, 1, 0}, {2}));
            }, // reaches out of its row
            [&] {
                s.object(kA, index({3, 1, 0, 0}, {2}));
            }, // no such buffer
            [&] {
                s.object(kA, index({33, 0, 0, 0}, {2}));
            }, // no such type
            [&] {
                s.object(kA, index({3, 0, 0, 0}, {2}, 6));
            }, // types contradict
            [&] {
                s.object(kA, index({3, 0, 0, 0}, {2}));
                s.object(kB, index({3, 0, 0, 0}, {4})); // widths contradict
            },
            [&] {
                s.object(kA, index({3, 0, 0, 0}, {2}));
                s.channel<std::int16_t>(kB, 1); // mixed with plain data
            },
        };
        broken[static_cast<std::size_t>(which)]();
        s.data().all<std::int16_t>({1, 2, 3, 4});
        const auto set = m_folder.read(s.bytes());
        QVERIFY(!set.has_value());
        QCOMPARE(findingId(set), std::string("CAP-018"));
    }

private:
    TdmsFolder m_folder;
};

DYNCAL_TEST(TestTdmsScales)
#include "tst_tdms_scales.moc"
