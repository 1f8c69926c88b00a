# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A laboratory that shares nothing with core: it makes recordings whose truth is known (README.md)."""
