# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Install rules and the Debian package; filled in by packaging/.
install(TARGETS dyncal RUNTIME DESTINATION bin)
