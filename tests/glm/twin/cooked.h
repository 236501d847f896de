// Our cooked files, as cga.framework.cooked.CookedFile, CookedModel and CookedTexture write them: little-endian, ints and floats at
// multiples of 4. They are mapped, not copied. Checksums and sources are for the program that keeps them, and are passed over here.
#pragma once

#include "error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <vector>

// What is left of a file to read.
class Bytes {
public:
    Bytes(const unsigned char* begin, const unsigned char* end) : at_(begin), end_(end) {}

    std::int32_t number()
    {
        std::int32_t value;
        std::memcpy(&value, take(sizeof value), sizeof value);
        return value;
    }

    const unsigned char* take(std::size_t count)
    {
        require(count <= static_cast<std::size_t>(end_ - at_), "a cooked file ends too early");
        const unsigned char* taken = at_;
        at_ += count;
        return taken;
    }

    // A length and so many bytes; -1 is the length of no string at all.
    void skipString()
    {
        const std::int32_t length = number();
        if (length > 0) take((static_cast<std::size_t>(length) + 3) / 4 * 4);
    }

private:
    const unsigned char* at_;
    const unsigned char* end_;
};

// The payload of the cooked file at `path`; it stays mapped.
inline Bytes cookedPayload(const std::string& path)
{
    const int file = open(path.c_str(), O_RDONLY);
    struct stat status {};
    require(file >= 0 && fstat(file, &status) == 0, "cannot read " + path);
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapped = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    close(file);
    require(mapped != MAP_FAILED, "cannot map " + path);
    const auto* begin = static_cast<const unsigned char*>(mapped);
    Bytes bytes(begin, begin + size);
    require(std::memcmp(bytes.take(8), "CGACOOK1", 8) == 0, path + " is no cooked file of this version");
    const std::int32_t sources = bytes.number();
    bytes.number(); // the payload's size
    bytes.number(); // the checksum
    bytes.take(static_cast<std::size_t>(sources));
    return bytes;
}

struct CookedMesh {
    std::int32_t floats;
    const unsigned char* vertices;
    std::int32_t count;
    const unsigned char* indices;
};

inline std::vector<CookedMesh> readModel(const std::string& path)
{
    Bytes bytes = cookedPayload(path);
    std::vector<CookedMesh> meshes(static_cast<std::size_t>(bytes.number()));
    for (CookedMesh& mesh : meshes) {
        mesh.floats = bytes.number();
        mesh.vertices = bytes.take(4 * static_cast<std::size_t>(mesh.floats));
        mesh.count = bytes.number();
        mesh.indices = bytes.take(4 * static_cast<std::size_t>(mesh.count));
        // The material; the recorded frame says what is drawn with.
        bytes.take(4 * 10);
        for (int strings = 0; strings < 4; strings++) bytes.skipString();
    }
    return meshes;
}

struct CookedLevel {
    std::int32_t width;
    std::int32_t height;
    const unsigned char* rgba;
};

inline std::vector<CookedLevel> readTexture(const std::string& path)
{
    Bytes bytes = cookedPayload(path);
    std::vector<CookedLevel> levels(static_cast<std::size_t>(bytes.number()));
    for (CookedLevel& level : levels) {
        level.width = bytes.number();
        level.height = bytes.number();
        level.rgba = bytes.take(4 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
    }
    return levels;
}
