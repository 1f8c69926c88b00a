// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ui/plot/qcp/qcp_handles.h"

#include <algorithm>
#include <cmath>

namespace dyncal {

namespace {

constexpr double kReach_px = 10.0;
constexpr int kLabelLift_px = 7; ///< labels stand above the ticks
constexpr int kHandleLabelGap_px = 3;

void placeVertical(QCPItemLine *line, double x)
{
    line->start->setCoords(x, 1.0);
    line->end->setCoords(x, 0.0);
}

/// A line that snaps stands between whole numbers: value n is drawn at n + 1/2 ("keep n").
double drawnAt(const HandleState &state, double value)
{
    return state.snapToIntegers ? value + 0.5 : value;
}

double valueAt(const HandleState &state, double x)
{
    return state.snapToIntegers ? std::round(x - 0.5) : x;
}

} // namespace

PlotHandles::PlotHandles(QCustomPlot &plot)
    : m_plot(plot)
{
    QObject::connect(&plot, &QCustomPlot::beforeReplot, &plot, [this] { placeLabels(); });
}

QCPItemLine *PlotHandles::makeLine()
{
    auto *line = new QCPItemLine(&m_plot);
    for (QCPItemPosition *position : {line->start, line->end}) {
        position->setTypeX(QCPItemPosition::ptPlotCoords);
        position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    line->setSelectable(false);
    return line;
}

PlotHandles::Items PlotHandles::makeItems(const HandleState &state)
{
    Items items;
    if (!state.isLine) {
        items.fill = new QCPItemRect(&m_plot);
        items.fill->setLayer("background");
        items.fill->setSelectable(false);
        for (QCPItemPosition *position : {items.fill->topLeft, items.fill->bottomRight}) {
            position->setTypeX(QCPItemPosition::ptPlotCoords);
            position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        }
        items.end = makeLine();
    }
    items.begin = makeLine();
    items.label = new PlotLabel(&m_plot);
    items.label->setLayer(QStringLiteral("overlay")); // never under the curves
    items.label->position->setTypeX(QCPItemPosition::ptPlotCoords);
    items.label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    items.label->setSelectable(false);
    items.label->setPadding(QMargins(kHandleLabelGap_px, 1, kHandleLabelGap_px, kLabelLift_px));
    return items;
}

void PlotHandles::set(const HandleState &state)
{
    const auto known = std::find_if(m_states.begin(), m_states.end(),
        [&state](const HandleState &other) { return other.id == state.id; });
    if (known != m_states.end() && known->isLine != state.isLine) {
        remove(state.id, known->isLine);
        set(state);
        return;
    }
    auto position = static_cast<std::size_t>(known - m_states.begin());
    if (known == m_states.end()) {
        m_states.push_back(state);
        m_items.push_back(makeItems(state));
        position = m_states.size() - 1;
    } else {
        *known = state;
    }
    place(position);
    paint(position);
}

void PlotHandles::remove(const QString &id, bool isLine)
{
    for (std::size_t i = 0; i < m_states.size(); ++i) {
        if (m_states[i].id != id || m_states[i].isLine != isLine)
            continue;
        const Items items = m_items[i];
        for (QCPAbstractItem *item : std::initializer_list<QCPAbstractItem *>{
                 items.fill, items.begin, items.end, items.label})
            if (item)
                m_plot.removeItem(item);
        m_states.erase(m_states.begin() + static_cast<Index>(i));
        m_items.erase(m_items.begin() + static_cast<Index>(i));
        return;
    }
}

const HandleState *PlotHandles::find(const QString &id) const
{
    const auto known = std::find_if(m_states.begin(), m_states.end(),
        [&id](const HandleState &state) { return state.id == id; });
    return known == m_states.end() ? nullptr : &*known;
}

std::vector<HandleGrip> PlotHandles::grips() const
{
    std::vector<HandleGrip> found;
    for (const HandleState &state : m_states) {
        if (!state.movable)
            continue;
        if (state.isLine) {
            found.push_back({state.id, HandlePart::Whole});
        } else {
            found.push_back({state.id, HandlePart::Begin});
            found.push_back({state.id, HandlePart::End});
        }
    }
    return found;
}

std::optional<HandleGrip> PlotHandles::gripAt(const QPointF &position) const
{
    if (!m_plot.axisRect()->rect().adjusted(-2, -2, 2, 2).contains(position.toPoint()))
        return std::nullopt;
    std::optional<HandleGrip> best;
    double bestDistance = kReach_px;
    for (const HandleGrip &grip : grips()) {
        const double distance
            = std::abs(m_plot.xAxis->coordToPixel(positionOf(grip)) - position.x());
        // A narrow band: the side of the pointer decides which edge it means.
        const bool nearer = distance < bestDistance
            || (best && distance == bestDistance && grip.part == HandlePart::End
                && position.x() > m_plot.xAxis->coordToPixel(positionOf(grip)));
        if (distance <= kReach_px && (nearer || !best)) {
            best = grip;
            bestDistance = distance;
        }
    }
    if (best)
        return best;
    for (std::size_t i = 0; i < m_states.size(); ++i) {
        const double distance = m_items[i].label->selectTest(position, false);
        if (m_states[i].movable && !m_states[i].isLine && distance >= 0.0 && distance <= 1.0)
            return HandleGrip{m_states[i].id, HandlePart::Whole};
    }
    return std::nullopt;
}

HandleState PlotHandles::moved(const HandleState &before, const HandleGrip &grip, double x) const
{
    HandleState after = before;
    const double at = valueAt(before, x);
    if (before.isLine) {
        after.x = {at, at};
    } else if (grip.part == HandlePart::Begin) {
        after.x.begin = std::min(at, before.x.end);
    } else if (grip.part == HandlePart::End) {
        after.x.end = std::max(at, before.x.begin);
    } else {
        after.x = {at, at + before.x.length()};
    }
    return after;
}

double PlotHandles::positionOf(const HandleGrip &grip) const
{
    const HandleState *state = find(grip.id);
    if (!state)
        return 0.0;
    return drawnAt(*state, grip.part == HandlePart::End ? state->x.end : state->x.begin);
}

void PlotHandles::setFocus(const std::optional<HandleGrip> &grip)
{
    m_focus = grip;
    for (std::size_t i = 0; i < m_states.size(); ++i)
        paint(i);
}

void PlotHandles::setTheme(const PlotTheme &theme)
{
    m_theme = theme;
    for (std::size_t i = 0; i < m_states.size(); ++i)
        paint(i);
}

void PlotHandles::place(std::size_t position)
{
    const HandleState &state = m_states[position];
    const Items &items = m_items[position];
    placeVertical(items.begin, drawnAt(state, state.x.begin));
    if (items.end)
        placeVertical(items.end, state.x.end);
    if (items.fill) {
        items.fill->topLeft->setCoords(state.x.begin, 0.0);
        items.fill->bottomRight->setCoords(state.x.end, 1.0);
    }
    items.label->setText(state.label);
    items.label->setVisible(!state.label.isEmpty());
    items.label->position->setCoords(drawnAt(state, state.x.begin), 1.0);
}

/// A label stands right of its line, or left of it where the plot would cut it off; it stands
/// higher where it would cover another.
void PlotHandles::placeLabels()
{
    const QFontMetrics metrics(m_theme.font);
    const QRect axes = m_plot.axisRect()->rect();
    std::vector<QRect> taken;
    for (std::size_t i = 0; i < m_states.size(); ++i) {
        PlotLabel *label = m_items[i].label;
        const double x = m_plot.xAxis->coordToPixel(drawnAt(m_states[i], m_states[i].x.begin));
        label->setVisible(!m_states[i].label.isEmpty());
        if (!label->visible() || !(x >= axes.left() && x <= axes.right()))
            continue;
        const int width = metrics.horizontalAdvance(m_states[i].label) + 2 * kHandleLabelGap_px;
        if (width > axes.width()) { // cut, it would say nothing
            label->setVisible(false);
            continue;
        }
        const bool leftOf = x + width > axes.right() && x - width >= axes.left();
        // Where neither side has room, it stands across its line.
        const bool across = !leftOf && x + width > axes.right();
        const double at = across ? axes.right() - width : x;
        label->position->setCoords(m_plot.xAxis->pixelToCoord(at), 1.0);
        QRect place(static_cast<int>(at) - (leftOf ? width : 0), 0, width, metrics.height());
        while (std::ranges::any_of(taken, [&](const QRect &r) { return r.intersects(place); }))
            place.translate(0, metrics.height());
        taken.push_back(place);
        label->setPositionAlignment((leftOf ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
        label->setPadding(
            QMargins(kHandleLabelGap_px, 1, kHandleLabelGap_px, kLabelLift_px + place.top()));
    }
}

void PlotHandles::paint(std::size_t position)
{
    const HandleState &state = m_states[position];
    const Items &items = m_items[position];
    const bool focused = m_focus && m_focus->id == state.id;
    const auto pen = [&](HandlePart part) {
        const bool on = focused && (m_focus->part == part || m_focus->part == HandlePart::Whole);
        const Qt::PenStyle dash = state.movable ? Qt::SolidLine : Qt::DotLine;
        return QPen(on ? m_theme.focus : m_theme.handle, on ? 3.0 : 1.5, dash);
    };
    items.begin->setPen(pen(state.isLine ? HandlePart::Whole : HandlePart::Begin));
    if (items.end)
        items.end->setPen(pen(HandlePart::End));
    if (items.fill) {
        items.fill->setPen(Qt::NoPen);
        const bool hatched = state.hatched || !state.movable;
        items.fill->setBrush(
            hatched ? QBrush(m_theme.handle, Qt::BDiagPattern) : QBrush(m_theme.bandFill));
    }
    items.label->setColor(m_theme.text);
    items.label->setRim(m_theme.background);
    items.label->setFont(m_theme.font);
}

} // namespace dyncal
