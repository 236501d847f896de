pluginManagement {
    // Not the plugin portal: machines that reach Maven Central only build too.
    repositories { mavenCentral() }
}

dependencyResolutionManagement {
    repositories { mavenCentral() }
}

rootProject.name = "cga-lights"

// The parts: each builds, tests and is understood alone, and uses only parts above it.
part("scene") // framework and exercise: what students get
part("reader") // what a shader computes, step by step
part("pictures") // imaging and reference: comparing pictures, and the truth
part("cli") // the command line, `render` and `diff`
part("window") // inspect: the window's look into the formula
part("grader") // grading: submissions to points
part("lab") // measure: speed, error and stability

// Tests of the whole: the launcher, the documents, the build itself.
include("program")
project(":program").projectDir = file("tests/program")

fun part(name: String) {
    include(name)
    project(":$name").projectDir = file("src/$name")
}
