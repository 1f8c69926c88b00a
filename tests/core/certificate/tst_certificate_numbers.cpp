// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate read back by a parser of its own: every number must be the computed one to half
// its last digit, in the unit that stands behind it.

#include "core/base/constants.h"
#include "core/certificate/certificate.h"
#include "tests/support/certificate_text.h"
#include "tests/support/example_results.h"
#include "tests/support/test_program.h"
#include "tests/support/trial_count.h"
#include "tests/support/writable_result.h"

#include <QRegularExpression>
#include <QtTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace dyncal;

using dyncal::testing::writable;

namespace {

constexpr double kRounding = 1e-9; ///< of half a digit, for ties that binary numbers miss

/// A number as a reader of the page takes it.
struct Read
{
    double value = std::numeric_limits<double>::quiet_NaN();
    double digit = 0.0; ///< one unit of its last digit
    qsizetype digits = 0; ///< without leading zeros
    qsizetype zeros = 0; ///< before a point that is not there
};

double prefixOf(const QString &symbol, bool &known)
{
    static const QList<std::pair<QString, double>> kPrefixes{{"f", 1e-15}, {"p", 1e-12},
        {"n", 1e-9}, {QString::fromUtf8("µ"), 1e-6}, {"m", 1e-3}, {"", 1.0}, {"k", 1e3}, {"M", 1e6},
        {"G", 1e9}};
    for (const auto &[prefix, factor] : kPrefixes) {
        if (prefix == symbol)
            return factor;
    }
    static const QRegularExpression power(QString::fromUtf8("^×10\\^(-?\\d+) ?$"));
    const QRegularExpressionMatch match = power.match(symbol);
    known = match.hasMatch();
    return known ? std::pow(10.0, match.captured(1).toInt()) : 0.0;
}

/// "2.3301 MHz" in Hz; a NaN if it is no such thing.
Read readIn(const QString &unit, const QString &cell)
{
    static const QRegularExpression form("^(-?)(\\d+)(?:\\.(\\d+))?(?: (.*))?$");
    const QRegularExpressionMatch match = form.match(cell);
    if (!match.hasMatch() || !match.captured(4).endsWith(unit))
        return {};
    bool known = true;
    const double factor = prefixOf(match.captured(4).chopped(unit.size()), known);
    if (!known)
        return {};
    const QString digits = match.captured(2) + match.captured(3);
    Read read;
    read.digit = factor * std::pow(10.0, -static_cast<double>(match.captured(3).size()));
    read.value = (match.captured(1).isEmpty() ? 1.0 : -1.0) * digits.toDouble() * read.digit;
    qsizetype zeros = 0;
    while (zeros < digits.size() && digits[zeros] == '0')
        ++zeros;
    read.digits = digits.size() - zeros;
    while (match.captured(3).isEmpty() && read.zeros < read.digits
        && digits[digits.size() - 1 - read.zeros] == '0')
        ++read.zeros;
    return read;
}

bool isHalfADigitFrom(const Read &read, double value)
{
    return std::abs(read.value - value) <= (0.5 + kRounding) * read.digit + 1e-14 * std::abs(value);
}

QString cellOf(const CertificateTable &table, std::size_t row, std::size_t column)
{
    return QString::fromStdString(english(table.rows.at(row).at(column)));
}

/// What is wrong with a value and the U beside it; empty if nothing is.
QString fault(
    const QString &unit, const QString &cell, double value, const QString &uCell, double u)
{
    Read read = readIn(unit, cell);
    Read readU = readIn(unit, uCell);
    // "30" of a U of two digits may be 30 +- 5: then the value ends with tens, too.
    for (; readU.digits > 2 && readU.zeros > 0; --readU.zeros) {
        --readU.digits;
        readU.digit *= 10.0;
        read.digit *= 10.0;
    }
    if (!isHalfADigitFrom(read, value))
        return QString("%1 for %2").arg(cell).arg(value, 0, 'g', 17);
    if (!isHalfADigitFrom(readU, u) || readU.digits != 2)
        return QString("U %1 for %2").arg(uCell).arg(u, 0, 'g', 17);
    if (std::abs(read.digit / readU.digit - 1.0) > kRounding)
        return QString("%1 beside U %2").arg(cell, uCell);
    return {};
}

class Random
{
public:
    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<>(low, high)(m_random);
    }
    double decades(double low, double high) { return std::pow(10.0, uniform(low, high)); }

private:
    std::mt19937_64 m_random{21};
};

} // namespace

