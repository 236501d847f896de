// The matrices and light factors of the exercise, computed by GLM: the oracle that our Kotlin is compared with.
//
//     g++ -std=c++17 -ffp-contract=off -o build/oracle tests/glm/oracle.cpp && build/oracle > tests/glm/oracle.txt
//
// Every operation is written once and computed in three precisions: long double is the truth, double and float are GLM's
// figures for it. The output has one line a case: operation; kind of case; inputs; long double (rounded to double); double; float.
// Inputs are floats, and all numbers are hexadecimal, so that whoever reads them starts from the same bits.
//
// Conventions, GLM's as well as OpenGL's and JOML's: matrices are stored by columns, m[column][row]; vectors are columns and
// stand to the right of the matrix, so in parent * child the child's matrix acts first; axes are right-handed, the camera looks
// along -z, depth in clip space runs from -1 to 1; angles are radians.

#if !__has_include(<glm/glm.hpp>)
#error "needs GLM: apt-get install libglm-dev"
#endif
#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

static_assert(std::numeric_limits<long double>::digits >= 64, "here long double is no better than double, and no truth for it");

template <typename T> using vec3 = glm::vec<3, T>;
template <typename T> using mat3 = glm::mat<3, 3, T>;
template <typename T> using mat4 = glm::mat<4, 4, T>;

// ---------------------------------------------------------------- What is computed

// Turns about the object's own x, then y, then z axis.
template <typename T> mat4<T> rotation(vec3<T> angles)
{
    mat4<T> m = glm::rotate(mat4<T>(1), angles.x, vec3<T>(1, 0, 0));
    m = glm::rotate(m, angles.y, vec3<T>(0, 1, 0));
    return glm::rotate(m, angles.z, vec3<T>(0, 0, 1));
}

// Local space -> parent's space: scaled first, then turned, then moved.
template <typename T> mat4<T> placing(vec3<T> position, vec3<T> angles, vec3<T> scale)
{
    return glm::scale(glm::translate(mat4<T>(1), position) * rotation(angles), scale);
}

// Moved, turned, and then moved along its own axes.
template <typename T> mat4<T> moving(vec3<T> position, vec3<T> angles, vec3<T> move)
{
    return glm::translate(glm::translate(mat4<T>(1), position) * rotation(angles), move);
}

// What stands at a position, turned about a point: the point goes to the origin, and back after the turn.
template <typename T> mat4<T> turnAboutPoint(vec3<T> position, vec3<T> angles, vec3<T> point)
{
    mat4<T> turn = glm::translate(mat4<T>(1), point) * rotation(angles) * glm::translate(mat4<T>(1), -point);
    return turn * glm::translate(mat4<T>(1), position);
}

// World space -> view space the way courses teach it: look from the camera's position to a point before it.
template <typename T> mat4<T> camera(vec3<T> position, vec3<T> angles)
{
    mat4<T> turn = rotation(angles);
    return glm::lookAt(position, position - vec3<T>(turn[2]), vec3<T>(turn[1]));
}

// The sheet's spotlight: 1 in the inner cone, 0 outside the outer one, linear in the cosine between them.
template <typename T> T coneOfCosines(vec3<T> fromLight, vec3<T> axis, T inner, T outer)
{
    T cosine = glm::dot(glm::normalize(fromLight), glm::normalize(axis));
    return glm::clamp((cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), T(0), T(1));
}

// 1 - cos(angle), without the subtraction.
template <typename T> T versine(T angle)
{
    return 2 * std::sin(angle / 2) * std::sin(angle / 2);
}

// The same factor from versines; that of the angle between two unit vectors is half the square of their difference.
template <typename T> T coneOfVersines(vec3<T> fromLight, vec3<T> axis, T inner, T outer)
{
    vec3<T> chord = glm::normalize(fromLight) - glm::normalize(axis);
    return glm::clamp((versine(outer) - glm::dot(chord, chord) / 2) / (versine(outer) - versine(inner)), T(0), T(1));
}

// How much of a light arrives over a distance; k holds the constant, linear and quadratic coefficient.
template <typename T> T attenuation(vec3<T> toLight, vec3<T> k)
{
    T d = glm::length(toLight);
    return 1 / (k.x + k.y * d + k.z * d * d);
}

