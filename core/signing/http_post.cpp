// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/signing/http_post.h"

#include "core/base/ascii_text.h"
#include "core/base/file_descriptor.h"
#include "core/base/number_text.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

#include <cerrno>
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>

namespace dyncal {
namespace {

constexpr std::string_view kScheme = "http://";

struct HttpAddress
{
    std::string host, port = "80", path = "/";

    /// As an address has it: version 6 of IP in brackets (RFC 3986, 3.2.2).
    std::string place() const
    {
        return (host.find(':') == host.npos ? host : '[' + host + ']') + ':' + port;
    }
};

/// Empty where it is none. Controls, blanks and user names are refused, so that nothing of it can
/// become a line of the request.
std::optional<HttpAddress> parsed(const std::string &url)
{
    for (const char c : url)
        if (c <= ' ' || c == '\x7F' || c == '@')
            return std::nullopt;
    if (!lowerCase(url).starts_with(kScheme))
        return std::nullopt;
    HttpAddress address;
    const std::size_t slash = url.find('/', kScheme.size());
    std::string place = url.substr(kScheme.size(), slash - kScheme.size());
    if (slash != url.npos)
        address.path = url.substr(slash, url.find('#') - slash);
    const std::size_t colon = place.rfind(':'), bracket = place.rfind(']');
    if (colon != place.npos && (bracket == place.npos || colon > bracket)) {
        address.port = place.substr(colon + 1);
        place.resize(colon);
    }
    if (place.starts_with('[') && place.ends_with(']'))
        place = place.substr(1, place.size() - 2);
    address.host = place;
    const bool isPort = !address.port.empty() && address.port.size() <= 5
        && address.port.find_first_not_of("0123456789") == std::string::npos;
    return isPort && !address.host.empty() ? std::optional(address) : std::nullopt;
}

tl::unexpected<Error> noAddress(const std::string &url)
{
    return fail(ErrorKind::Usage,
        {DYNCAL_TEXT("core",
             "%1 is no address of a time-stamping authority that can be asked: it must be http://HOST[:PORT]/PATH. Plain http is enough, because the time stamp is signed itself."),
            {url}});
}

tl::unexpected<Error> noConnection(const std::string &url)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 cannot be reached; look whether the address is right and the network is there, or leave the time stamp out."),
            {url}});
}

/// `end`: of an exchange that did not come to its end.
tl::unexpected<Error> noAnswer(const std::string &url, Awaited end, const AnswerLimits &limits)
{
    const double limit_s = std::chrono::duration<double>(limits.time).count();
    if (end == Awaited::Stopped)
        return fail(ErrorKind::Cancelled, {DYNCAL_TEXT("core", "Stopped on request."), {}});
    if (end == Awaited::TooLate)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 did not answer within %2 s; try again later, or leave the time stamp out."),
                {url, numberText(limit_s, 3)}});
    if (end == Awaited::TooMuch)
        return fail(ErrorKind::FileUnreadable,
            {DYNCAL_TEXT("core",
                 "%1 answered with more than %2 bytes, which no time stamp has; look whether the address is that of a time-stamping authority (RFC 3161), or leave the time stamp out."),
                {url, std::to_string(limits.bytes)}});
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "The connection to %1 broke off before the answer was whole; try again, or leave the time stamp out."),
            {url}});
}

/// "HTTP 404"; "-" where an answer begins as none of HTTP. Nothing of the server's own words is
/// repeated.
std::string statusOf(const std::string &answer)
{
    const std::size_t blank = answer.find(' ');
    const std::string code = blank == answer.npos ? std::string() : answer.substr(blank + 1, 3);
    const bool isCode = code.size() == 3 && code.find_first_not_of("0123456789") == code.npos;
    return isCode && answer.starts_with("HTTP/") ? "HTTP " + code : "-";
}

tl::unexpected<Error> otherAnswer(const std::string &url, const std::string &answer)
{
    return fail(ErrorKind::FileUnreadable,
        {DYNCAL_TEXT("core",
             "%1 answered (%2), but not with a whole time stamp; look whether the address is that of a time-stamping authority (RFC 3161), or leave the time stamp out."),
            {url, statusOf(answer)}});
}

using Places = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Places placesOf(const HttpAddress &address)
{
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo *found = nullptr;
    if (::getaddrinfo(address.host.c_str(), address.port.c_str(), &wanted, &found) != 0)
        found = nullptr;
    return {found, &freeaddrinfo};
}

