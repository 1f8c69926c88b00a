// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/pdf/pdf_streams.h"

#include <openssl/evp.h>
#include <qpdf/Pipeline.hh>
#include <qpdf/QPDFObjectHandle.hh>

#include <array>
#include <memory>
#include <stdexcept>

namespace dyncal {
namespace {

/// Takes what comes out of the filters, and stops them at its limit.
class LimitedSink : public Pipeline
{
public:
    explicit LimitedSink(std::size_t limit)
        : Pipeline("unpacked", nullptr)
        , m_limit(limit)
    {
    }

    void write(const unsigned char *bytes, std::size_t count) override
    {
        if (count > m_limit - m_bytes.size()) {
            m_isOver = true;
            throw std::length_error("more than may be unpacked");
        }
        m_bytes.append(reinterpret_cast<const char *>(bytes), count);
    }
    void finish() override { }

    bool isOver() const { return m_isOver; }
    std::string take() { return std::move(m_bytes); }

private:
    std::size_t m_limit;
    std::string m_bytes;
    bool m_isOver = false;
};

bool isSimple(QPDFObjectHandle dictionary)
{
    QPDFObjectHandle filter = dictionary.getKey("/Filter");
    if (filter.isArray() && filter.getArrayNItems() == 1)
        filter = filter.getArrayItem(0);
    const bool isDeflate = filter.isName() && filter.getName() == "/FlateDecode";
    return (filter.isNull() || isDeflate) && dictionary.getKey("/DecodeParms").isNull()
        && !dictionary.hasKey("/F");
}

} // namespace

std::optional<std::string> UnpackingBudget::unpack(QPDFObjectHandle &stream)
{
    if (!stream.isStream() || !isSimple(stream.getDict()))
        return std::nullopt;
    LimitedSink sink(m_left);
    const bool isWhole = stream.pipeStreamData(&sink, 0, qpdf_dl_generalized, true, false);
    if (!isWhole || sink.isOver())
        return std::nullopt;
    std::string bytes = sink.take();
    m_left -= bytes.size();
    return bytes;
}

std::string md5Of(const std::string &bytes)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_md5(), nullptr) != 1)
        return {};
    return {reinterpret_cast<const char *>(digest.data()), size};
}

} // namespace dyncal
