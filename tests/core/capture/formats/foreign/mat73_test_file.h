// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/hdf5/hdf5_test_file.h"

#include <QByteArray>
#include <QFile>

#include <algorithm>

namespace dyncal::testing::mat73 {

/// Writes variables as MATLAB does: dimensions in reverse, MATLAB_class on each.
class MatFile
{
public:
    explicit MatFile(const std::string &path)
        : m_file(path, 512)
    {
    }

    const Hdf5TestFile &hdf5() const { return m_file; }

    /// An N x k matrix, column by column as MATLAB keeps it.
    void matrix(const std::string &name, hsize_t rows, hsize_t columns,
        const std::vector<double> &values, const std::string &matlabClass = "double",
        hid_t type = -1, bool packed = false) const
    {
        StoredAs as{type < 0 ? H5T_IEEE_F64LE : type, {}};
        if (packed) {
            as.chunk = {std::max<hsize_t>(columns / 2, 1), std::max<hsize_t>(rows / 3, 1)};
            as.deflate = 3;
        }
        m_file.dataset('/' + name, {columns, rows}, as, H5T_NATIVE_DOUBLE, values.data());
        m_file.text('/' + name, "MATLAB_class", matlabClass);
    }

private:
    Hdf5TestFile m_file;
};

/// The text that MATLAB puts into the user block.
inline void writeHead(const std::string &path)
{
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadWrite))
        qFatal("cannot write the user block");
    QByteArray head(
        "MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Mon Jan  1 00:00:00 2024 HDF5 schema 1.00 .");
    head = head.leftJustified(124, ' ');
    head.append("\0\2IM", 4);
    file.write(head);
}

} // namespace dyncal::testing::mat73
