// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Layout: as described by the project RigolWFM (rohde_schwarz_rtp_wfm_bin.ksy and its reader, after
// the maker's own); checked against the .Wfm.csv files that the oscilloscope wrote beside.

#include "core/capture/formats/instruments/rohde_bin.h"

#include "core/base/ascii_text.h"
#include "core/base/number_text.h"
#include "core/base/text_encoding.h"
#include "core/capture/formats/bytes/binary_record.h"
#include "core/capture/formats/bytes/byte_reader.h"

#include <cmath>
#include <map>

namespace dyncal {
namespace {

constexpr std::string_view kPayloadEnd = ".Wfm.bin";
constexpr std::size_t kDescriptionBytes = 4 << 20; ///< real ones have a twentieth
constexpr std::uint64_t kPayloadHeader = 8;
constexpr double kRateTolerance = 1e-6; ///< interval and length of the record, as printed

using Properties = std::map<std::string, std::map<std::string, std::string>>;

/// The attributes of one tag: name="value" ...
std::map<std::string, std::string> attributesOf(std::string_view tag)
{
    std::map<std::string, std::string> attributes;
    for (;;) {
        const std::size_t equals = tag.find("=\"");
        if (equals == std::string_view::npos)
            return attributes;
        const std::size_t name = tag.substr(0, equals).find_last_of(" \t\r\n") + 1;
        const std::size_t end = tag.find('"', equals + 2);
        if (end == std::string_view::npos)
            return attributes;
        attributes.emplace(
            tag.substr(name, equals - name), tag.substr(equals + 2, end - equals - 2));
        tag.remove_prefix(end + 1);
    }
}

/// The properties by name; the first of a name counts. It is a flat list: no more XML is needed.
Properties propertiesOf(std::string_view xml)
{
    Properties properties;
    constexpr std::string_view kTag = "<Prop ";
    for (std::size_t at = xml.find(kTag); at != std::string_view::npos; at = xml.find(kTag, at)) {
        const std::size_t end = std::min(xml.find('>', at), xml.size());
        std::map<std::string, std::string> attributes
            = attributesOf(xml.substr(at + kTag.size() - 1, end - at - kTag.size() + 1));
        const std::string name = attributes["Name"];
        properties.emplace(name, std::move(attributes));
        at = end;
    }
    return properties;
}

/// How the samples of a format lie in one row (all channels at one time).
struct RowFormat
{
    const char *name; ///< in the description
    std::uint32_t code; ///< in the payload
    SampleType type;
    Index timeBytes; ///< before the values
};
constexpr RowFormat kFormats[] = {{"eRS_SIGNAL_FORMAT_FLOAT", 4, SampleType::Float32, 0},
    {"eRS_SIGNAL_FORMAT_XYDOUBLEFLOAT", 6, SampleType::Float32, 8},
    {"eRS_SIGNAL_FORMAT_INT8BIT", 0, SampleType::Int8, 0}};

std::string payloadPath(const std::string &path)
{
    return path.substr(0, path.size() - std::string_view(".bin").size()) + std::string(kPayloadEnd);
}

class RohdeReader
{
public:
    RohdeReader(const std::string &path, Properties properties)
        : m_path(path)
        , m_properties(std::move(properties))
    {
    }

    Result<CaptureSet> read()
    {
        if (const Result<void> kind = checkKind(); !kind)
            return tl::unexpected(kind.error());
        if (const Result<void> sizes = readSizes(); !sizes)
            return tl::unexpected(sizes.error());
        if (const Result<void> payload = openPayload(); !payload)
            return tl::unexpected(payload.error());
        Shot shot;
        const double rate_Hz = sampleRate();
        for (std::size_t c = 0; c < m_sources.size(); ++c) {
            Channel channel;
            channel.name = freeChannelName(shot, m_sources[c]);
            channel.unit = unit();
            channel.sampleRate_Hz = rate_Hz;
            channel.t0_s = m_start_s;
            if (m_format->type == SampleType::Int8)
                if (const Result<void> scaled = scaleCounts(channel); !scaled)
                    return tl::unexpected(scaled.error());
            channel.samples = samplesOf(static_cast<Index>(c));
            shot.channels.push_back(std::move(channel));
        }
        m_set.shots.push_back(std::move(shot));
        m_set.instruments["oscilloscope"] = {{"vendor", "Rohde & Schwarz"}};
        labelShots(m_set, m_path);
        return std::move(m_set);
    }

private:
    std::string text(const std::string &property, const std::string &attribute = "Value") const
    {
        const auto found = m_properties.find(property);
        if (found == m_properties.end())
            return {};
        const auto value = found->second.find(attribute);
        return value != found->second.end() ? value->second : std::string();
    }

