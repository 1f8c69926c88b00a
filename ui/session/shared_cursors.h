// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

#include <array>
#include <optional>

namespace dyncal {

/// Plots with the same x share their cursors.
enum class CursorAxis {
    Frequency, ///< spectrum, stabilisation strip, responses
    RecordTime, ///< recordings as they are, of captures and of the shock
    ResponseTime, ///< from each shot's start: window, components, model input, fit
};
inline constexpr int kCursorAxes = 3;

/// Where the two cursors of plots with one kind of x axis stand.
class SharedCursors : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    /// In the axis' SI unit.
    const std::array<std::optional<double>, 2> &positions() const { return m_positions; }
    void place(int which, double x, const QObject *source)
    {
        m_positions[static_cast<std::size_t>(which)] = x;
        emit moved(source);
    }
    void clear(const QObject *source)
    {
        m_positions = {};
        emit moved(source);
    }

signals:
    void moved(const QObject *source); ///< by the view `source`, whose own cursors have moved

private:
    std::array<std::optional<double>, 2> m_positions;
};

} // namespace dyncal