// ---------------------------------------------------------------- Cases

struct Case {
    std::string kind;
    std::vector<float> inputs;

    Case& with(float number)
    {
        inputs.push_back(number);
        return *this;
    }
    Case& with(glm::vec3 v) { return with(v.x).with(v.y).with(v.z); }
};
using Cases = std::vector<Case>;

// Its numbers are laid down to the bit, unlike those of std's distributions: the same cases on every machine.
std::mt19937 dice;

// To begin with. Every operation's dice fall anew, so that a case added to one changes no other's.
Cases none()
{
    dice.seed(1);
    return {};
}

// A multiple of 2^-24 in [0, 1).
float unit() { return float(dice() >> 8) * 0x1p-24f; }

float within(float low, float high) { return low + (high - low) * unit(); }

int integer(int low, int high) { return low + int(dice() % unsigned(high - low + 1)); }

// A number from 2^low to 2^(high + 1): no library's pow, which would round as it likes. Here and below every draw is a statement
// of its own where there are several, for C++ leaves open in which order it takes the operands of a sum or a product.
float magnitude(int low, int high)
{
    float mantissa = 1 + unit();
    return std::ldexp(mantissa, integer(low, high));
}

float sign() { return integer(0, 1) ? 1.0f : -1.0f; }

float signedMagnitude(int low, int high)
{
    float size = magnitude(low, high);
    return sign() * size;
}

const float RIGHT_ANGLE = 0x1.921fb6p+0f;

float anyAngle() { return within(-6, 6); }

// 90 degrees, and from 2^-24 to 2^-7 more or less, either way.
float nearRightAngle()
{
    float angle = RIGHT_ANGLE + signedMagnitude(-24, -8);
    return sign() * angle;
}

float tinyAngle() { return signedMagnitude(-24, -10); }

// Three numbers drawn one after the other; braces keep the order, parentheses would not.
template <typename Draw> glm::vec3 three(Draw draw) { return glm::vec3{draw(), draw(), draw()}; }

glm::vec3 inCube(float size)
{
    return three([=] { return within(-size, size); });
}

// Any direction, and about this length.
glm::vec3 sized(int low, int high)
{
    glm::vec3 v = inCube(1);
    return v * magnitude(low, high);
}

glm::vec3 scales(int low, int high)
{
    return three([=] { return magnitude(low, high); });
}

// So many cases of a kind; make puts the inputs into an empty one.
template <typename Make> void add(Cases& cases, int count, const std::string& kind, Make make)
{
    for (int i = 0; i < count; i++) cases.push_back(make(Case{kind, {}}));
}

std::string text(const char* format, float number)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, format, double(number));
    return buffer;
}

Cases rotations()
{
    Cases cases = none();
    add(cases, 24, "any angles", [](Case c) { return c.with(three(anyAngle)); });
    add(cases, 32, "near right angles", [](Case c) { return c.with(three(nearRightAngle)); });
    add(cases, 4, "tiny angles", [](Case c) { return c.with(three(tinyAngle)); });
    add(cases, 8, "right angles", [](Case c) { return c.with(three(sign) * RIGHT_ANGLE); });
    add(cases, 4, "1e3 turns", [](Case c) { return c.with(inCube(6e3f)); });
    add(cases, 4, "1e6 turns", [](Case c) { return c.with(inCube(6e6f)); });
    add(cases, 1, "no turn", [](Case c) { return c.with(glm::vec3(0)); });
    return cases;
}

// Too large for the whole turns in them to fit an int.
Cases endlessRotations()
{
    Cases cases = none();
    add(cases, 8, "1e10 turns", [](Case c) { return c.with(inCube(6e10f)); });
    add(cases, 8, "1e20 turns", [](Case c) { return c.with(inCube(6e20f)); });
    return cases;
}

