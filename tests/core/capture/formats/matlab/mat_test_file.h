// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "tests/core/capture/formats/bytes/binary_test_support.h"

namespace dyncal::testing::level5 {

/// Class codes and number codes of version 5.
constexpr int kStruct = 2, kChar = 4, kSparse = 5, kDouble = 6, kSingle = 7, kInt16 = 10;
constexpr int kComplexFlag = 0x0800, kLogicalFlag = 0x0200;
constexpr std::uint32_t kMiInt8 = 1, kMiUInt8 = 2, kMiInt16 = 3, kMiUInt16 = 4, kMiInt32 = 5,
                        kMiUInt32 = 6, kMiSingle = 7, kMiDouble = 9, kMiInt64 = 12;

/// Writes level 5 files, one variable after the other.
class Mat5
{
public:
    explicit Mat5(std::endian order = std::endian::little)
        : m_order(order)
        , m_file(order)
    {
        m_file.text(QByteArray("MATLAB 5.0 MAT-file, made by a test").leftJustified(116, ' '));
        m_file.zeros(8).put<std::uint16_t>(0x0100).put<std::uint16_t>(0x4D49); // "MI" turned
    }

    template <typename T>
    Mat5 &add(const QByteArray &name, std::uint32_t number, const std::vector<T> &values,
        std::vector<std::int32_t> sizes = {}, int flags = kDouble, bool compress = false)
    {
        if (sizes.empty())
            sizes = {static_cast<std::int32_t>(values.size()), 1};
        ByteWriter content(m_order);
        content.put<std::uint32_t>(kMiUInt32).put<std::uint32_t>(8);
        content.put(static_cast<std::uint32_t>(flags)).put<std::uint32_t>(0);
        putElement(content, kMiInt32, ByteWriter(m_order).putAll(sizes).bytes());
        putElement(content, kMiInt8, name);
        putElement(content, number, ByteWriter(m_order).putAll(values).bytes());
        return addMatrix(content.bytes(), compress);
    }

    Mat5 &addMatrix(const QByteArray &content, bool compress)
    {
        ByteWriter matrix(m_order);
        matrix.put<std::uint32_t>(14).put(static_cast<std::uint32_t>(content.size())).raw(content);
        if (!compress) {
            m_file.raw(matrix.bytes());
            return *this;
        }
        const QByteArray stream = qCompress(matrix.bytes()).mid(4); // Qt puts a length before
        m_file.put<std::uint32_t>(15).put(static_cast<std::uint32_t>(stream.size())).raw(stream);
        return *this;
    }

    const QByteArray &bytes() const { return m_file.bytes(); }

private:
    void putElement(ByteWriter &out, std::uint32_t type, const QByteArray &raw) const
    {
        const auto size = static_cast<std::uint32_t>(raw.size());
        if (size > 0 && size <= 4) {
            out.put(size << 16 | type).raw(raw).zeros(4 - raw.size());
            return;
        }
        out.put(type).put(size).raw(raw).zeros((8 - raw.size() % 8) % 8);
    }

    std::endian m_order;
    ByteWriter m_file;
};

} // namespace dyncal::testing::level5