    std::optional<double> number(const std::string &property) const
    {
        const std::optional<double> value = parseNumber(text(property));
        return value && std::isfinite(*value) ? value : std::nullopt;
    }

    tl::unexpected<Error> refuse(const std::string &why) const
    {
        return unsupportedKind(m_path, "Rohde & Schwarz " + why);
    }

    Result<void> checkKind()
    {
        const std::string format = text("SignalFormat");
        for (const RowFormat &one : kFormats) {
            if (format == one.name)
                m_format = &one;
        }
        if (m_format == nullptr)
            return refuse("samples \"" + format + "\"");
        if (text("NumberOfAcquisitions") != "1")
            return refuse("history of " + text("NumberOfAcquisitions") + " acquisitions");
        if (text("TraceType") != "eRS_TRACE_TYPE_NORMAL")
            return refuse("trace \"" + text("TraceType") + "\"");
        if (text("XStart", "UnitName") != "s")
            return refuse("trace over \"" + text("XStart", "UnitName") + "\" instead of seconds");
        if (text("MultiChannelExport") != "eRS_ONOFF_ON") {
            m_sources = {sourceName(text("Source"))};
            return {};
        }
        for (const char *place : {"I_0", "I_1", "I_2", "I_3"}) {
            if (text("MultiChannelExportState", place) == "eRS_ONOFF_ON")
                m_sources.push_back(sourceName(text("MultiChannelSource", place)));
        }
        if (m_sources.empty())
            return noSignal(m_path);
        if (m_format->type == SampleType::Int8)
            return refuse("8-bit counts of several channels");
        return {};
    }

    /// "eRS_SIGNAL_SOURCE_CH1_TR1" is CH1.
    static std::string sourceName(std::string source)
    {
        constexpr std::string_view kBegin = "eRS_SIGNAL_SOURCE_", kEnd = "_TR1";
        if (source.starts_with(kBegin))
            source.erase(0, kBegin.size());
        if (source.ends_with(kEnd))
            source.erase(source.size() - kEnd.size());
        return source.empty() ? "channel" : source;
    }

    Result<void> readSizes()
    {
        const auto whole = [this](const std::string &property, Index &value) {
            constexpr double kMost = 1e12;
            const std::optional<double> given = number(property);
            if (!given || *given < 0.0 || *given > kMost || *given != std::floor(*given))
                return false;
            value = static_cast<Index>(*given);
            return true;
        };
        for (const auto &[property, value] :
            {std::pair{"SignalHardwareRecordLength", &m_rows}, std::pair{"RecordLength", &m_count},
                std::pair{"LeadingSettlingSamples", &m_first}}) {
            if (!whole(property, *value))
                return impossibleField(m_path, property, text(property));
        }
        if (m_count == 0 || m_first + m_count > m_rows)
            return impossibleField(m_path, "RecordLength", text("RecordLength"));
        const std::optional<double> start_s = number("XStart");
        if (!start_s)
            return impossibleField(m_path, "XStart", text("XStart"));
        m_start_s = *start_s;
        return {};
    }

    Index rowBytes() const
    {
        return m_format->timeBytes
            + static_cast<Index>(m_sources.size()) * bytesPerSample(m_format->type);
    }

    Result<void> openPayload()
    {
        const std::string path = payloadPath(m_path);
        const auto file = SampleFile::open(path);
        if (!file)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%1 describes samples that are in %2, which cannot be opened; put both files into one folder."),
                    {m_path, path}},
                "CAP-018");
        m_payload = *file;
        const std::vector<std::byte> head = bytesAt(*m_payload, 0, kPayloadHeader);
        ByteReader bytes(head);
        const auto code = bytes.next<std::uint32_t>();
        const auto rows = bytes.next<std::uint32_t>();
        if (!bytes.ok())
            return endsInHeader(path);
        if (code != m_format->code || static_cast<Index>(rows) != m_rows)
            return fail(ErrorKind::FileUnreadable,
                {DYNCAL_TEXT("core",
                     "%2 does not hold the samples that %1 describes; copy both files again, from the same recording."),
                    {m_path, path}},
                "CAP-018");
        const std::uint64_t there
            = (m_payload->size() - kPayloadHeader) / static_cast<std::uint64_t>(rowBytes());
        if (there < static_cast<std::uint64_t>(m_rows))
            return endsInSamples(path, m_sources.front(), static_cast<Index>(there), m_rows);
        return checkTimes();
    }