class TestCertificateNumbers : public QObject
{
    Q_OBJECT

private slots:
    void frequencyResponse_everyCell_isItsNumber();
    void poles_everyCell_isItsNumber();
    void resonance_withItsFactor_isValueAndHalfWidth();
    void frequencies_closeTogether_stayApart();
};

void TestCertificateNumbers::frequencyResponse_everyCell_isItsNumber()
{
    Random random;
    CalibrationResults results = example::calibration();
    ResponseResult &response = writable(results.response);
    const Index rows = response.frequency_Hz.size();
    response.fLow_Hz = 1.0; // every row lies in the band
    response.fHigh_Hz = response.modelLimit_Hz = 1e7;
    for (int trial = 0; trial < trials::count(200, 20000); ++trial) {
        response.unit = trial % 3 == 0 ? "1" : trial % 3 == 1 ? "V/Pa" : "bar/Pa";
        for (Index i = 0; i < rows; ++i) {
            response.frequency_Hz[i] = random.decades(0.0, 7.0);
            response.magnitude[i] = random.decades(-12.0, 3.0);
            response.u_magnitude[i] = response.magnitude[i] * random.decades(-7.0, 0.5);
            response.phase_rad[i] = random.uniform(-40.0, 4.0);
            response.u_phase_rad[i] = random.decades(-8.0, 1.0);
            response.modelMagnitude[i] = response.magnitude[i] * random.uniform(0.5, 2.0);
            response.modelPhase_rad[i] = random.uniform(-40.0, 4.0);
        }
        results.uncertainty = example::uncertaintyOf(results);
        const CertificateData data = makeCertificate(results, {}, "2026-11-21T03:04:05Z");
        const CertificateTable &table = data.section("frequency-response")->tables.at(0);
        QCOMPARE(table.rows.size(), static_cast<std::size_t>(rows));
        const QString unit
            = response.unit == "1" ? QString() : QString::fromStdString(response.unit);
        constexpr double kDegrees = 180.0 / std::numbers::pi;
        for (Index i = 0; i < rows; ++i) {
            const auto cell
                = [&](std::size_t k) { return cellOf(table, static_cast<std::size_t>(i), k); };
            QVERIFY2(isHalfADigitFrom(readIn("Hz", cell(0)), response.frequency_Hz[i]),
                qPrintable(cell(0)));
            for (const auto &[value, u, at, in] :
                {std::tuple{
                     response.magnitude[i], 2.0 * response.u_magnitude[i], std::size_t(1), unit},
                    {kDegrees * response.phase_rad[i], 2.0 * kDegrees * response.u_phase_rad[i], 3,
                        QString::fromUtf8("°")}}) {
                const QString wrong = fault(in, cell(at), value, cell(at + 1), u);
                QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            }
        }
    }
}

