// Writes a picture as PNG the way cga.framework.image.PngFile does: strips packed by several threads. zlib is loaded at run time, for
// Mesa brings it along; so its headers are not needed.
#pragma once

#include "context.h"

#include <algorithm>
#include <fstream>
#include <thread>
#include <vector>

class Zlib {
public:
    // zlib's z_stream; its layout is part of the library's binary interface.
    struct Stream {
        const unsigned char* input = nullptr;
        unsigned inputSize = 0;
        unsigned long inputTotal = 0;
        unsigned char* output = nullptr;
        unsigned outputSize = 0;
        unsigned long outputTotal = 0;
        const char* message = nullptr;
        void* state = nullptr;
        void* allocate = nullptr;
        void* release = nullptr;
        void* opaque = nullptr;
        int dataType = 0;
        unsigned long adler = 0;
        unsigned long reserved = 0;
    };

    using Checksum = unsigned long (*)(unsigned long, const unsigned char*, unsigned);

    Library library{"libz.so.1", "libz.so"};
    Checksum crc32 = library.find<Checksum>("crc32");
    Checksum adler32 = library.find<Checksum>("adler32");

    std::vector<unsigned char> packed(const std::vector<unsigned char>& bytes, bool last) const
    {
        constexpr int fastest = 1, deflated = 8, rawWindow = -15, memory = 8, syncFlush = 2, finish = 4;
        std::vector<unsigned char> result(bytes.size() + bytes.size() / 64 + 64);
        Stream stream;
        stream.input = bytes.data();
        stream.inputSize = static_cast<unsigned>(bytes.size());
        stream.output = result.data();
        stream.outputSize = static_cast<unsigned>(result.size());
        require(init_(&stream, fastest, deflated, rawWindow, memory, 0, "1.2.11", sizeof stream) == 0, "zlib does not start");
        deflate_(&stream, last ? finish : syncFlush);
        result.resize(stream.outputTotal);
        end_(&stream);
        return result;
    }

private:
    int (*init_)(Stream*, int, int, int, int, int, const char*, int) =
        library.find<int (*)(Stream*, int, int, int, int, int, const char*, int)>("deflateInit2_");
    int (*deflate_)(Stream*, int) = library.find<int (*)(Stream*, int)>("deflate");
    int (*end_)(Stream*) = library.find<int (*)(Stream*)>("deflateEnd");
};

class PngWriter {
public:
    explicit PngWriter(const std::string& path) : file_(path, std::ios::binary) { require(file_.good(), "cannot write " + path); }

    void write(const std::vector<unsigned char>& rgba, int width, int height)
    {
        constexpr int stripRows = 48;
        const auto strips = static_cast<std::size_t>((height + stripRows - 1) / stripRows);
        std::vector<std::vector<unsigned char>> filtered(strips), packed(strips);
        const auto work = [&](std::size_t first, std::size_t step) {
            for (std::size_t i = first; i < strips; i += step) {
                const int top = static_cast<int>(i) * stripRows;
                filtered[i] = filter(rgba, width, top, std::min(top + stripRows, height));
                packed[i] = zlib_.packed(filtered[i], i + 1 == strips);
            }
        };
        const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
        std::vector<std::thread> threads;
        for (std::size_t i = 1; i < workers; i++) threads.emplace_back(work, i, workers);
        work(0, workers);
        for (std::thread& thread : threads) thread.join();

        std::vector<unsigned char> data{0x78, 0x01};
        unsigned long checksum = 1;
        for (std::size_t i = 0; i < strips; i++) {
            checksum = zlib_.adler32(checksum, filtered[i].data(), static_cast<unsigned>(filtered[i].size()));
            data.insert(data.end(), packed[i].begin(), packed[i].end());
        }
        append(data, checksum);
        std::vector<unsigned char> header;
        append(header, static_cast<unsigned long>(width));
        append(header, static_cast<unsigned long>(height));
        header.insert(header.end(), {8, 2, 0, 0, 0});
        file_.write("\x89PNG\r\n\x1a\n", 8);
        chunk("IHDR", header);
        chunk("IDAT", data);
        chunk("IEND", {});
        require(file_.flush().good(), "the picture cannot be written");
    }

private:
    static std::vector<unsigned char> filter(const std::vector<unsigned char>& rgba, int width, int top, int end)
    {
        std::vector<unsigned char> rows;
        rows.reserve(static_cast<std::size_t>(end - top) * (1 + 3 * static_cast<std::size_t>(width)));
        for (int y = top; y < end; y++) {
            rows.push_back(1);
            unsigned char left[3] = {0, 0, 0};
            const unsigned char* pixel = rgba.data() + 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(y);
            for (int x = 0; x < width; x++, pixel += 4) {
                for (int channel = 0; channel < 3; channel++) {
                    rows.push_back(static_cast<unsigned char>(pixel[channel] - left[channel]));
                    left[channel] = pixel[channel];
                }
            }
        }
        return rows;
    }

    static void append(std::vector<unsigned char>& bytes, unsigned long number)
    {
        for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<unsigned char>(number >> shift));
    }

    void chunk(const char* type, const std::vector<unsigned char>& content)
    {
        std::vector<unsigned char> bytes(type, type + 4);
        bytes.insert(bytes.end(), content.begin(), content.end());
        std::vector<unsigned char> size, checksum;
        append(size, content.size());
        append(checksum, zlib_.crc32(0, bytes.data(), static_cast<unsigned>(bytes.size())));
        for (const auto* part : {&size, &bytes, &checksum})
            file_.write(reinterpret_cast<const char*>(part->data()), static_cast<std::streamsize>(part->size()));
    }

    std::ofstream file_;
    Zlib zlib_;
};
