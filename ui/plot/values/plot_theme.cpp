// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/values/plot_theme.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

struct RoleEntry
{
    CurveRole role;
    const char *light;
    const char *dark;
    Qt::PenStyle dash;
    double width;
    MarkerShape marker;
};

// Contrast on white and on #1E1E1E is at least 3:1 for every entry (tested).
constexpr RoleEntry kRoles[] = {
    {CurveRole::ShotLow, "#0072B2", "#56B4E9", Qt::SolidLine, 1.0, MarkerShape::Circle},
    {CurveRole::ShotMedium, "#009E73", "#009E73", Qt::DashLine, 1.0, MarkerShape::TriangleUp},
    {CurveRole::ShotHigh, "#D55E00", "#E69F00", Qt::DashDotLine, 1.0, MarkerShape::Square},
    {CurveRole::ShotOther, "#555555", "#BBBBBB", Qt::DotLine, 1.0, MarkerShape::Diamond},
    {CurveRole::Mean, "#000000", "#FFFFFF", Qt::SolidLine, 2.0, MarkerShape::None},
    {CurveRole::Measured, "#4477AA", "#66CCEE", Qt::SolidLine, 1.0, MarkerShape::Dot},
    {CurveRole::Model, "#AA3377", "#CC79A7", Qt::DashLine, 2.0, MarkerShape::None},
    {CurveRole::Error, "#D55E00", "#E69F00", Qt::SolidLine, 1.0, MarkerShape::None},
    {CurveRole::Noise, "#767676", "#9A9A9A", Qt::DotLine, 1.0, MarkerShape::None},
    {CurveRole::Reference, "#555555", "#BBBBBB", Qt::DashLine, 1.0, MarkerShape::None},
    {CurveRole::Pole, "#0072B2", "#56B4E9", Qt::SolidLine, 1.6, MarkerShape::Cross},
    {CurveRole::Zero, "#228833", "#CCBB44", Qt::SolidLine, 1.6, MarkerShape::Circle},
    {CurveRole::StepPole, "#555555", "#BBBBBB", Qt::SolidLine, 1.4, MarkerShape::Star},
    {CurveRole::UnstablePole, "#D55E00", "#E69F00", Qt::SolidLine, 1.6, MarkerShape::CrossInBox},
    {CurveRole::Suggestion, "#228833", "#CCBB44", Qt::DashDotDotLine, 1.4,
        MarkerShape::TriangleDown},
    {CurveRole::Candidate1, "#D55E00", "#E69F00", Qt::DashDotLine, 1.6, MarkerShape::TriangleUp},
    {CurveRole::Candidate2, "#228833", "#CCBB44", Qt::DotLine, 2.0, MarkerShape::Square},
    {CurveRole::Candidate3, "#4477AA", "#66CCEE", Qt::DashDotDotLine, 1.6, MarkerShape::Diamond},
    {CurveRole::Candidate4, "#555555", "#BBBBBB", Qt::SolidLine, 1.0, MarkerShape::TriangleDown},
    {CurveRole::StablePole, "#0072B2", "#56B4E9", Qt::SolidLine, 1.6, MarkerShape::Circle},
    {CurveRole::HalfStablePole, "#AA3377", "#CC79A7", Qt::SolidLine, 1.4, MarkerShape::Plus},
    {CurveRole::NewPole, "#767676", "#9A9A9A", Qt::SolidLine, 1.0, MarkerShape::Dot},
};

QColor mixed(const QColor &color, const QColor &other, double share)
{
    const auto channel = [share](int from, int to) {
        return static_cast<int>(std::lround(from + share * (to - from)));
    };
    return {channel(color.red(), other.red()), channel(color.green(), other.green()),
        channel(color.blue(), other.blue())};
}

// Of one role, for variants one after the other: neighbours differ, also beside the role's own.
constexpr Qt::PenStyle kDashes[]
    = {Qt::SolidLine, Qt::DashLine, Qt::DashDotLine, Qt::DotLine, Qt::DashDotDotLine};
constexpr MarkerShape kMarkers[]
    = {MarkerShape::TriangleUp, MarkerShape::Square, MarkerShape::Diamond, MarkerShape::Cross,
        MarkerShape::Plus, MarkerShape::Star, MarkerShape::Circle};

struct ColorPair
{
    const char *light;
    const char *dark;
};
constexpr ColorPair kFurtherShots[] = {{"#555555", "#BBBBBB"}, {"#00707C", "#4DD0E1"},
    {"#8C4A3C", "#E0A890"}, {"#6A3D9A", "#C0A4F0"}, {"#6B6400", "#D6D060"}, {"#B02060", "#F48FB1"}};

} // namespace

PlotTheme lightPlots()
{
    PlotTheme theme;
    theme.background = QColor("#FFFFFF");
    theme.text = QColor("#1A1A1A");
    theme.axis = QColor("#555555");
    theme.grid = QColor("#E0E0E0");
    theme.fineGrid = QColor("#F0F0F0");
    theme.bandFill = QColor("#EDF4FB");
    theme.handle = QColor("#3465A4");
    theme.focus = QColor("#C01060");
    theme.readoutFill = QColor("#FFFFF4");
    return theme;
}

PlotTheme darkPlots()
{
    PlotTheme theme;
    theme.dark = true;
    theme.background = QColor("#1E1E1E");
    theme.text = QColor("#E8E8E8");
    theme.axis = QColor("#A8A8A8");
    theme.grid = QColor("#3A3A3A");
    theme.fineGrid = QColor("#2A2A2A");
    theme.bandFill = QColor("#26364A");
    theme.handle = QColor("#7FB2E5");
    theme.focus = QColor("#FF7FBF");
    theme.readoutFill = QColor("#2A2A22");
    return theme;
}

PlotTheme highContrastPlots()
{
    PlotTheme theme = darkPlots();
    theme.lineScale = 1.5;
    theme.background = QColor("#000000");
    theme.text = QColor("#FFFFFF");
    theme.axis = QColor("#FFFFFF");
    theme.grid = QColor("#4A4A4A");
    theme.fineGrid = QColor("#2C2C2C");
    theme.bandFill = QColor("#102A4C");
    theme.handle = QColor("#FFD84A");
    theme.focus = QColor("#00FFFF");
    theme.readoutFill = QColor("#000000");
    return theme;
}

RoleStyle PlotTheme::style(CurveRole role, int variant) const
{
    const auto entry = std::find_if(std::begin(kRoles), std::end(kRoles),
        [role](const RoleEntry &candidate) { return candidate.role == role; });
    RoleStyle style{
        QColor(dark ? entry->dark : entry->light), entry->dash, entry->width, entry->marker};
    style.width *= lineScale;
    if (variant > 0) {
        const auto at = static_cast<std::size_t>(variant);
        style.dash = kDashes[at % std::size(kDashes)];
        style.marker = kMarkers[at % std::size(kMarkers)];
        if (role == CurveRole::ShotOther) {
            const auto &[light, onDark] = kFurtherShots[at % std::size(kFurtherShots)];
            style.color = QColor(dark ? onDark : light);
        }
    }
    if (fading > 0.0)
        style.color = mixed(style.color, background, fading);
    return style;
}

PlotTheme printTheme()
{
    PlotTheme theme = lightPlots();
    theme.bandFill = QColor("#E4EEF8"); // seen on paper
    theme.font = QFont("DejaVu Sans");
    theme.font.setPixelSize(10);
    // Turns ligatures off, so that the text of a printed plot can be searched.
    theme.font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02);
    return theme;
}

} // namespace dyncal
