// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QObject>

#include <array>
#include <optional>

namespace dyncal {

/// Where the two cursors of the frequency views stand: spectrum, stabilisation strip and responses
/// share them.
class FrequencyCursors : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    const std::array<std::optional<double>, 2> &positions_Hz() const { return m_positions_Hz; }
    void place(int which, double frequency_Hz, const QObject *source)
    {
        m_positions_Hz[static_cast<std::size_t>(which)] = frequency_Hz;
        emit moved(source);
    }
    void clear(const QObject *source)
    {
        m_positions_Hz = {};
        emit moved(source);
    }

signals:
    void moved(const QObject *source); ///< by the view `source`, whose own cursors have moved

private:
    std::array<std::optional<double>, 2> m_positions_Hz;
};

} // namespace dyncal
