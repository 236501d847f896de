// How long GLM takes for some of the oracle's operations: one line each, operation;precision;nanoseconds.
//
//     g++ -std=c++17 -O3 -ffp-contract=off -o build/timing tests/glm/timing.cpp && build/timing
//
// It is time of the processor, and as on the other side that of an operation includes reading its inputs and storing its result.

// A function of another name has to return something.
#pragma GCC diagnostic ignored "-Wreturn-type"
#define main writeOracle
#include "oracle.cpp"
#undef main

#include <algorithm>
#include <ctime>

const int ROUNDS = 11;
const int REPEATS = 10000;

template <typename T, typename Operation> double nanoseconds(const Cases& cases, Operation compute)
{
    std::vector<double> times;
    T sum = 0;
    for (int round = 0; round < ROUNDS; round++) {
        std::clock_t start = std::clock();
        for (int i = 0; i < REPEATS; i++)
            for (const Case& c : cases) {
                auto result = compute(Input<T>{c.inputs.data()});
                // The compiler must believe that somebody reads the result: else there would be nothing to do.
                asm volatile("" : : "g"(&result) : "memory");
                sum += result[0][0];
            }
        double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        times.push_back(1e9 * seconds / (double(REPEATS) * cases.size()));
    }
    volatile T used = sum;
    (void)used;
    std::sort(times.begin(), times.end());
    return times[ROUNDS / 2];
}

template <typename Operation> void time(const char* name, const char* kind, Cases cases, Operation compute)
{
    cases.erase(std::remove_if(cases.begin(), cases.end(), [=](const Case& c) { return c.kind != kind; }), cases.end());
    std::printf("%s;float;%g\n", name, nanoseconds<float>(cases, compute));
    std::printf("%s;double;%g\n", name, nanoseconds<double>(cases, compute));
}

int main()
{
    auto place = [](auto& in) {
        auto position = in.vector(), angles = in.vector(), scale = in.vector();
        return placing(position, angles, scale);
    };
    time("placing", "any", placings(), [=](auto in) { return place(in); });
    time("model-view", "10 away", modelViews(), [=](auto in) {
        auto position = in.vector(), angles = in.vector();
        return camera(position, angles) * place(in);
    });
    time("normal matrix", "any", modelMatrices(), [](auto in) {
        auto x = in.vector(), y = in.vector(), z = in.vector();
        return glm::inverseTranspose(mat3<decltype(in.number())>(x, y, z));
    });
}