Cases placings()
{
    Cases cases = none();
    add(cases, 16, "any", [](Case c) { return c.with(inCube(100)).with(three(anyAngle)).with(scales(-3, 2)); });
    add(cases, 8, "near right angles", [](Case c) { return c.with(inCube(100)).with(three(nearRightAngle)).with(scales(-3, 2)); });
    add(cases, 4, "1e-13 small", [](Case c) { return c.with(inCube(1)).with(three(anyAngle)).with(scales(-43, -43)); });
    add(cases, 4, "1e13 large", [](Case c) { return c.with(inCube(1)).with(three(anyAngle)).with(scales(43, 43)); });
    add(cases, 8, "1e-13 to 1e13", [](Case c) { return c.with(inCube(1)).with(three(anyAngle)).with(scales(-43, 43)); });
    add(cases, 4, "1e6 away", [](Case c) { return c.with(inCube(1e6f)).with(three(anyAngle)).with(scales(-3, 2)); });
    return cases;
}

Cases moves()
{
    Cases cases = none();
    add(cases, 16, "any", [](Case c) { return c.with(inCube(100)).with(three(anyAngle)).with(inCube(100)); });
    add(cases, 8, "near right angles", [](Case c) { return c.with(inCube(100)).with(three(nearRightAngle)).with(inCube(100)); });
    add(cases, 8, "1e6 away", [](Case c) { return c.with(inCube(1e6f)).with(three(anyAngle)).with(inCube(1e6f)); });
    return cases;
}

const int LINKS = 4;

// The outermost first: its position, angles and scale, then those of its child, and so on.
Cases parents()
{
    Cases cases = none();
    add(cases, 12, "any", [](Case c) {
        for (int i = 0; i < LINKS; i++) c.with(inCube(10)).with(three(anyAngle)).with(scales(-1, 0));
        return c;
    });
    add(cases, 8, "1e6 away", [](Case c) {
        for (int i = 0; i < LINKS; i++) c.with(inCube(i ? 10 : 1e6f)).with(three(anyAngle)).with(scales(-1, 0));
        return c;
    });
    add(cases, 4, "1e6 larger and smaller again", [](Case c) {
        for (int i = 0; i < LINKS; i++) c.with(inCube(10)).with(three(anyAngle)).with(glm::vec3(i % 2 ? 0x1p-20f : 0x1p20f));
        return c;
    });
    return cases;
}

Cases turnsAboutPoints()
{
    Cases cases = none();
    add(cases, 16, "any", [](Case c) { return c.with(inCube(100)).with(three(anyAngle)).with(inCube(100)); });
    add(cases, 8, "near right angles", [](Case c) { return c.with(inCube(100)).with(three(nearRightAngle)).with(inCube(100)); });
    add(cases, 8, "1e6 away", [](Case c) {
        glm::vec3 point = inCube(1e6f);
        return c.with(point + inCube(10)).with(three(anyAngle)).with(point);
    });
    add(cases, 8, "1e6 away by tiny angles", [](Case c) {
        glm::vec3 point = inCube(1e6f);
        return c.with(point + inCube(10)).with(three(tinyAngle)).with(point);
    });
    return cases;
}

Cases looks()
{
    Cases cases = none();
    add(cases, 16, "any", [](Case c) { return c.with(inCube(100)).with(inCube(100)).with(inCube(1)); });
    add(cases, 8, "1e6 away", [](Case c) {
        glm::vec3 eye = inCube(1e6f);
        return c.with(eye).with(eye + inCube(10)).with(glm::vec3(0, 1, 0));
    });
    add(cases, 8, "up nearly ahead", [](Case c) {
        glm::vec3 eye = inCube(10);
        glm::vec3 ahead = inCube(10);
        return c.with(eye).with(eye + ahead).with(ahead + inCube(0x1p-8f));
    });
    return cases;
}

Cases cameras()
{
    Cases cases = none();
    add(cases, 16, "any", [](Case c) { return c.with(inCube(100)).with(three(anyAngle)); });
    add(cases, 8, "near right angles", [](Case c) { return c.with(inCube(100)).with(three(nearRightAngle)); });
    add(cases, 8, "1e6 away", [](Case c) { return c.with(inCube(1e6f)).with(three(anyAngle)); });
    return cases;
}

// A camera, and a model within 10 of it.
Cases modelViews()
{
    Cases cases = none();
    for (float distance : {1e1f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f}) {
        add(cases, 8, text("%g away", distance), [=](Case c) {
            glm::vec3 eye = inCube(distance);
            return c.with(eye).with(three(anyAngle)).with(eye + inCube(10)).with(three(anyAngle)).with(scales(-1, 0));
        });
    }
    return cases;
}

