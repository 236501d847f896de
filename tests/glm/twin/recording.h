// A frame that our renderer drew, as cga.measure.twin.Recording writes it: a line of text each for what is set up, and after the line
// "frame" for what is sent in each frame. Numbers are C's hexadecimal ones, right to the bit.
#pragma once

#include "error.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

struct RecordedTexture {
    std::string file;
    std::array<int, 4> parameters; // wrap s and t, filter for smaller and for larger
};

// One call of a frame.
struct Call {
    enum Kind { integer, floats1, floats2, floats3, matrix3, matrix4, texture, draw } kind;
    std::string name;           // of the uniform
    int number = 0;             // its value, the texture unit, or the model drawn
    int index = 0;              // the texture, or the mesh of the model
    std::array<float, 16> values{};
};

struct Recording {
    int width = 0;
    int height = 0;
    int samples = 0;
    std::string vertexShader;
    std::string fragmentShader;
    std::map<std::string, int> constants;
    std::vector<std::string> models;
    std::vector<RecordedTexture> textures;
    std::map<std::string, double> parameters;
    std::vector<Call> calls;
};

inline double parsed(std::istream& line)
{
    std::string text;
    line >> text;
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    require(!text.empty() && *end == '\0', "'" + text + "' is no number");
    return value;
}

inline Call uniformOf(std::istream& line)
{
    static const std::map<std::string, std::pair<Call::Kind, int>> types{
        {"f1", {Call::floats1, 1}}, {"f2", {Call::floats2, 2}}, {"f3", {Call::floats3, 3}},
        {"m3", {Call::matrix3, 9}}, {"m4", {Call::matrix4, 16}},
    };
    Call call{};
    std::string type;
    line >> type >> call.name;
    if (type == "i1") {
        call.kind = Call::integer;
        line >> call.number;
        return call;
    }
    const auto found = types.find(type);
    require(found != types.end(), "'" + type + "' is no type of a uniform");
    call.kind = found->second.first;
    for (int i = 0; i < found->second.second; i++) call.values[static_cast<std::size_t>(i)] = static_cast<float>(parsed(line));
    return call;
}

inline Call numbered(Call::Kind kind, std::istream& line)
{
    Call call{};
    call.kind = kind;
    line >> call.number >> call.index;
    return call;
}

inline Recording readRecording(const std::string& path)
{
    std::ifstream file(path);
    require(file.good(), "cannot read " + path);
    Recording recording;
    std::string text;
    std::getline(file, text);
    require(text == "cga-twin 1", path + " is no recording of this version");
    for (int number = 2; std::getline(file, text); number++) {
        std::istringstream line(text);
        std::string word;
        line >> word;
        if (word == "size") line >> recording.width >> recording.height;
        else if (word == "samples") line >> recording.samples;
        else if (word == "vertex-shader") std::getline(line >> std::ws, recording.vertexShader);
        else if (word == "fragment-shader") std::getline(line >> std::ws, recording.fragmentShader);
        else if (word == "constant") { std::string name; line >> name; line >> recording.constants[name]; }
        else if (word == "model") std::getline(line >> std::ws, recording.models.emplace_back());
        else if (word == "texture") {
            RecordedTexture& texture = recording.textures.emplace_back();
            for (int& parameter : texture.parameters) line >> parameter;
            std::getline(line >> std::ws, texture.file);
        }
        else if (word == "parameter") { std::string name; line >> name; recording.parameters[name] = parsed(line); }
        else if (word == "uniform") recording.calls.push_back(uniformOf(line));
        else if (word == "bind") recording.calls.push_back(numbered(Call::texture, line));
        else if (word == "draw") recording.calls.push_back(numbered(Call::draw, line));
        else require(word == "frame", path + ":" + std::to_string(number) + ": what is '" + word + "'?");
        require(!line.fail(), path + ":" + std::to_string(number) + " is not complete");
    }
    return recording;
}
