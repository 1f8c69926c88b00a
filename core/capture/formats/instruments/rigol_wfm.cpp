// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Layouts as described by the project RigolWFM (rigol_1000e_wfm.ksy, rigol_1000b_wfm.ksy). Scale
// and zero were found from CSV files that the same oscilloscopes wrote of the same records: to the
// last digit for the DS1204B, to one count (the CSV is what the screen showed) for the DS1102E.

#include "core/capture/formats/instruments/rigol_wfm.h"

#include "core/base/ascii_text.h"
#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"

#include <array>
#include <cmath>

namespace dyncal {
namespace {

using std::string_view_literals::operator""sv;

constexpr double kCountsPerDivision = 25.0;
constexpr double kMicro = 1e-6, kPico = 1e-12; ///< of the integers in the headers
constexpr std::uint32_t kPointsB = 8192; ///< the only memory depth proven by a CSV file

/// One channel's settings.
struct Setting
{
    bool enabled = false, inverted = false;
    std::int32_t scale_uV = 0; ///< per division
    std::int16_t shift = 0; ///< of the trace in counts
    float probe = 1.0F;
};

struct Header
{
    std::vector<Setting> channels;
    std::uint32_t points = 0;
    float rate_Hz = 0.0F;
    std::int64_t offset_ps = 0; ///< of the middle of the record from the trigger
    double zero = 0.0; ///< count of 0 V without shift
    std::uint64_t begin = 0; ///< of the samples
    bool gaps = false; ///< channels that are off have room too
    std::string model, unread; ///< why it cannot be read, or empty
};

/// Families that are known by their first bytes and not read.
struct Family
{
    std::string_view signature;
    const char *name;
};
constexpr std::array kUnread{Family{"\x01\xFF\xFF\xFF"sv, "Rigol WFM of the family DS1000Z"},
    Family{"\xA5\xA5\x38\x00"sv, "Rigol WFM of the families DS2000, DS4000 or DS6000"},
    Family{"\xA1\xA5\x00\x00"sv, "Rigol WFM of the family DS1000C"},
    Family{"\x02\x00\x00\x00"sv, "Rigol WFM of the family DHO"},
    Family{":WFM#"sv, "Tektronix WFM"}};
constexpr std::string_view kFamilyE = "\xA5\xA5\x00\x00"sv, kFamilyB = "\xA5\xA5\xA4\x01"sv;
constexpr std::size_t kHeaderE = 276, kHeaderB = 420;

const char *unreadFamily(std::string_view head)
{
    for (const Family &family : kUnread) {
        const std::size_t at = family.signature[0] == ':' ? 2 : 0; // after the byte order
        if (head.substr(std::min(at, head.size())).starts_with(family.signature))
            return family.name;
    }
    return nullptr;
}

Header headerOfE(ByteReader bytes)
{
    Header header;
    header.model = "DS1000E/D";
    header.zero = 125.0;
    header.begin = kHeaderE;
    const auto rollStop = bytes.at<std::uint32_t>(20);
    header.points = bytes.at<std::uint32_t>(28);
    for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t at = 34 + 24 * k;
        Setting setting;
        setting.probe = bytes.at<float>(at + 10);
        setting.enabled = bytes.at<std::uint8_t>(at + 15) != 0;
        setting.inverted
            = bytes.at<std::uint8_t>(at + 14) != 0 || bytes.at<std::uint8_t>(at + 16) != 0;
        setting.scale_uV = bytes.at<std::int32_t>(at + 18);
        setting.shift = bytes.next<std::int16_t>();
        header.channels.push_back(setting);
    }
    header.rate_Hz = bytes.at<float>(100);
    header.offset_ps = bytes.at<std::int64_t>(112);
    constexpr std::uint8_t kAlternating = 4;
    if (rollStop != 0)
        header.unread = "rolling acquisition";
    else if (bytes.at<std::uint8_t>(142) == kAlternating)
        header.unread = "alternating trigger";
    return header;
}

Header headerOfB(ByteReader bytes)
{
    Header header;
    bytes.seek(4);
    header.model = utf8Text(bytes.text(8));
    header.zero = 99.0;
    header.begin = kHeaderB;
    header.gaps = true;
    header.points = bytes.at<std::uint32_t>(60);
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t at = 68 + 24 * k;
        Setting setting;
        setting.probe = bytes.at<float>(at + 8);
        setting.inverted
            = bytes.at<std::uint8_t>(at + 13) != 0 || bytes.at<std::uint8_t>(at + 15) != 0;
        setting.enabled = bytes.at<std::uint8_t>(at + 14) != 0;
        setting.scale_uV = bytes.at<std::int32_t>(at + 16);
        setting.shift = bytes.next<std::int16_t>();
        header.channels.push_back(setting);
    }
    header.offset_ps = bytes.at<std::int64_t>(172);
    header.rate_Hz = bytes.next<float>();
    if (header.points != kPointsB)
        header.unread = "memory of " + std::to_string(header.points) + " points";
    return header;
}