// Field of view, aspect, near, far.
Cases perspectives()
{
    Cases cases = none();
    add(cases, 1, "the course's", [](Case c) { return c.with(RIGHT_ANGLE).with(0x1.c71c72p+0f).with(0.1f).with(100); });
    add(cases, 16, "any", [](Case c) { return c.with(within(0.1f, 3)).with(unit() + 1).with(magnitude(-6, 0)).with(magnitude(3, 10)); });
    add(cases, 4, "near 180 degrees", [](Case c) { return c.with(2 * RIGHT_ANGLE - magnitude(-18, -10)).with(1).with(0.1f).with(100); });
    add(cases, 4, "near 0 degrees", [](Case c) { return c.with(magnitude(-20, -10)).with(1).with(0.1f).with(100); });
    add(cases, 4, "far is 1e6 nears", [](Case c) { return c.with(within(1, 2)).with(1).with(0x1p-10f).with(0x1p10f); });
    add(cases, 4, "far is nearly near", [](Case c) { return c.with(within(1, 2)).with(1).with(1 + unit()).with(2 + magnitude(-16, -10)); });
    return cases;
}

// Three columns, none of them at right angles with another.
Cases modelMatrices()
{
    Cases cases = none();
    auto uniform = [](Case c, float scale) { return c.with(inCube(scale)).with(inCube(scale)).with(inCube(scale)); };
    add(cases, 16, "any", [=](Case c) { return uniform(c, 1); });
    add(cases, 4, "1e-13 small", [=](Case c) { return uniform(c, 0x1p-43f); });
    add(cases, 4, "1e13 large", [=](Case c) { return uniform(c, 0x1p43f); });
    add(cases, 8, "1e-13 to 1e13", [](Case c) { return c.with(sized(-43, 42)).with(sized(-43, 42)).with(sized(-43, 42)); });
    add(cases, 8, "uneven twice", [](Case c) {
        glm::vec3 rows = scales(-12, 11);
        for (int column = 0; column < 3; column++) c.with(sized(-12, 11) * rows);
        return c;
    });
    add(cases, 8, "nearly a plane", [](Case c) {
        glm::vec3 x = inCube(1), y = inCube(1);
        return c.with(x).with(y).with(x + y + inCube(0x1p-20f));
    });
    add(cases, 8, "nearly a line", [](Case c) {
        glm::vec3 x = inCube(1), y = x * within(-2, 2), z = x * within(-2, 2);
        return c.with(x).with(y + inCube(0x1p-20f)).with(z + inCube(0x1p-20f));
    });
    return cases;
}

// From the light to a surface inside or a little outside of the cone, the cone's axis, inner and outer angle.
Cases cones()
{
    Cases cases = none();
    for (float degrees : {90.0f, 60.0f, 20.0f, 5.0f, 1.0f, 0.1f, 0.01f, 0.001f}) {
        float outer = degrees * (RIGHT_ANGLE / 90);
        for (float inner : {0.0f, outer / 2, outer * 0.9f}) {
            add(cases, 8, text("%g degrees", degrees), [=](Case c) {
                glm::vec3 axis = glm::normalize(inCube(1));
                glm::vec3 aside = glm::normalize(glm::cross(axis, inCube(1)));
                glm::vec3 fromLight = axis + aside * (within(0, 1.2f) * outer);
                return c.with(fromLight * magnitude(-3, 6)).with(axis).with(inner).with(outer);
            });
        }
    }
    return cases;
}

// From the surface to the light, and Table 1's coefficients.
Cases distances()
{
    Cases cases = none();
    for (glm::vec3 k : {glm::vec3(1.0f, 0.5f, 0.1f), glm::vec3(0.5f, 0.05f, 0.01f)}) {
        add(cases, 16, "any", [=](Case c) { return c.with(sized(-3, 6)).with(k); });
        add(cases, 8, "at the light", [=](Case c) { return c.with(sized(-56, -4)).with(k); });
        add(cases, 8, "far away", [=](Case c) { return c.with(sized(7, 60)).with(k); });
        add(cases, 4, "the distance's square beyond float", [=](Case c) { return c.with(sized(67, 80)).with(k); });
    }
    return cases;
}

// ---------------------------------------------------------------- Output

