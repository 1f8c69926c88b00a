// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <Eigen/Core>

#include <string>

namespace dyncal {

/// A MAT file of version 5 with real and complex matrices of doubles, little endian, not
/// compressed (docs/adr/0012-mat-files.md). The same matrices give the same bytes.
class MatWriter
{
public:
    MatWriter();

    /// `name`: a letter, then letters, digits and underscores, at most 63.
    void add(const std::string &name, const Eigen::MatrixXd &values);
    void add(const std::string &name, const Eigen::MatrixXcd &values);
    void add(const std::string &name, double value);

    const std::string &bytes() const { return m_bytes; }

private:
    void addMatrix(
        const std::string &name, const Eigen::MatrixXd &real, const Eigen::MatrixXd *imaginary);

    std::string m_bytes;
};

} // namespace dyncal