    /// Where the payload has times, they must be those of the description.
    Result<void> checkTimes() const
    {
        if (m_format->timeBytes == 0)
            return {};
        const std::optional<double> stop_s = number("XStop");
        const double step_s
            = (stop_s.value_or(m_start_s) - m_start_s) / static_cast<double>(m_count);
        for (const Index k : {Index(0), m_count - 1}) {
            const std::uint64_t at
                = kPayloadHeader + static_cast<std::uint64_t>((m_first + k) * rowBytes());
            const std::vector<std::byte> raw = bytesAt(*m_payload, at, 8);
            const auto time_s = ByteReader(raw).next<double>();
            const double expected_s = m_start_s + static_cast<double>(k) * step_s;
            if (!(std::abs(time_s - expected_s) <= 0.5 * step_s))
                return impossibleField(m_path, "XStart and XStop",
                    text("XStart") + " and " + text("XStop") + " (the samples begin or end at "
                        + numberText(time_s, 9) + ")");
        }
        return {};
    }

    /// The interval is stated, and follows from the ends of the record.
    double sampleRate()
    {
        const double step_s = number("Resolution").value_or(0.0);
        const double span_s = number("XStop").value_or(m_start_s) - m_start_s;
        const double implied_s = span_s / static_cast<double>(m_count);
        if (std::abs(step_s - implied_s) > kRateTolerance * std::abs(step_s)) {
            m_set.findings.push_back({.id = "CAP-003",
                .severity = Severity::Caution,
                .shot = 1,
                .message
                = {DYNCAL_TEXT("core",
                       "%1 states a sampling interval of %2 s, but a record from end to end that means %3 s, so the rate is unknown; state it in the recipe's import section."),
                    {m_path, numberText(step_s, 7), numberText(implied_s, 7)}},
                .value = step_s,
                .limit = implied_s});
            return 0.0;
        }
        return sampleRateOf(step_s, m_path, m_sources.front(), 1, m_set.findings);
    }

    std::string unit() const
    {
        const std::string name = utf8Text(text("VerticalOffset", "UnitName"));
        return name.empty() ? "1" : name;
    }

    /// The levels of the converter span the divisions of the screen.
    Result<void> scaleCounts(Channel &channel) const
    {
        const std::optional<double> perDivision = number("VerticalScale");
        const std::optional<double> divisions = number("VerticalDivisionCount");
        const std::optional<double> levels = number("NofQuantisationLevels");
        const std::optional<double> offset = number("VerticalOffset");
        const std::optional<double> position = number("VerticalPosition");
        if (!perDivision || !divisions || !levels || !offset || !position || !(*levels > 0.0)
            || !(*perDivision > 0.0) || !(*divisions > 0.0))
            return impossibleField(m_path, "VerticalScale", text("VerticalScale"));
        channel.polynomial
            = {*offset - *position * *perDivision, *perDivision * *divisions / *levels};
        channel.adcBits = 8;
        return {};
    }

    RawSamples samplesOf(Index channel) const
    {
        const Index at
            = m_first * rowBytes() + m_format->timeBytes + channel * bytesPerSample(m_format->type);
        return samplesInFile(m_payload,
            {m_format->type, std::endian::little, rowBytes(),
                {{kPayloadHeader + static_cast<std::uint64_t>(at), m_count}}})
            .value_or(RawSamples());
    }

    const std::string &m_path;
    Properties m_properties;
    const RowFormat *m_format = nullptr;
    std::vector<std::string> m_sources;
    std::shared_ptr<const SampleFile> m_payload;
    Index m_rows = 0, m_count = 0, m_first = 0; ///< rows in the payload; shown; first shown
    double m_start_s = 0.0;
    CaptureSet m_set;
};

} // namespace

int recogniseRohdeBin(const std::string &path, std::string_view head)
{
    if (head.starts_with("<?xml") && head.find("eRS_SIGNAL_") != std::string_view::npos)
        return 100;
    return lowerCase(path).ends_with(lowerCase(std::string(kPayloadEnd))) ? 60 : 0;
}

Result<CaptureSet> readRohdeBin(const std::string &path, const ImportSettings &, const JobControl &)
{
    const std::string lower = lowerCase(path);
    if (lower.ends_with(lowerCase(std::string(kPayloadEnd)))) {
        const std::string description = path.substr(0, path.size() - kPayloadEnd.size()) + ".bin";
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 holds only the samples of a Rohde & Schwarz recording; open %2, which describes them."),
                {path, description}},
            "CAP-001");
    }
    const auto file = SampleFile::open(path);
    if (!file)
        return tl::unexpected(file.error());
    const std::vector<std::byte> raw = bytesAt(**file, 0, kDescriptionBytes);
    const std::string_view xml(reinterpret_cast<const char *>(raw.data()), raw.size());
    if (xml.find("</Database>") == std::string_view::npos || !lower.ends_with(".bin"))
        return endsInHeader(path);
    return RohdeReader(path, propertiesOf(xml)).read();
}

} // namespace dyncal
