// How the twin ends when it cannot go on: a sentence, and exit code 2 from main.
#pragma once

#include <stdexcept>
#include <string>

[[noreturn]] inline void fail(const std::string& what) { throw std::runtime_error(what); }

inline void require(bool ok, const std::string& what)
{
    if (!ok) fail(what);
}