Result<void> checkHeader(const std::string &path, const Header &header, std::uint64_t fileBytes)
{
    std::uint64_t stored = 0, enabled = 0;
    bool inverted = false;
    for (const Setting &setting : header.channels) {
        enabled += setting.enabled ? 1 : 0;
        stored += setting.enabled || header.gaps ? 1 : 0;
        inverted = inverted || (setting.enabled && setting.inverted);
    }
    const auto refuse = [&](const std::string &why) {
        return unsupportedKind(path, "Rigol WFM " + header.model + ", " + why);
    };
    if (header.points == 0 || enabled == 0)
        return noSignal(path);
    if (!header.unread.empty())
        return refuse(header.unread);
    if (inverted)
        return refuse("inverted channel");
    const std::uint64_t needed = header.begin + stored * header.points;
    if (!header.gaps && fileBytes + 4 == needed) // another family, its header is shorter
        return unsupportedKind(path, "Rigol WFM of the family DS1000C");
    if (fileBytes < needed)
        return endsInSamples(path, "CH1",
            static_cast<Index>(std::min<std::uint64_t>(
                fileBytes > header.begin ? fileBytes - header.begin : 0, header.points)),
            header.points);
    if (!header.gaps && fileBytes != needed) // other contents are not proven
        return refuse("with other data than two analog channels");
    return {};
}

/// Scale and zero of one channel; false if they are no numbers.
bool scaleCounts(Channel &channel, const Setting &setting, double zero)
{
    const double volts = static_cast<double>(setting.scale_uV) * kMicro
        * intendedInterval(static_cast<double>(setting.probe)) / kCountsPerDivision;
    if (!(volts > 0.0) || !std::isfinite(volts))
        return false;
    channel.polynomial = {(zero - setting.shift) * volts, -volts};
    channel.adcBits = 8;
    return true;
}

Result<CaptureSet> setOf(
    const std::string &path, const Header &header, const std::shared_ptr<const SampleFile> &file)
{
    CaptureSet set;
    Shot shot;
    const double rate_Hz = intendedInterval(static_cast<double>(header.rate_Hz)); // as decimal
    const double half_s = header.points / 2.0 / rate_Hz;
    std::uint64_t begin = header.begin;
    for (std::size_t k = 0; k < header.channels.size(); ++k) {
        const Setting &setting = header.channels[k];
        if (setting.enabled) {
            Channel channel;
            channel.name = "CH" + std::to_string(k + 1);
            channel.sampleRate_Hz
                = sampleRateOf(1.0 / rate_Hz, path, channel.name, 1, set.findings);
            if (channel.sampleRate_Hz > 0.0) {
                channel.sampleRate_Hz = rate_Hz;
                channel.t0_s = static_cast<double>(header.offset_ps) * kPico - half_s;
            }
            if (!scaleCounts(channel, setting, header.zero))
                return impossibleField(path, "volts per division of " + channel.name,
                    std::to_string(setting.scale_uV) + " uV");
            const auto samples = samplesInFile(file,
                {SampleType::UInt8, std::endian::little, 0,
                    {{begin, static_cast<Index>(header.points)}}});
            if (!samples)
                return endsInHeader(path);
            channel.samples = *samples;
            shot.channels.push_back(std::move(channel));
        }
        if (setting.enabled || header.gaps)
            begin += header.points;
    }
    set.shots.push_back(std::move(shot));
    set.instruments["oscilloscope"] = {{"vendor", "Rigol"}, {"model", header.model}};
    labelShots(set, path);
    return set;
}

} // namespace

int recogniseRigolWfm(const std::string &path, std::string_view head)
{
    if (head.starts_with(kFamilyB) && head.substr(4).starts_with("DS1"))
        return 100;
    const bool named = lowerCase(path).ends_with(".wfm");
    if (named && head.starts_with(kFamilyE))
        return 100;
    return named && unreadFamily(head) != nullptr ? 50 : 0;
}

Result<CaptureSet> readRigolWfm(const std::string &path, const ImportSettings &, const JobControl &)
{
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    const std::vector<std::byte> raw = bytesAt(**file, 0, kHeaderB);
    const std::string_view head(reinterpret_cast<const char *>(raw.data()), raw.size());
    if (const char *name = unreadFamily(head))
        return unsupportedKind(path, name);
    const bool isB = head.starts_with(kFamilyB);
    if ((!isB && !head.starts_with(kFamilyE)) || head.size() < (isB ? kHeaderB : kHeaderE))
        return endsInHeader(path);
    const Header header = isB ? headerOfB(ByteReader(raw)) : headerOfE(ByteReader(raw));
    if (const Result<void> sound = checkHeader(path, header, (*file)->size()); !sound)
        return tl::unexpected(sound.error());
    return setOf(path, header, *file);
}

} // namespace dyncal
