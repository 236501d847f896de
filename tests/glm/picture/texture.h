// Textures: PNGs by libpng, mip levels, and sampling by OpenGL 3.3 core, section 3.8.11: trilinear, repeating.
#pragma once

#if !__has_include(<glm/glm.hpp>)
#error "needs GLM: apt-get install libglm-dev"
#endif
#if !__has_include(<png.h>)
#error "needs libpng: apt-get install libpng-dev"
#endif
#include <glm/glm.hpp>
#include <png.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

class Texture {
public:
    explicit Texture(glm::dvec3 color) : levels_{{1, 1, {color}}} {}

    explicit Texture(const std::string& file)
    {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        if (!png_image_begin_read_from_file(&image, file.c_str())) throw std::runtime_error(file + ": " + image.message);
        image.format = PNG_FORMAT_RGB;
        std::vector<png_byte> bytes(PNG_IMAGE_SIZE(image));
        if (!png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr)) throw std::runtime_error(file + ": " + image.message);
        const int width = int(image.width), height = int(image.height);
        std::vector<glm::dvec3> texels(width * height);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                const png_byte* texel = &bytes[3 * ((height - 1 - y) * width + x)];
                texels[y * width + x] = glm::dvec3(texel[0], texel[1], texel[2]) / 255.0;
            }
        makeLevels(width, height, texels);
    }

    // At the texture coordinates `at`, which change by dx to the pixel on the right and by dy to the one above.
    glm::dvec3 sample(glm::dvec2 at, glm::dvec2 dx, glm::dvec2 dy) const
    {
        const glm::dvec2 size(levels_[0].width, levels_[0].height);
        const double lambda = std::log2(std::max(glm::length(dx * size), glm::length(dy * size)));
        const int last = int(levels_.size()) - 1;
        if (!(lambda > 0)) return levels_[0].bilinear(at);
        if (lambda >= last) return levels_[last].bilinear(at);
        const int larger = int(lambda);
        return glm::mix(levels_[larger].bilinear(at), levels_[larger + 1].bilinear(at), lambda - larger);
    }

private:
    struct Level {
        int width, height;
        std::vector<glm::dvec3> texels;

        glm::dvec3 bilinear(glm::dvec2 at) const
        {
            const double u = at.x * width - 0.5, v = at.y * height - 0.5;
            const double i = std::floor(u), j = std::floor(v);
            const glm::dvec3 below = glm::mix(texel(i, j), texel(i + 1, j), u - i);
            const glm::dvec3 above = glm::mix(texel(i, j + 1), texel(i + 1, j + 1), u - i);
            return glm::mix(below, above, v - j);
        }

        const glm::dvec3& texel(double i, double j) const
        {
            const double x = i - width * std::floor(i / width), y = j - height * std::floor(j / height);
            return texels[int(y) * width + int(x)];
        }
    };

    // Level n from blocks of the whole picture: the mean of 2^n x 2^n texels, in steps of 1/255 and to the even one in the middle. Our
    // pictures have sides that are powers of 2.
    void makeLevels(int width, int height, const std::vector<glm::dvec3>& full)
    {
        levels_.push_back({width, height, full});
        for (int w = width, h = height; w > 1 || h > 1;) {
            w = std::max(1, w / 2);
            h = std::max(1, h / 2);
            Level level{w, h, std::vector<glm::dvec3>(w * h)};
            const int across = width / w, up = height / h;
            for (int y = 0; y < height; y++)
                for (int x = 0; x < width; x++) level.texels[y / up * w + x / across] += 255.0 * full[y * width + x];
            // Sums of whole numbers, but for the rounding of what was divided by 255.
            for (glm::dvec3& texel : level.texels)
                for (int c = 0; c < 3; c++) texel[c] = std::nearbyint(std::round(texel[c]) / (across * up)) / 255.0;
            levels_.push_back(level);
        }
    }

    std::vector<Level> levels_;
};
