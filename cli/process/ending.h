// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT

// What a signal leaves behind: whole files, old or new, and no parts of files.

#pragma once

#include <string>

namespace openltc::cli {

/// From now on a signal that ends the process by default (Ctrl-C, hang-up, the limit of processor
/// time, an abort, ...) first removes unfinished files and says one line on standard error; then
/// the process ends by that signal, as its parent expects. Signals that the parent had ignored, as
/// nohup does, stay ignored. SIGPIPE and SIGXFSZ are ignored, so that a pipe that nobody reads and
/// the limit of file size are errors of the write that meets them. To be called once, at the start;
/// watch_files tells it of unfinished files.
void end_cleanly_on_signals();

/// Whether the parent had left SIGPIPE alone, so that it expects a tool to end by it in silence.
bool ends_by_broken_pipes() noexcept;

/// Ends the process by `signal`, as if it had never been handled.
[[noreturn]] void end_by(int signal) noexcept;

/// Between these two signals wait: what happens there happens wholly or not at all. It should last
/// for milliseconds. May be nested; of one thread each.
void hold_ending() noexcept;
void release_ending() noexcept;

/// Files that are to be removed if a signal ends the process. Who creates the file calls
/// remember_unfinished before it releases the ending.
void remember_unfinished(const std::string& path);
void forget_unfinished(const std::string& path) noexcept;

/// From now on the last words are not that nothing was written.
void note_written() noexcept;

} // namespace openltc::cli