// The inputs in a precision to compute in, taken one after the other.
template <typename T> struct Input {
    const float* next;

    T number() { return T(*next++); }
    vec3<T> vector()
    {
        T x = number(), y = number(), z = number();
        return vec3<T>(x, y, z);
    }
};

// Not finite numbers in the spelling of Java.
void print(double number)
{
    if (std::isnan(number)) std::printf("NaN");
    else if (std::isinf(number)) std::printf(number < 0 ? "-Infinity" : "Infinity");
    else std::printf("%a", number);
}

void print(float number) { print(double(number)); }
void print(long double number) { print(double(number)); }

template <glm::length_t C, glm::length_t R, typename T> void print(const glm::mat<C, R, T>& m)
{
    for (glm::length_t column = 0; column < C; column++) {
        for (glm::length_t row = 0; row < R; row++) {
            if (column + row > 0) std::printf(" ");
            print(m[column][row]);
        }
    }
}

// compute takes an Input of any precision and answers in it.
template <typename Operation> void report(const char* name, const Cases& cases, Operation compute)
{
    for (const Case& c : cases) {
        std::printf("%s;%s;", name, c.kind.c_str());
        for (size_t i = 0; i < c.inputs.size(); i++) {
            if (i > 0) std::printf(" ");
            print(c.inputs[i]);
        }
        std::printf(";");
        print(compute(Input<long double>{c.inputs.data()}));
        std::printf(";");
        print(compute(Input<double>{c.inputs.data()}));
        std::printf(";");
        print(compute(Input<float>{c.inputs.data()}));
        std::printf("\n");
    }
}

// Arguments of a call are taken in any order, so inputs get their names first.
int main()
{
    std::printf("# operation; kind of case; inputs; long double; double; float. Made by oracle.cpp with GLM %d.%d.%d.%d\n",
        GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH, GLM_VERSION_REVISION);
    auto rotate = [](auto in) { return rotation(in.vector()); };
    auto place = [](auto& in) {
        auto position = in.vector(), angles = in.vector(), scale = in.vector();
        return placing(position, angles, scale);
    };
    report("rotation", rotations(), rotate);
    report("endless rotation", endlessRotations(), rotate);
    report("placing", placings(), [=](auto in) { return place(in); });
    report("moving", moves(), [](auto in) {
        auto position = in.vector(), angles = in.vector(), move = in.vector();
        return moving(position, angles, move);
    });
    report("parents", parents(), [=](auto in) {
        auto world = place(in);
        for (int i = 1; i < LINKS; i++) world = world * place(in);
        return world;
    });
    report("turn about a point", turnsAboutPoints(), [](auto in) {
        auto position = in.vector(), angles = in.vector(), point = in.vector();
        return turnAboutPoint(position, angles, point);
    });
    report("look-at", looks(), [](auto in) {
        auto eye = in.vector(), center = in.vector(), up = in.vector();
        return glm::lookAt(eye, center, up);
    });
    report("camera", cameras(), [](auto in) {
        auto position = in.vector(), angles = in.vector();
        return camera(position, angles);
    });
    report("model-view", modelViews(), [=](auto in) {
        auto position = in.vector(), angles = in.vector();
        return camera(position, angles) * place(in);
    });
    report("perspective", perspectives(), [](auto in) {
        auto fieldOfView = in.number(), aspect = in.number(), near = in.number(), far = in.number();
        return glm::perspective(fieldOfView, aspect, near, far);
    });
    report("normal matrix", modelMatrices(), [](auto in) {
        auto x = in.vector(), y = in.vector(), z = in.vector();
        return glm::inverseTranspose(mat3<decltype(in.number())>(x, y, z));
    });
    Cases spots = cones();
    report("cone of cosines", spots, [](auto in) {
        auto fromLight = in.vector(), axis = in.vector();
        auto inner = in.number(), outer = in.number();
        return coneOfCosines(fromLight, axis, inner, outer);
    });
    report("cone of versines", spots, [](auto in) {
        auto fromLight = in.vector(), axis = in.vector();
        auto inner = in.number(), outer = in.number();
        return coneOfVersines(fromLight, axis, inner, outer);
    });
    report("attenuation", distances(), [](auto in) {
        auto toLight = in.vector(), k = in.vector();
        return attenuation(toLight, k);
    });
}
