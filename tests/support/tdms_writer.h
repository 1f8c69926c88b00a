// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

/// Writes TDMS files byte by byte as NI's description of the format says, independent of the
/// reader: nothing here is taken from core.
namespace dyncal::testing {

struct TdmsTime
{
    std::int64_t seconds = 0;
    std::uint64_t fraction = 0;
};

template <typename T>
constexpr std::uint32_t tdmsTypeNumber()
{
    if constexpr (std::is_same_v<T, std::int8_t>)
        return 1;
    else if constexpr (std::is_same_v<T, std::int16_t>)
        return 2;
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return 3;
    else if constexpr (std::is_same_v<T, std::int64_t>)
        return 4;
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return 5;
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return 6;
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return 7;
    else if constexpr (std::is_same_v<T, std::uint64_t>)
        return 8;
    else if constexpr (std::is_same_v<T, float>)
        return 9;
    else if constexpr (std::is_same_v<T, double>)
        return 10;
    else if constexpr (std::is_same_v<T, bool>)
        return 0x21;
    else
        return 0x44;
}

/// Bytes in one byte order.
class TdmsBytes
{
public:
    explicit TdmsBytes(bool bigEndian = false)
        : m_bigEndian(bigEndian)
    {
    }

    template <typename T>
    TdmsBytes &add(T value)
    {
        char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        if (m_bigEndian)
            std::reverse(bytes, bytes + sizeof(T));
        m_bytes.append(bytes, sizeof(T));
        return *this;
    }

    TdmsBytes &add(const TdmsTime &time)
    {
        if (m_bigEndian)
            return add(time.seconds).add(time.fraction);
        return add(time.fraction).add(time.seconds);
    }

    TdmsBytes &text(const std::string &value)
    {
        add(static_cast<std::uint32_t>(value.size()));
        m_bytes += value;
        return *this;
    }

    template <typename T>
    TdmsBytes &all(const std::vector<T> &values)
    {
        for (const T value : values)
            add(value);
        return *this;
    }

    TdmsBytes &raw(const std::string &bytes)
    {
        m_bytes += bytes;
        return *this;
    }

    const std::string &bytes() const { return m_bytes; }

private:
    bool m_bigEndian;
    std::string m_bytes;
};

struct TdmsWriterScaler
{
    std::uint32_t type = 3; ///< DAQmx number: 0 u8, 1 i8, 2 u16, 3 i16, 4 u32, 5 i32, ...
    std::uint32_t buffer = 0;
    std::uint32_t offset = 0; ///< bytes; bits for digital lines
    std::uint32_t scaleId = 0;
};

/// One segment: objects, properties, then data.
class TdmsSegment
{
public:
    static constexpr std::uint32_t kMetaData = 1 << 1;
    static constexpr std::uint32_t kNewList = 1 << 2;
    static constexpr std::uint32_t kRawData = 1 << 3;
    static constexpr std::uint32_t kInterleaved = 1 << 5;
    static constexpr std::uint32_t kBigEndian = 1 << 6;
    static constexpr std::uint32_t kDaqmx = 1 << 7;
    static constexpr std::uint64_t kUnclosed = 0xFFFFFFFFFFFFFFFF;

    explicit TdmsSegment(std::uint32_t contents = kMetaData | kNewList | kRawData)
        : m_contents(contents)
        , m_data(isBigEndian())
    {
    }

    std::uint32_t version = 4713;

    /// Begins an object; what follows belongs to it.
    TdmsSegment &object(const std::string &path, const std::string &rawIndex)
    {
        m_objects.push_back({path, rawIndex, TdmsBytes(isBigEndian()), 0});
        return *this;
    }

    TdmsSegment &object(const std::string &path) { return object(path, noData()); }

    template <typename T>
    TdmsSegment &channel(const std::string &path, std::uint64_t count)
    {
        return object(path, index(tdmsTypeNumber<T>(), count));
    }

    template <typename T>
    TdmsSegment &property(const std::string &name, T value)
    {
        Object &last = m_objects.back();
        last.properties.text(name).template add<std::uint32_t>(tdmsTypeNumber<T>());
        last.properties.add(value);
        ++last.count;
        return *this;
    }

    TdmsSegment &property(const std::string &name, const char *value)
    {
        Object &last = m_objects.back();
        last.properties.text(name).add<std::uint32_t>(0x20).text(value);
        ++last.count;
        return *this;
    }

    TdmsBytes &data() { return m_data; }

    std::string noData() const { return order().add<std::uint32_t>(0xFFFFFFFF).bytes(); }
    std::string asBefore() const { return order().add<std::uint32_t>(0).bytes(); }

    std::string index(std::uint32_t type, std::uint64_t count) const
    {
        return order().add<std::uint32_t>(0x14).add(type).add<std::uint32_t>(1).add(count).bytes();
    }

    std::string textIndex(std::uint64_t count, std::uint64_t bytes) const
    {
        return order()
            .add<std::uint32_t>(0x1C)
            .add<std::uint32_t>(0x20)
            .add<std::uint32_t>(1)
            .add(count)
            .add(bytes)
            .bytes();
    }

    std::string daqmx(std::uint64_t count, const std::vector<TdmsWriterScaler> &scalers,
        const std::vector<std::uint32_t> &widths, bool digital = false,
        std::uint32_t type = 0xFFFFFFFF) const
    {
        TdmsBytes bytes = order();
        bytes.add<std::uint32_t>(digital ? 0x126A : 0x1269).add(type).add<std::uint32_t>(1);
        bytes.add(count).add(static_cast<std::uint32_t>(scalers.size()));
        for (const TdmsWriterScaler &scaler : scalers) {
            bytes.add(scaler.type).add(scaler.buffer).add(scaler.offset);
            if (digital)
                bytes.add<std::uint8_t>(0);
            else
                bytes.add<std::uint32_t>(0);
            bytes.add(scaler.scaleId);
        }
        bytes.add(static_cast<std::uint32_t>(widths.size())).all(widths);
        return bytes.bytes();
    }

    std::string metadata() const
    {
        TdmsBytes bytes = order();
        if ((m_contents & kMetaData) == 0)
            return {};
        bytes.add(static_cast<std::uint32_t>(m_objects.size()));
        for (const Object &object : m_objects) {
            bytes.text(object.path).raw(object.rawIndex).add(object.count);
            bytes.raw(object.properties.bytes());
        }
        return bytes.bytes();
    }

    /// The segment; `next` is what its lead-in says of its length (default: the truth).
    std::string bytes() const { return bytes(metadata().size() + m_data.bytes().size()); }

    std::string bytes(std::uint64_t next) const
    {
        TdmsBytes lead = order();
        const std::string meta = metadata();
        lead.add(version).add(next).add(static_cast<std::uint64_t>(meta.size()));
        return "TDSm" + TdmsBytes(false).add(m_contents).bytes() + lead.bytes() + meta
            + m_data.bytes();
    }

private:
    struct Object
    {
        std::string path;
        std::string rawIndex;
        TdmsBytes properties;
        std::uint32_t count = 0;
    };

    bool isBigEndian() const { return (m_contents & kBigEndian) != 0; }
    TdmsBytes order() const { return TdmsBytes(isBigEndian()); }

    std::uint32_t m_contents;
    std::vector<Object> m_objects;
    TdmsBytes m_data;
};

} // namespace dyncal::testing
