// SPDX-FileCopyrightText: 2026 The Dyncal authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <thread>

namespace dyncal::testing {

/// A small HTTP server on 127.0.0.1 for a test: it answers each request as it is told, one after
/// the other, until its end.
class AnsweringServer
{
public:
    /// `answer` gets a request's head and body and gives back all bytes that are sent; before the
    /// connection is closed it waits for `delay`.
    explicit AnsweringServer(
        std::function<std::string(const std::string &head, const std::string &body)> answer,
        std::chrono::milliseconds delay = {})
        : m_answer(std::move(answer))
        , m_delay(delay)
        , m_socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof place;
        auto *address = reinterpret_cast<sockaddr *>(&place);
        if (::bind(m_socket, address, size) == 0 && ::listen(m_socket, 8) == 0
            && ::getsockname(m_socket, address, &size) == 0)
            m_port = ntohs(place.sin_port);
        m_thread = std::jthread([this](const std::stop_token &stop) { serve(stop); });
    }
    AnsweringServer(const AnsweringServer &) = delete;
    AnsweringServer &operator=(const AnsweringServer &) = delete;
    ~AnsweringServer()
    {
        m_thread.request_stop();
        ::shutdown(m_socket, SHUT_RDWR);
        m_thread.join();
        ::close(m_socket);
    }

    std::string url(const std::string &path = "/tsa") const
    {
        return std::string("http://127.0.0.1:").append(std::to_string(m_port)).append(path);
    }

private:
    void serve(const std::stop_token &stop) const
    {
        while (!stop.stop_requested()) {
            const int connection = ::accept(m_socket, nullptr, nullptr);
            if (connection < 0)
                continue;
            answer(connection);
            std::this_thread::sleep_for(m_delay);
            ::close(connection);
        }
    }
    void answer(int connection) const
    {
        std::string request;
        std::array<char, 4096> block{};
        std::size_t end = std::string::npos, length = 0;
        while (end == std::string::npos || request.size() < end + 4 + length) {
            const ssize_t got = ::read(connection, block.data(), block.size());
            if (got <= 0)
                return;
            request.append(block.data(), static_cast<std::size_t>(got));
            end = request.find("\r\n\r\n");
            const std::size_t key = request.find("Content-Length: ");
            length = key == std::string::npos ? 0 : std::stoul(request.substr(key + 16));
        }
        const std::string bytes = m_answer(request.substr(0, end), request.substr(end + 4));
        static_cast<void>(::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL));
    }

    std::function<std::string(const std::string &, const std::string &)> m_answer;
    std::chrono::milliseconds m_delay;
    int m_socket;
    int m_port = 0;
    std::jthread m_thread; // the last, so that all else is there when it starts
};

inline std::string httpAnswer(const std::string &body)
{
    return "HTTP/1.0 200 OK\r\nContent-Type: application/timestamp-reply\r\n\r\n" + body;
}

} // namespace dyncal::testing
