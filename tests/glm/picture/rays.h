// Pictures by rays: for each pixel the nearest triangle that the ray through its centre hits from the front, and the formula of the sheet.
#pragma once

#include "model.h"
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

class Picture {
public:
    Picture(int width, int height, const Scene& scene)
        : width_(width), height_(height), scene_(scene), depth_(width * height, std::numeric_limits<double>::infinity()), rgb_(width * height)
    {
    }

    // Adds a model: local space -> world space by `place`.
    void draw(const Model& model, const glm::dmat4& place, glm::dvec3 tint, double repeats)
    {
        const glm::dmat4 toView = scene_.view * place;
        const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(toView)));
        for (const Triangle& triangle : model) {
            Triangle seen = triangle;
            for (Vertex& corner : seen.corners) {
                corner.position = glm::dvec3(toView * glm::dvec4(corner.position, 1));
                corner.normal = normals * corner.normal;
                corner.texCoord *= repeats;
            }
            draw(seen, tint);
        }
    }

    void write(const char* file) const
    {
        std::FILE* out = std::fopen(file, "wb");
        if (!out) throw std::runtime_error(std::string("cannot write ") + file);
        for (const glm::dvec3& color : rgb_) std::fwrite(&color[0], sizeof(double), 3, out);
        if (std::fclose(out) != 0) throw std::runtime_error(std::string("cannot write ") + file);
    }

private:
    // The triangle's plane and what turns a point of it into barycentric coordinates.
    struct Plane {
        glm::dvec3 origin, edge1, edge2, normal;

        explicit Plane(const Triangle& t)
            : origin(t.corners[0].position), edge1(t.corners[1].position - origin), edge2(t.corners[2].position - origin),
              normal(glm::cross(edge1, edge2))
        {
        }

        // How a step along the plane changes the weights of the three corners.
        glm::dvec3 weights(glm::dvec3 step) const
        {
            const double size = glm::dot(normal, normal);
            const double b1 = glm::dot(glm::cross(step, edge2), normal) / size, b2 = glm::dot(glm::cross(edge1, step), normal) / size;
            return {-b1 - b2, b1, b2};
        }
    };

    void draw(const Triangle& triangle, glm::dvec3 tint)
    {
        int left = 0, right = width_ - 1, top = 0, bottom = height_ - 1;
        bound(triangle, left, right, top, bottom);
        const Plane plane(triangle);
        for (int y = top; y <= bottom; y++)
            for (int x = left; x <= right; x++) hit(triangle, plane, x, y, tint);
    }

    // The pixels that the triangle may cover: all, where it reaches behind the near plane.
    void bound(const Triangle& triangle, int& left, int& right, int& top, int& bottom) const
    {
        double minX = 1e9, maxX = -1e9, minY = 1e9, maxY = -1e9;
        for (const Vertex& corner : triangle.corners) {
            const glm::dvec3 p = corner.position;
            if (p.z > -Scene::near) return;
            const double x = (p.x / -p.z / (Scene::tangent * scene_.aspect) + 1) / 2 * width_;
            const double y = (1 - p.y / -p.z / Scene::tangent) / 2 * height_;
            minX = std::min(minX, x), maxX = std::max(maxX, x), minY = std::min(minY, y), maxY = std::max(maxY, y);
        }
        left = std::max(left, int(std::floor(minX)) - 1), right = std::min(right, int(std::ceil(maxX)) + 1);
        top = std::max(top, int(std::floor(minY)) - 1), bottom = std::min(bottom, int(std::ceil(maxY)) + 1);
    }

    void hit(const Triangle& triangle, const Plane& plane, int x, int y, glm::dvec3 tint)
    {
        const glm::dvec3 dx(2.0 / width_ * Scene::tangent * scene_.aspect, 0, 0), dy(0, 2.0 / height_ * Scene::tangent, 0);
        const glm::dvec3 ray = glm::dvec3(-Scene::tangent * scene_.aspect, Scene::tangent, -1) + (x + 0.5) * dx - (y + 0.5) * dy;
        const double towards = glm::dot(plane.normal, ray);
        if (!(towards < 0)) return; // a back face, or one that is seen from its edge
        const double distance = glm::dot(plane.normal, plane.origin) / towards;
        double& nearest = depth_[y * width_ + x];
        if (distance < Scene::near || distance > Scene::far || distance >= nearest) return;
        const glm::dvec3 point = distance * ray;
        const glm::dvec3 b = glm::dvec3(1, 0, 0) + plane.weights(point - plane.origin);
        if (b.x < 0 || b.y < 0 || b.z < 0) return;
        nearest = distance;
        // The point moves with the ray, and nearer or farther along it.
        const auto step = [&](glm::dvec3 d) { return plane.weights(distance * d - ray * (distance * glm::dot(plane.normal, d) / towards)); };
        rgb_[y * width_ + x] = shade(triangle, point, b, step(dx), step(dy), tint);
    }

    glm::dvec3 shade(const Triangle& t, glm::dvec3 point, glm::dvec3 b, glm::dvec3 bx, glm::dvec3 by, glm::dvec3 tint) const
    {
        glm::dvec3 n(0);
        glm::dvec2 at(0), dx(0), dy(0);
        for (int i = 0; i < 3; i++) {
            n += b[i] * t.corners[i].normal;
            at += b[i] * t.corners[i].texCoord;
            dx += bx[i] * t.corners[i].texCoord;
            dy += by[i] * t.corners[i].texCoord;
        }
        n = glm::normalize(n);
        const glm::dvec3 v = glm::normalize(-point);
        const glm::dvec3 diffuse = t.material->diffuse->sample(at, dx, dy), specular = t.material->specular->sample(at, dx, dy);
        glm::dvec3 color = t.material->emissive->sample(at, dx, dy) * tint;
        for (const Light& light : scene_.lights) {
            const double d = glm::length(light.position - point);
            const glm::dvec3 l = (light.position - point) / d;
            const glm::dvec3 between = scene_.usesHalfVector ? glm::normalize(l + v) : glm::reflect(-l, n);
            const double cosBeta = scene_.usesHalfVector ? glm::dot(n, between) : glm::dot(between, v);
            const double shine = cosBeta > 0 ? std::pow(cosBeta, t.material->shininess) : 0;
            const double strength = cone(light, -l) / (light.k.x + light.k.y * d + light.k.z * d * d);
            color += strength * (diffuse * std::max(glm::dot(n, l), 0.0) + specular * shine) * light.color;
        }
        return color;
    }

    static double cone(const Light& light, glm::dvec3 fromLight)
    {
        if (!light.hasCone) return 1;
        const double outer = std::cos(light.outer), inner = std::cos(light.inner);
        return glm::clamp((glm::dot(fromLight, light.direction) - outer) / (inner - outer), 0.0, 1.0);
    }

    int width_, height_;
    const Scene& scene_;
    std::vector<double> depth_;
    std::vector<glm::dvec3> rgb_;
};
