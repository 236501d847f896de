// The scene of sheet 4, as the sheet and the design describe it: numbers written down a second time, on purpose.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

struct Light {
    glm::dvec3 position; // view space
    glm::dvec3 color;
    glm::dvec3 k{1, 0, 0};
    bool hasCone = false;
    glm::dvec3 direction{0}; // view space
    double inner = 0, outer = 0;
};

class Scene {
public:
    Scene(const std::string& step, double t, double mouse, double aspect) : aspect(aspect), number_(numberOf(step)), t_(t)
    {
        const double turn = from(orbit) ? 0.002 * mouse : 0;
        glm::dmat4 camera = motorcycle();
        camera = glm::rotate(camera, turn, glm::dvec3(0, 1, 0));
        camera = glm::rotate(camera, degrees(-35), glm::dvec3(1, 0, 0));
        camera = glm::translate(camera, glm::dvec3(0, 0, 4));
        const glm::dvec3 eye(camera[3]);
        view = glm::lookAt(eye, eye - glm::dvec3(camera[2]), glm::dvec3(camera[1]));
        if (from(pointLight)) addPointLight(glm::dvec3(motorcycle() * glm::dvec4(0, 1.6, 0, 1)), motorcycleTint());
        if (from(moreLights)) {
            addPointLight({-16, 1.2, -16}, {16, 1, 0.5});
            addPointLight({16, 1.2, -16}, {0.5, 2, 16});
            addPointLight({-16, 1.2, 16}, {14, 9, 0.5});
            addPointLight({16, 1.2, 16}, {13, 0.5, 10});
        }
        if (from(spotLight)) addSpotLight();
        usesHalfVector = from(blinnPhong);
    }

    glm::dmat4 motorcycle() const { return glm::scale(glm::dmat4(1), glm::dvec3(0.8f)); }
    glm::dvec3 groundTint() const { return from(color) ? glm::dvec3(0, 1, 0) : glm::dvec3(1); }

    glm::dvec3 motorcycleTint() const
    {
        return from(color) ? glm::abs(glm::dvec3(std::sin(t_), std::sin(t_ / 2), std::sin(t_ / 3))) : glm::dvec3(1);
    }

    glm::dmat4 view{1};
    std::vector<Light> lights;
    bool usesHalfVector = false;
    double aspect;
    static constexpr double near = 0.1, far = 100, tangent = 1; // of half the field of view of 90 degrees

private:
    enum Step { emission, pointLight, spotLight, attenuation, color, orbit, moreLights, blinnPhong };

    static int numberOf(const std::string& step)
    {
        const std::vector<std::string> steps{"4.1", "4.2", "4.3", "4.3.4", "4.4", "4.5", "4.6", "4.7"};
        for (std::size_t i = 0; i < steps.size(); i++)
            if (steps[i] == step) return int(i);
        throw std::runtime_error("there is no step " + step);
    }

    bool from(Step step) const { return number_ >= step; }
    static double degrees(double angle) { return angle * std::acos(-1.0) / 180; }

    void addPointLight(glm::dvec3 world, glm::dvec3 rgb)
    {
        Light light;
        light.position = glm::dvec3(view * glm::dvec4(world, 1));
        light.color = rgb;
        if (from(attenuation)) light.k = {1, 0.5, 0.1};
        lights.push_back(light);
    }

    void addSpotLight()
    {
        Light light;
        light.position = glm::dvec3(view * motorcycle() * glm::dvec4(0, 0.64, -1.8, 1));
        light.color = {1.3, 1.3, 1.17};
        if (from(attenuation)) light.k = {0.5, 0.05, 0.01};
        light.hasCone = true;
        const glm::dmat4 tilt = glm::rotate(glm::dmat4(1), degrees(-14), glm::dvec3(1, 0, 0));
        light.direction = glm::normalize(glm::dvec3(view * motorcycle() * tilt * glm::dvec4(0, 0, -1, 0)));
        light.inner = degrees(13);
        light.outer = degrees(66);
        lights.push_back(light);
    }

    int number_;
    double t_;
};
