// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/results/mat_writer.h"

#include "core/base/version.h"

#include <bit>
#include <cstdint>

namespace dyncal {
namespace {

// Numbers of the format (MathWorks, "MAT-File Format", version 5).
constexpr std::uint32_t kInt8 = 1;
constexpr std::uint32_t kInt32 = 5;
constexpr std::uint32_t kUint32 = 6;
constexpr std::uint32_t kDouble = 9;
constexpr std::uint32_t kMatrix = 14;
constexpr std::uint32_t kDoubleClass = 6;
constexpr std::uint32_t kComplexFlag = 0x0800;
constexpr std::size_t kTextLength = 116;
constexpr std::size_t kAlignment = 8;

template <typename T>
void append(std::string &bytes, T value)
{
    for (std::size_t i = 0; i < sizeof(T); ++i)
        bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
}

void appendDoubles(std::string &bytes, const Eigen::MatrixXd &values)
{
    for (const double value : values.reshaped())
        append(bytes, std::bit_cast<std::uint64_t>(value));
}

/// Type, length, content, filled up to a multiple of 8.
void appendElement(std::string &bytes, std::uint32_t type, const std::string &content)
{
    append(bytes, type);
    append(bytes, static_cast<std::uint32_t>(content.size()));
    bytes += content;
    bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
}

} // namespace

MatWriter::MatWriter()
    : m_bytes(std::string("MATLAB 5.0 MAT-file, written by dyncal ") + versionText())
{
    m_bytes.resize(kTextLength, ' ');
    append<std::uint64_t>(m_bytes, 0); // no subsystem data
    append<std::uint16_t>(m_bytes, 0x0100);
    m_bytes += "IM";
}

void MatWriter::add(const std::string &name, const Eigen::MatrixXd &values)
{
    addMatrix(name, values, nullptr);
}

void MatWriter::add(const std::string &name, const Eigen::MatrixXcd &values)
{
    const Eigen::MatrixXd imaginary = values.imag();
    addMatrix(name, values.real(), &imaginary);
}

void MatWriter::add(const std::string &name, double value)
{
    add(name, Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, value)));
}

void MatWriter::addMatrix(
    const std::string &name, const Eigen::MatrixXd &real, const Eigen::MatrixXd *imaginary)
{
    std::string content;
    std::string part;
    append(part, kDoubleClass | (imaginary ? kComplexFlag : 0U));
    append<std::uint32_t>(part, 0);
    appendElement(content, kUint32, part);
    part.clear();
    append(part, static_cast<std::uint32_t>(real.rows()));
    append(part, static_cast<std::uint32_t>(real.cols()));
    appendElement(content, kInt32, part);
    appendElement(content, kInt8, name);
    for (const Eigen::MatrixXd *values : {&real, imaginary}) {
        if (!values)
            continue;
        part.clear();
        appendDoubles(part, *values);
        appendElement(content, kDouble, part);
    }
    appendElement(m_bytes, kMatrix, content);
}

} // namespace dyncal