void TestCertificateNumbers::poles_everyCell_isItsNumber()
{
    Random random;
    CalibrationResults results = example::calibration();
    for (int trial = 0; trial < trials::count(300, 30000); ++trial) {
        std::vector<Pole> poles = polesOf(*results.model, results.assessment.get());
        Pole &pole = poles.at(0);
        const double radius = random.uniform(0.0, 1.2);
        pole.z = std::polar(radius, random.uniform(0.0, std::numbers::pi));
        pole.frequency_Hz = random.decades(2.0, 7.0);
        pole.u_frequency_Hz = pole.frequency_Hz * random.decades(-8.0, 0.3);
        pole.dampingRatio = random.uniform(-0.01, 1.0);
        pole.u_dampingRatio = std::abs(pole.dampingRatio) * random.decades(-6.0, 1.0);
        pole.amplitude = random.decades(-6.0, 6.0);
        pole.coverageFactor = trial % 2 == 0 ? 2.0 : random.uniform(2.01, 13.0);
        writable(results.model).poles = poles;
        if (results.assessment)
            writable(results.assessment).poles = poles;
        results.uncertainty = example::uncertaintyOf(results);
        const CertificateData data = makeCertificate(results, {}, "2026-11-21T03:04:05Z");
        const CertificateTable &table = data.section("model")->tables.at(0);
        const auto cell = [&](std::size_t k) { return cellOf(table, 0, k); };
        const QStringList z = cell(1).split(QString::fromUtf8(" ± j"));
        QVERIFY(z.size() == 2 && isHalfADigitFrom(readIn({}, z[0]), pole.z.real())
            && isHalfADigitFrom(readIn({}, z[1]), pole.z.imag()));
        const double k = pole.coverageFactor;
        const QString factor = k == 2.0 ? QString() : QString(" (k = %1)").arg(k, 0, 'f', 2);
        for (const std::size_t at : {3U, 5U})
            QVERIFY2(cell(at).endsWith(factor), qPrintable(cell(at)));
        const QString ofFrequency = fault("Hz", cell(2), pole.frequency_Hz,
            cell(3).chopped(factor.size()), k * pole.u_frequency_Hz);
        QVERIFY2(ofFrequency.isEmpty(), qPrintable(ofFrequency));
        const QString ofDamping = fault({}, cell(4), pole.dampingRatio,
            cell(5).chopped(factor.size()), k * pole.u_dampingRatio);
        QVERIFY2(ofDamping.isEmpty(), qPrintable(ofDamping));
        Read amplitude = readIn({}, cell(6)); // has no u: three digits
        QVERIFY(amplitude.digits >= 3);
        amplitude.digit *= std::pow(10.0, static_cast<double>(amplitude.digits - 3));
        QVERIFY2(isHalfADigitFrom(amplitude, pole.amplitude), qPrintable(cell(6)));
    }
}

void TestCertificateNumbers::resonance_withItsFactor_isValueAndHalfWidth()
{
    Random random;
    CalibrationResults results = example::calibration();
    const Pole main = *mainPole(*results.model, results.assessment.get());
    static const QRegularExpression form("^(.*) \\| (.*) \\| ([0-9.]+)$");
    for (int trial = 0; trial < trials::count(300, 30000); ++trial) {
        std::vector<Pole> poles = polesOf(*results.model, results.assessment.get());
        const double u_Hz = main.frequency_Hz * random.decades(-8.0, -0.5);
        const double factor = trial % 2 == 0 ? 2.0 : random.uniform(2.01, 13.0);
        for (Pole &pole : poles) {
            pole.u_frequency_Hz = u_Hz;
            pole.coverageFactor = factor;
        }
        writable(results.model).poles = poles;
        if (results.assessment)
            writable(results.assessment).poles = poles;
        results.uncertainty = example::uncertaintyOf(results);
        const CertificateData data = makeCertificate(results, {}, "2026-11-21T03:04:05Z");
        const std::string text = testing::keyResult(data, "Undamped natural frequency");
        const QRegularExpressionMatch match = form.match(QString::fromStdString(text));
        QVERIFY2(match.hasMatch(), text.c_str());
        const QString wrong
            = fault("Hz", match.captured(1), main.frequency_Hz, match.captured(2), factor * u_Hz);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(std::abs(match.captured(3).toDouble() - factor) <= 0.005 + kRounding);
    }
}

void TestCertificateNumbers::frequencies_closeTogether_stayApart()
{
    CalibrationResults results = example::calibration();
    ResponseResult &response = writable(results.response);
    const Index rows = response.frequency_Hz.size();
    for (const double step_Hz : {1e3, 10.0, 0.5}) {
        for (Index i = 0; i < rows; ++i)
            response.frequency_Hz[i] = 2.33e6 + step_Hz * static_cast<double>(i);
        results.uncertainty = example::uncertaintyOf(results);
        const CertificateData data = makeCertificate(results, {}, "2026-11-21T03:04:05Z");
        const CertificateTable &table = data.section("frequency-response")->tables.at(0);
        for (std::size_t i = 1; i < table.rows.size(); ++i)
            QVERIFY2(
                cellOf(table, i, 0) != cellOf(table, i - 1, 0), qPrintable(cellOf(table, i, 0)));
    }
}

DYNCAL_TEST(TestCertificateNumbers)
#include "tst_certificate_numbers.moc"
