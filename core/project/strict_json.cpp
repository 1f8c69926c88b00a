// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/project/strict_json.h"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

namespace dyncal {
namespace {

/// A pass over the text that builds nothing and finds errors that the library's reader accepts.
class StrictChecker : public nlohmann::json_sax<Json>
{
public:
    StrictChecker(const std::string &text, const std::string &what)
        : m_text(text)
        , m_what(what)
    {
    }

    std::optional<Error> error;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t &) override { return true; }
    bool string(string_t &) override { return true; }
    bool binary(binary_t &) override { return true; }
    bool start_object(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_array() override { return leave(); }

    bool key(string_t &name) override
    {
        if (m_keys.back().insert(name).second)
            return true;
        return refuse({DYNCAL_TEXT("core", "%1 holds the key \"%2\" twice; remove one of them."),
            {m_what, name}});
    }

    bool parse_error(std::size_t position, const std::string &found,
        const nlohmann::detail::exception &) override
    {
        const std::size_t end = std::min(position > 0 ? position - 1 : 0, m_text.size());
        const auto before = std::string_view(m_text).substr(0, end);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const std::size_t lineStart = before.rfind('\n') + 1; // npos + 1 == 0
        const bool atEnd = position > m_text.size();
        return refuse({DYNCAL_TEXT("core",
                           "%1 is not valid JSON: line %2, column %3, near %4; correct it there."),
            {m_what, std::to_string(line), std::to_string(end - lineStart + 1),
                atEnd ? "the end" : lastOf(found)}});
    }

private:
    static std::string lastOf(std::string text)
    {
        constexpr std::size_t kShown = 30;
        if (text.size() > kShown)
            text.erase(0, text.size() - kShown);
        return text;
    }

    bool enter()
    {
        if (static_cast<Index>(m_keys.size()) >= kDeepestJson)
            return refuse(
                {DYNCAL_TEXT("core",
                     "%1 is nested deeper than the %2 levels that any recipe needs; check that it is the right file."),
                    {m_what, std::to_string(kDeepestJson)}});
        m_keys.emplace_back();
        return true;
    }

    bool leave()
    {
        m_keys.pop_back();
        return true;
    }

    bool refuse(Message message)
    {
        error = Error{ErrorKind::Usage, std::move(message), {}, 0};
        return false;
    }

    const std::string &m_text;
    const std::string &m_what;
    std::vector<std::set<std::string>> m_keys; ///< of each object that is open
};

} // namespace

Result<void> checkStrictJson(const std::string &text, const std::string &what)
{
    StrictChecker checker(text, what);
    if (!Json::sax_parse(text, &checker) && checker.error)
        return tl::unexpected<Error>(*checker.error);
    return {};
}

Result<Json> parseStrictJson(const std::string &text, const std::string &what)
{
    if (const Result<void> isStrict = checkStrictJson(text, what); !isStrict)
        return tl::unexpected<Error>(isStrict.error());
    return Json::parse(text, nullptr, false);
}

} // namespace dyncal
