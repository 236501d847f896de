// The C++ twin of the renderer: the same frame drawn by the same driver with the same shaders, meshes and textures, without a JVM. It is
// the limit of what our program can reach, and its picture is ours to the byte.
//
//     g++ -std=c++17 -O2 -o build/twin tests/glm/twin.cpp -ldl -pthread
//     build/twin RECORDING [OPTION]...
//
//     --context osmesa|egl   where OpenGL comes from; default: osmesa
//     --own                  compute matrices and lights with GLM, and report how far they are from the recorded ones
//     --back-faces           draw those as well
//     --frames N             draw N frames more, and say how long each takes: milliseconds of the clock, and of this thread
//     --out FILE             the picture: .png, or anything else for plain bytes, red green blue alpha, from the top left
//
// The recording is made by cga.measure.twin; it names the cooked files that it needs.

#include "twin/context.h"
#include "twin/png.h"
#include "twin/recording.h"
#include "twin/renderer.h"
#include "twin/scene.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>

struct Options {
    std::string recording;
    std::string context = "osmesa";
    std::string out;
    bool own = false;
    bool backFaces = false;
    int frames = 0;
};

static Options optionsOf(int count, char** words)
{
    Options options;
    for (int i = 1; i < count; i++) {
        const std::string word = words[i];
        const auto value = [&] {
            require(++i < count, word + " wants a value");
            return std::string(words[i]);
        };
        if (word == "--own") options.own = true;
        else if (word == "--back-faces") options.backFaces = true;
        else if (word == "--context") options.context = value();
        else if (word == "--frames") options.frames = std::atoi(value().c_str());
        else if (word == "--out") options.out = value();
        else options.recording = word;
    }
    require(!options.recording.empty(), "usage: twin RECORDING [--context osmesa|egl] [--own] [--back-faces] [--frames N] [--out FILE]");
    require(options.context == "osmesa" || options.context == "egl", "--context is osmesa or egl, not " + options.context);
    return options;
}

// "difference UNIFORM LARGEST": in units of the recorded uniform's largest number.
static void reportDifferences(const std::vector<Call>& recorded, const std::vector<Call>& own)
{
    std::map<std::string, double> worst;
    for (std::size_t i = 0; i < recorded.size(); i++) {
        double size = 0, difference = 0;
        for (std::size_t k = 0; k < 16; k++) {
            size = std::max(size, std::abs(double(recorded[i].values[k])));
            difference = std::max(difference, std::abs(double(recorded[i].values[k]) - double(own[i].values[k])));
        }
        if (difference > 0) worst[recorded[i].name] = std::max(worst[recorded[i].name], difference / size);
    }
    for (const auto& [name, difference] : worst) std::printf("difference %s %.3g\n", name.c_str(), difference);
}

static double threadMilliseconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

// "frame CLOCK THREAD", from the first matrix to the last pixel.
static void timeFrames(const Renderer& renderer, const Scene& scene, std::vector<Call> calls, const Options& options)
{
    for (int frame = 0; frame < options.frames; frame++) {
        const double thread = threadMilliseconds();
        const auto start = std::chrono::steady_clock::now();
        if (options.own) scene.compute(calls);
        renderer.draw(calls);
        glFinish();
        const std::chrono::duration<double, std::milli> clock = std::chrono::steady_clock::now() - start;
        std::printf("frame %.4f %.4f\n", clock.count(), threadMilliseconds() - thread);
    }
}

static void save(const std::vector<unsigned char>& pixels, const Recording& recording, const std::string& path)
{
    if (path.size() > 4 && path.substr(path.size() - 4) == ".png") {
        PngWriter(path).write(pixels, recording.width, recording.height);
        return;
    }
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(pixels.data()), static_cast<std::streamsize>(pixels.size()));
    require(file.flush().good(), "cannot write " + path);
}

static void run(const Options& options)
{
    const Recording recording = readRecording(options.recording);
    if (options.context == "egl") openEgl();
    else openOsMesa();
    const Renderer renderer(recording, options.backFaces);
    const Scene scene(recording.parameters);
    std::vector<Call> calls = recording.calls;
    if (options.own) {
        scene.compute(calls);
        reportDifferences(recording.calls, calls);
    }
    renderer.draw(calls);
    if (!options.out.empty()) save(renderer.read(), recording, options.out);
    timeFrames(renderer, scene, calls, options);
}

int main(int count, char** words)
{
    try {
        run(optionsOf(count, words));
        std::fflush(stdout);
        // The driver's threads and the mapped files go with the process.
        std::_Exit(0);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "twin: %s\n", e.what());
        return 2;
    }
}
