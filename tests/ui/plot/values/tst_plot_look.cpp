// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/support/test_program.h"
#include "ui/plot/curves/curve_building.h"
#include "ui/plot/qcp/qcp_ticker.h"
#include "ui/plot/values/axis_prefix.h"
#include "ui/plot/values/theme.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using dyncal::axisLabel;
using dyncal::AxisPrefix;
using dyncal::axisPrefix;
using dyncal::CurveRole;
using dyncal::PlotTheme;
using dyncal::powerOfTen;
using dyncal::ThemeKind;
using dyncal::valueWithUnit;

namespace {

double linear(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor &color)
{
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF())
        + 0.0722 * linear(color.blueF());
}

/// WCAG 2 contrast ratio of two opaque colours, 1..21.
double contrastRatio(const QColor &a, const QColor &b)
{
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

/// How a colour looks to an eye without green receptors: Machado, Oliveira and Fernandes, IEEE
/// Trans. Vis. Comput. Graph. 15 (2009) 1291, deuteranomaly of severity 1, in linear light.
QColor withoutGreen(const QColor &color)
{
    constexpr double kMatrix[3][3] = {{0.367322, 0.860646, -0.227968},
        {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
    const double light[3] = {linear(color.redF()), linear(color.greenF()), linear(color.blueF())};
    double seen[3];
    for (int i = 0; i < 3; ++i) {
        const double sum
            = kMatrix[i][0] * light[0] + kMatrix[i][1] * light[1] + kMatrix[i][2] * light[2];
        const double inside = std::clamp(sum, 0.0, 1.0);
        seen[i]
            = inside <= 0.0031308 ? 12.92 * inside : 1.055 * std::pow(inside, 1.0 / 2.4) - 0.055;
    }
    return QColor::fromRgbF(
        static_cast<float>(seen[0]), static_cast<float>(seen[1]), static_cast<float>(seen[2]));
}

constexpr std::array<CurveRole, 22> kRoles{CurveRole::ShotLow, CurveRole::ShotMedium,
    CurveRole::ShotHigh, CurveRole::ShotOther, CurveRole::Mean, CurveRole::Measured,
    CurveRole::Model, CurveRole::Error, CurveRole::Noise, CurveRole::Reference, CurveRole::Pole,
    CurveRole::Zero, CurveRole::StepPole, CurveRole::UnstablePole, CurveRole::Suggestion,
    CurveRole::Candidate1, CurveRole::Candidate2, CurveRole::Candidate3, CurveRole::Candidate4,
    CurveRole::StablePole, CurveRole::HalfStablePole, CurveRole::NewPole};

/// The kind of plot that a role belongs to: curves, the map of poles, their stabilisation.
int plotOf(CurveRole role)
{
    switch (role) {
    case CurveRole::Pole:
    case CurveRole::Zero:
    case CurveRole::StepPole:
    case CurveRole::UnstablePole:
        return 1;
    case CurveRole::StablePole:
    case CurveRole::HalfStablePole:
    case CurveRole::NewPole:
        return 2;
    default:
        return 0;
    }
}

constexpr int kMostShots = 22;

PlotTheme darkTheme()
{
    QPalette palette;
    palette.setColor(QPalette::Window, QColor("#202020"));
    return dyncal::screenTheme(palette, QFont());
}

} // namespace

class TestPlotLook : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void prefix_ofRange_readsOneToThousand_data();
    void prefix_ofRange_readsOneToThousand();
    void prefix_ofDecades_isThatOfTheirMiddle();
    void ticks_ofALowPlot_areTwoAtLeast();
    void label_withAndWithoutUnit_isWritten();
    void power_ofTen_usesSuperscripts();
    void value_withUnit_hasDigitsAskedFor();
    void theme_everyRole_contrastsAtLeastThreeToOne();
    void theme_everyRole_contrastsWithBands();
    void theme_withoutGreen_contrastsAndIsToldApart();
    void theme_textAndFocus_contrastEnough();
    void theme_palette_contrastsEnough();
    void shots_neighbours_differ();
    void theme_shots_differInDashAndMarker();
    void theme_candidates_differInDashAndMarker();
    void theme_stability_differsInMarker();
    void contrast_blackOnWhite_isTwentyOne();
};

void TestPlotLook::prefix_ofRange_readsOneToThousand_data()
{
    QTest::addColumn<double>("lower");
    QTest::addColumn<double>("upper");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<double>("factor");
    QTest::addColumn<QString>("symbol");
    const auto row = [](const char *name, double lower, double upper, const char *unit,
                         double factor, const char *symbol) {
        QTest::newRow(name) << lower << upper << QString::fromUtf8(unit) << factor
                            << QString::fromUtf8(symbol);
    };
    row("micro", 0.0, 20e-6, "s", 1e-6, "µ");
    row("milli", -2e-4, 1.5e-3, "s", 1e-3, "m");
    row("negative end decides", -1.5e-3, 2e-4, "s", 1e-3, "m");
    row("just thousand", 0.0, 1e-3, "s", 1e-3, "m");
    row("mega", 1e3, 50e6, "Hz", 1e6, "M");
    row("beyond giga", 0.0, 5e13, "Hz", 1e9, "G");
    row("below femto", 0.0, 5e-18, "V", 1e-15, "f");
    row("zero range", 0.0, 0.0, "s", 1.0, "");
    row("decibel", -120.0, 1e6, "dB re 1/Hz", 1.0, "");
    row("kPa of a file", 0.0, 5000.0, "kPa", 1.0, "");
    row("plain number", 0.0, 1.6, "", 1.0, "");
    row("small plain number", 0.0, 2e-4, "", 1e-6, "10⁻⁶");
    row("large kPa", 0.0, 5e6, "kPa", 1e6, "10⁶ ");
    row("not finite", 0.0, std::numeric_limits<double>::infinity(), "s", 1.0, "");
}

void TestPlotLook::prefix_ofRange_readsOneToThousand()
{
    QFETCH(double, lower);
    QFETCH(double, upper);
    QFETCH(QString, unit);
    QFETCH(double, factor);
    const AxisPrefix prefix = axisPrefix(lower, upper, unit);
    constexpr double kRounding = 1e-12; // of pow(10, n)
    QVERIFY(std::abs(prefix.factor / factor - 1.0) < kRounding);
    QTEST(prefix.symbol, "symbol");
}

void TestPlotLook::prefix_ofDecades_isThatOfTheirMiddle()
{
    QCOMPARE(dyncal::decadePrefix(1e3, 1e7, "Hz").symbol, QString("k"));
    QCOMPARE(dyncal::decadePrefix(2e6, 9e6, "Hz").symbol, QString("M"));
    QCOMPARE(dyncal::decadePrefix(1e-6, 1e-4, "V/Pa").symbol, QString("µ"));
    for (const AxisPrefix &none : {dyncal::decadePrefix(1e-9, 1e-3, "V²/Hz"),
             dyncal::decadePrefix(0.0, 1e6, "Hz"), dyncal::decadePrefix(1e3, HUGE_VAL, "Hz")})
        QCOMPARE(none, AxisPrefix());
}

void TestPlotLook::label_withAndWithoutUnit_isWritten()
{
    QCOMPARE(axisLabel("Time", "s", {1e-6, "µ"}), QString("Time / µs"));
    QCOMPARE(axisLabel("Lag", "", {}), QString("Lag"));
    QCOMPARE(axisLabel("Error", "", axisPrefix(0, 2e-4, "")), QString::fromUtf8("Error / 10⁻⁶"));
}

void TestPlotLook::power_ofTen_usesSuperscripts()
{
    QCOMPARE(powerOfTen(-13), QString::fromUtf8("10⁻¹³"));
    QCOMPARE(powerOfTen(0), QString::fromUtf8("10⁰"));
}

void TestPlotLook::value_withUnit_hasDigitsAskedFor()
{
    const QString gap(QChar(0x202F));
    QCOMPARE(valueWithUnit(2.33e6, "Hz", 4), "2.330" + gap + "MHz");
    QCOMPARE(valueWithUnit(-5e-7, "s", 3), "-500" + gap + "ns");
    QCOMPARE(valueWithUnit(0.0, "V", 3), "0.00" + gap + "V");
    QCOMPARE(valueWithUnit(123456.0, "", 3), QString("123456"));
    QCOMPARE(valueWithUnit(1e-9, "", 3), QString("1.00e-09"));
    QCOMPARE(valueWithUnit(std::nan(""), "V", 3), QString::fromUtf8("–"));
}

void TestPlotLook::theme_everyRole_contrastsAtLeastThreeToOne()
{
    for (const PlotTheme &theme :
        {dyncal::printTheme(), darkTheme(), dyncal::lightPlots(), dyncal::highContrastPlots()})
        for (const CurveRole role : kRoles) {
            for (int variant = 0; variant <= kMostShots; ++variant) {
                const QColor color = theme.style(role, variant).color;
                const double ratio = contrastRatio(color, theme.background);
                QVERIFY2(ratio >= 3.0,
                    qPrintable(QString("role %1: %2").arg(static_cast<int>(role)).arg(ratio)));
            }
        }
}

/// Curves run through the bands of handles and levels, too.
void TestPlotLook::theme_everyRole_contrastsWithBands()
{
    for (const ThemeKind kind : dyncal::kThemeKinds) {
        const PlotTheme theme = dyncal::themeOf(kind).plots;
        for (const CurveRole role : kRoles)
            QVERIFY2(contrastRatio(theme.style(role).color, theme.bandFill) >= 3.0,
                qPrintable(QString::number(static_cast<int>(role))));
    }
}

/// An eye that tells no red from green sees every curve, and tells any two apart by dash, marker or
/// width.
void TestPlotLook::theme_withoutGreen_contrastsAndIsToldApart()
{
    for (const ThemeKind kind : dyncal::kThemeKinds) {
        const PlotTheme theme = dyncal::themeOf(kind).plots;
        for (const CurveRole role : kRoles) {
            const dyncal::RoleStyle style = theme.style(role);
            const QString name
                = QString("%1, role %2").arg(dyncal::themeName(kind)).arg(static_cast<int>(role));
            const double ratio
                = contrastRatio(withoutGreen(style.color), withoutGreen(theme.background));
            QVERIFY2(ratio >= 3.0, qPrintable(name + QString(": %1").arg(ratio)));
            for (const CurveRole other : kRoles) {
                const dyncal::RoleStyle its = theme.style(other);
                QVERIFY2(other == role || plotOf(other) != plotOf(role) || its.dash != style.dash
                        || its.marker != style.marker || its.width != style.width,
                    qPrintable(name + QString(" and %1").arg(static_cast<int>(other))));
            }
        }
        QCOMPARE(withoutGreen(Qt::white).name(), QString("#ffffff"));
        QVERIFY(contrastRatio(withoutGreen(theme.text), withoutGreen(theme.background)) >= 4.5);
        QVERIFY(contrastRatio(withoutGreen(theme.focus), withoutGreen(theme.background)) >= 3.0);
    }
}

void TestPlotLook::theme_textAndFocus_contrastEnough()
{
    for (const PlotTheme &theme :
        {dyncal::printTheme(), darkTheme(), dyncal::lightPlots(), dyncal::highContrastPlots()}) {
        QVERIFY(contrastRatio(theme.text, theme.background) >= 4.5);
        QVERIFY(contrastRatio(theme.text, theme.bandFill) >= 4.5);
        QVERIFY(contrastRatio(theme.text, theme.readoutFill) >= 4.5);
        QVERIFY(contrastRatio(theme.handle, theme.background) >= 3.0);
        QVERIFY(contrastRatio(theme.handle, theme.bandFill) >= 3.0);
        QVERIFY(contrastRatio(theme.focus, theme.background) >= 3.0);
        for (const QColor &color : {theme.background, theme.bandFill, theme.grid, theme.handle})
            QCOMPARE(color.alpha(), 255);
    }
    QVERIFY(darkTheme().dark);
    QVERIFY(!dyncal::printTheme().dark);
}

/// The window's own colours: text of every state on every ground it stands on, and outlines.
void TestPlotLook::theme_palette_contrastsEnough()
{
    for (const ThemeKind kind : dyncal::kThemeKinds) {
        const dyncal::Theme theme = dyncal::themeOf(kind);
        const QPalette &palette = theme.palette;
        const auto check = [&](QPalette::ColorGroup group, QPalette::ColorRole text,
                               QPalette::ColorRole ground, double least) {
            const double ratio
                = contrastRatio(palette.color(group, text), palette.color(group, ground));
            QVERIFY2(ratio >= least,
                qPrintable(QString("%1: role %2 on %3: %4")
                               .arg(dyncal::themeName(kind))
                               .arg(text)
                               .arg(ground)
                               .arg(ratio)));
        };
        for (const auto group : {QPalette::Active, QPalette::Inactive}) {
            for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase}) {
                check(group, QPalette::WindowText, ground, 4.5);
                check(group, QPalette::Text, ground, 4.5);
                check(group, QPalette::Link, ground, 4.5);
                check(group, QPalette::PlaceholderText, ground, 4.5);
            }
            check(group, QPalette::ButtonText, QPalette::Button, 4.5);
            check(group, QPalette::HighlightedText, QPalette::Highlight, 4.5);
            check(group, QPalette::ToolTipText, QPalette::ToolTipBase, 4.5);
        }
        for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::Button}) {
            check(QPalette::Disabled, QPalette::Text, ground, 3.0);
            check(QPalette::Disabled, QPalette::WindowText, ground, 3.0);
            QVERIFY(contrastRatio(theme.outline, palette.color(ground)) >= 3.0);
        }
        QCOMPARE(dyncal::themeKindOf(palette), kind);
        QCOMPARE(dyncal::themeKindFromName(dyncal::themeName(kind)), kind);
    }
}

