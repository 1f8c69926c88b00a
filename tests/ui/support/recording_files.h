// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <QFile>
#include <QString>

#include <cmath>
#include <functional>

namespace dyncal::test {

inline void writeFile(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

/// What a text table is made of; the signal is a step at a third of the record.
struct TableText
{
    QString header = "time [s],p [V],side [V]\n";
    QString separator = ",";
    char decimal = '.';
    double step_s = 1e-6;
    bool times = true;
    int columns = 2;
    int rows = 600;
    double scale = 1.0;
};

inline QString tableNumber(double value, char decimal, int digits = 9)
{
    return QString::number(value, 'f', digits).replace('.', decimal);
}

inline QByteArray tableText(const TableText &table)
{
    QString text = table.header;
    for (int row = 0; row < table.rows; ++row) {
        QStringList cells;
        if (table.times)
            cells << tableNumber(row * table.step_s, table.decimal);
        for (int c = 0; c < table.columns; ++c) {
            const double noise = 1e-3 * std::sin(12.9898 * row + 78.2 * c);
            const int start = table.rows / 3 - 20 * c; // the side sensor is reached first
            cells << tableNumber(table.scale * ((row < start ? 0.0 : 1.0) + noise), table.decimal);
        }
        text += cells.join(table.separator) + '\n';
    }
    return text.toUtf8();
}

} // namespace dyncal::test
