// Models: OBJ with its MTL and its PNGs. Written from the formats' descriptions.
#pragma once

#include "texture.h"

#include <array>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Material {
    std::shared_ptr<Texture> diffuse, specular, emissive;
    double shininess = 0;
};

struct Vertex {
    glm::dvec3 position{0}, normal{0};
    glm::dvec2 texCoord{0};
};

struct Triangle {
    std::array<Vertex, 3> corners;
    std::shared_ptr<Material> material;
};

using Model = std::vector<Triangle>;

inline std::ifstream opened(const std::string& file)
{
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file);
    return in;
}

inline std::map<std::string, std::shared_ptr<Material>> readMaterials(const std::string& file)
{
    const std::string folder = file.substr(0, file.find_last_of('/') + 1);
    std::map<std::string, std::shared_ptr<Material>> materials;
    std::map<std::string, std::shared_ptr<Texture>> textures;
    std::shared_ptr<Material> material;
    std::ifstream in = opened(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key, value;
        if (!(words >> key)) continue;
        const auto map = [&](std::shared_ptr<Texture>& slot) {
            words >> value;
            if (!textures[value]) textures[value] = std::make_shared<Texture>(folder + value);
            slot = textures[value];
        };
        const auto color = [&](std::shared_ptr<Texture>& slot) {
            glm::dvec3 rgb(0);
            words >> rgb.x >> rgb.y >> rgb.z;
            if (!slot) slot = std::make_shared<Texture>(rgb);
        };
        if (key == "newmtl" && words >> value) material = materials[value] = std::make_shared<Material>();
        else if (key == "Ns") words >> material->shininess;
        else if (key == "Kd") color(material->diffuse);
        else if (key == "Ks") color(material->specular);
        else if (key == "Ke") color(material->emissive);
        else if (key == "map_Kd") map(material->diffuse);
        else if (key == "map_Ks") map(material->specular);
        else if (key == "map_Ke") map(material->emissive);
    }
    return materials;
}

// Number `index` of a list as OBJ counts: from 1, or back from the end.
template <typename T> const T& numbered(const std::vector<T>& list, long index)
{
    return list.at(index > 0 ? index - 1 : list.size() + index);
}

inline Model readModel(const std::string& file)
{
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec2> texCoords;
    std::map<std::string, std::shared_ptr<Material>> materials;
    std::shared_ptr<Material> material;
    Model model;
    std::ifstream in = opened(file);
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key, word;
        words >> key;
        // Coordinates are single precision in the program, as in any OpenGL vertex.
        float x = 0, y = 0, z = 0;
        if (key == "v" && words >> x >> y >> z) positions.emplace_back(x, y, z);
        else if (key == "vn" && words >> x >> y >> z) normals.emplace_back(x, y, z);
        else if (key == "vt" && words >> x >> y) texCoords.emplace_back(x, y);
        else if (key == "mtllib" && words >> word) materials = readMaterials(file.substr(0, file.find_last_of('/') + 1) + word);
        else if (key == "usemtl" && words >> word) material = materials.at(word);
        else if (key == "f") {
            std::vector<Vertex> corners;
            while (words >> word) {
                long p = 0, t = 0, n = 0;
                if (std::sscanf(word.c_str(), "%ld/%ld/%ld", &p, &t, &n) != 3) throw std::runtime_error(file + ": a face without all three indices");
                corners.push_back({numbered(positions, p), numbered(normals, n), numbered(texCoords, t)});
            }
            for (std::size_t i = 2; i < corners.size(); i++) model.push_back({{corners[0], corners[i - 1], corners[i]}, material});
        }
    }
    return model;
}