/// 22 shots, with and without levels in any order: neighbours differ in marker too, so that no
/// pair rests on colour.
void TestPlotLook::shots_neighbours_differ()
{
    using dyncal::ShotLevel;
    constexpr std::array kLevels{
        ShotLevel::None, ShotLevel::Low, ShotLevel::Medium, ShotLevel::High};
    const PlotTheme theme = dyncal::printTheme();
    for (dyncal::Index shot = 1; shot < kMostShots; ++shot)
        for (const ShotLevel level : kLevels)
            for (const ShotLevel next : kLevels) {
                const dyncal::ShotStyle a = dyncal::shotStyle(shot, level);
                const dyncal::ShotStyle b = dyncal::shotStyle(shot + 1, next);
                const dyncal::RoleStyle one = theme.style(a.role, a.variant);
                const dyncal::RoleStyle other = theme.style(b.role, b.variant);
                QVERIFY2(one.color != other.color || one.dash != other.dash
                        || one.marker != other.marker,
                    qPrintable(a.name + ", " + b.name));
                if (level == next) {
                    QVERIFY2(one.marker != other.marker, qPrintable(a.name + ", " + b.name));
                }
            }
}

void TestPlotLook::theme_shots_differInDashAndMarker()
{
    const PlotTheme theme = dyncal::printTheme();
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            QVERIFY(theme.style(kRoles[i]).dash != theme.style(kRoles[j]).dash);
            QVERIFY(theme.style(kRoles[i]).marker != theme.style(kRoles[j]).marker);
        }
}

