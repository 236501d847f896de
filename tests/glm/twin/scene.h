// The scene's matrices and lights computed by GLM, the way a course teaches it: single precision throughout, and glm's own inverse for
// the normals. What of the scene is meant, and its constants, is in cga.exercise.game.
#pragma once

#if !__has_include(<glm/glm.hpp>)
#error "needs GLM: apt-get install libglm-dev"
#endif
#include "recording.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

class Scene {
public:
    explicit Scene(const std::map<std::string, double>& parameters) : parameters_(parameters) {}

    // Puts GLM's numbers in the place of the recorded ones, wherever a call sends a matrix or a place.
    void compute(std::vector<Call>& calls) const
    {
        const glm::mat4 motorcycle = ride();
        const glm::mat4 view = viewOf(motorcycle * orbit());
        const std::string spot = spotOf(calls);
        const decltype(Call::values) none{};
        int objects = 0;
        glm::mat4 modelView(1);
        for (Call& call : calls) {
            if (call.name == "projection") {
                put(call, glm::perspective(number("fieldOfView"), number("aspect"), number("near"), number("far")));
            } else if (call.name == "modelView") {
                modelView = objects++ == 0 ? view : view * motorcycle; // the ground does not move
                put(call, modelView);
            } else if (call.name == "normalMatrix") {
                put(call, normalMatrix(modelView));
            } else if (call.name == light(0) + ".position") {
                put(call, glm::vec3(view * motorcycle * glm::vec4(0, 1.6f, 0, 1)));
            } else if (call.name == spot + ".position") {
                put(call, glm::vec3(view * motorcycle * glm::vec4(0, 0.64f, -1.8f, 1)));
            } else if (call.name.rfind("light[", 0) == 0 && call.name.find("].position") != std::string::npos) {
                put(call, glm::vec3(view * glm::vec4(corner(call.name[6] - '1'), 1)));
            } else if (call.name == spot + ".direction" && call.values != none) {
                // A spotlight sends all that a point light does, no direction, and then its own.
                const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(-14.0f), glm::vec3(1, 0, 0));
                put(call, glm::normalize(glm::vec3(view * motorcycle * turn * glm::vec4(0, 0, -1, 0))));
            }
        }
    }

private:
    static std::string light(int index) { return "light[" + std::to_string(index) + "]"; }

    // The light with a cone: 1 - cos of an angle, which is at most 1; those of point lights are larger.
    static std::string spotOf(const std::vector<Call>& calls)
    {
        for (const Call& call : calls)
            if (call.name.find("].cone") != std::string::npos && call.values[0] <= 1) return call.name.substr(0, call.name.find('.'));
        return "none";
    }

    float number(const char* name) const
    {
        const auto found = parameters_.find(name);
        require(found != parameters_.end(), std::string("the recording has no parameter ") + name);
        return static_cast<float>(found->second);
    }

    glm::mat4 ride() const
    {
        const glm::mat4 place = glm::translate(glm::mat4(1), glm::vec3(number("x"), 0, number("z")));
        return glm::scale(glm::rotate(place, number("heading"), glm::vec3(0, 1, 0)), glm::vec3(0.8f));
    }

    glm::mat4 orbit() const
    {
        const glm::mat4 turn = glm::rotate(glm::mat4(1), number("orbit"), glm::vec3(0, 1, 0));
        return glm::translate(glm::rotate(turn, glm::radians(-35.0f), glm::vec3(1, 0, 0)), glm::vec3(0, 0, 4));
    }

    // Rigid, though the motorcycle that carries the camera is scaled.
    static glm::mat4 viewOf(const glm::mat4& camera)
    {
        const glm::vec3 eye(camera[3]);
        return glm::lookAt(eye, eye - glm::vec3(camera[2]), glm::vec3(camera[1]));
    }

    // Its length is nothing to the shader; ours has 1 for the largest element, and so has this.
    static glm::mat3 normalMatrix(const glm::mat4& modelView)
    {
        const glm::mat3 inverse = glm::inverseTranspose(glm::mat3(modelView));
        float largest = 0;
        for (int column = 0; column < 3; column++)
            for (int row = 0; row < 3; row++) largest = std::max(largest, std::abs(inverse[column][row]));
        return inverse / largest;
    }

    static glm::vec3 corner(int index) { return {index % 2 == 0 ? -16 : 16, 1.2f, index < 2 ? -16 : 16}; }

    static void put(Call& call, const glm::mat4& m) { std::copy_n(glm::value_ptr(m), 16, call.values.begin()); }
    static void put(Call& call, const glm::mat3& m) { std::copy_n(glm::value_ptr(m), 9, call.values.begin()); }
    static void put(Call& call, const glm::vec3& v) { std::copy_n(glm::value_ptr(v), 3, call.values.begin()); }

    const std::map<std::string, double>& parameters_;
};
