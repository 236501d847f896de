// The command line, render and diff.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(project(":pictures"))
    api(libs.clikt)
    api(libs.mordant)

    testImplementation(project(":scene", "testing"))
}