void TestPlotLook::theme_candidates_differInDashAndMarker()
{
    const PlotTheme theme = dyncal::printTheme();
    const CurveRole candidates[] = {
        CurveRole::Candidate1, CurveRole::Candidate2, CurveRole::Candidate3, CurveRole::Candidate4};
    for (const CurveRole a : candidates) {
        QVERIFY(theme.style(a).dash != theme.style(CurveRole::Model).dash);
        for (const CurveRole b : candidates) {
            if (a == b)
                continue;
            QVERIFY(theme.style(a).dash != theme.style(b).dash);
            QVERIFY(theme.style(a).marker != theme.style(b).marker);
        }
    }
}

/// Of the stabilisation strip, also without any colour.
void TestPlotLook::theme_stability_differsInMarker()
{
    const PlotTheme theme = dyncal::printTheme();
    const CurveRole classes[] = {CurveRole::StablePole, CurveRole::HalfStablePole,
        CurveRole::NewPole, CurveRole::UnstablePole};
    for (const CurveRole a : classes)
        for (const CurveRole b : classes)
            QVERIFY(a == b || theme.style(a).marker != theme.style(b).marker);
}

/// One number alone says nothing of the scale.
void TestPlotLook::ticks_ofALowPlot_areTwoAtLeast()
{
    dyncal::PrefixTicker ticker({"Error", "V"});
    for (const int wanted : {2, 3, 5}) {
        ticker.setTickCount(wanted);
        for (double size = 1e-3; size < 20.0; size *= 1.01)
            for (const double lower : {-0.5 * size, -0.7 * size, 0.013, 1.0, -7.3}) {
                QVector<double> ticks;
                QVector<QString> labels;
                const QCPRange range(lower, lower + size);
                ticker.generate(range, QLocale::c(), 'g', 6, ticks, nullptr, &labels);
                const auto seen = std::ranges::count_if(
                    ticks, [&](double tick) { return range.contains(tick); });
                QVERIFY2(seen >= 2 && seen <= 12,
                    qPrintable(QString("%1 + %2: %3").arg(lower).arg(size).arg(seen)));
            }
        QCOMPARE(ticker.tickCount(), wanted);
    }
}

void TestPlotLook::contrast_blackOnWhite_isTwentyOne()
{
    QVERIFY(std::abs(contrastRatio(Qt::black, Qt::white) - 21.0) < 1e-9);
    // WCAG's own example: #767676 is the lightest grey that reaches 4.5 on white.
    QVERIFY(contrastRatio(QColor("#767676"), Qt::white) >= 4.5);
    QVERIFY(contrastRatio(QColor("#777777"), Qt::white) < 4.5);
}

DYNCAL_TEST(TestPlotLook)
#include "tst_plot_look.moc"