bool isConnected(int socket)
{
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
}

/// A connection to the first place that takes one; not valid where none does.
FileDescriptor connectTo(const HttpAddress &address, const AnswerClock &clock)
{
    const Places places = placesOf(address);
    for (const addrinfo *one = places.get(); one != nullptr; one = one->ai_next) {
        FileDescriptor socket(::socket(
            one->ai_family, one->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, one->ai_protocol));
        if (!socket.valid())
            continue;
        const int begun = ::connect(socket.get(), one->ai_addr, one->ai_addrlen);
        if ((begun == 0 || errno == EINPROGRESS)
            && clock.ready(socket.get(), POLLOUT) == Awaited::Whole && isConnected(socket.get()))
            return socket;
    }
    return FileDescriptor();
}

Awaited sendAll(int socket, std::string_view bytes, const AnswerClock &clock)
{
    while (!bytes.empty()) {
        if (const Awaited now = clock.ready(socket, POLLOUT); now != Awaited::Whole)
            return now;
        const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EAGAIN && errno != EINTR)
            return Awaited::Broken;
        bytes.remove_prefix(sent > 0 ? static_cast<std::size_t>(sent) : 0);
    }
    return Awaited::Whole;
}

std::string requestOf(
    const HttpAddress &address, const std::string &contentType, const std::string &bytes)
{
    // HTTP/1.0: the answer ends with the connection, in one piece.
    return "POST " + address.path + " HTTP/1.0\r\nHost: " + address.place()
        + "\r\nContent-Type: " + contentType + "\r\nContent-Length: " + std::to_string(bytes.size())
        + "\r\nConnection: close\r\n\r\n" + bytes;
}

/// Value of a field of a head in small letters, blanks around it left out; empty where it has none.
std::string fieldOf(std::string_view head, std::string_view name)
{
    const std::string begin = "\r\n" + std::string(name) + ':';
    const std::size_t line = head.find(begin);
    if (line == head.npos)
        return {};
    const std::string_view rest = head.substr(line + begin.size());
    std::string value(rest.substr(0, rest.find("\r\n")));
    std::erase(value, ' ');
    return value;
}

/// Whether the body is all of what the head announces: it was not cut off on its way, and is not in
/// pieces with numbers between them, which HTTP/1.0 does not have.
bool isWhole(std::string_view head, std::string_view body)
{
    const std::string size = fieldOf(head, "content-length");
    return fieldOf(head, "transfer-encoding").empty()
        && (size.empty() || size == std::to_string(body.size()));
}

/// Body of a whole answer of status 200; empty otherwise.
std::string bodyOf(const std::string &answer)
{
    constexpr std::string_view kEnd = "\r\n\r\n";
    const std::size_t end = answer.find(kEnd), blank = answer.find(' ');
    const bool isGood = answer.starts_with("HTTP/1.") && end != answer.npos && blank < end
        && (answer.compare(blank, 5, " 200 ") == 0 || answer.compare(blank, 5, " 200\r") == 0);
    std::string body = isGood ? answer.substr(end + kEnd.size()) : std::string();
    return isGood && isWhole(lowerCase(answer.substr(0, end)), body) ? body : std::string();
}

} // namespace

Result<void> checkHttpAddress(const std::string &url)
{
    if (!parsed(url))
        return noAddress(url);
    return {};
}

Result<std::string> postedTo(const std::string &url, const std::string &contentType,
    const std::string &bytes, const std::stop_token &stop, const AnswerLimits &limits)
{
    const std::optional<HttpAddress> address = parsed(url);
    if (!address)
        return noAddress(url);
    const AnswerClock clock(limits, stop);
    const FileDescriptor socket = connectTo(*address, clock);
    if (!socket.valid()) {
        const Awaited standing = clock.standing();
        return standing == Awaited::Whole ? noConnection(url) : noAnswer(url, standing, limits);
    }
    std::string answer;
    Awaited end = sendAll(socket.get(), requestOf(*address, contentType, bytes), clock);
    if (end == Awaited::Whole)
        end = readToEnd(socket.get(), limits, clock, answer);
    if (end != Awaited::Whole)
        return noAnswer(url, end, limits);
    std::string body = bodyOf(answer);
    if (body.empty())
        return otherAnswer(url, answer);
    return body;
}

} // namespace dyncal
