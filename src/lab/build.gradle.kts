// Measure: speed, error and stability.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(project(":window"))
    implementation(libs.kotlinx.serialization.json)
    implementation(libs.xchart)
    implementation(libs.vectorgraphics2d)
    implementation(libs.jmh.core)
    implementation(libs.jmh.generator.reflection)

    testImplementation(project(":scene", "testing"))
    testImplementation(project(":grader"))
}
