// Grading: submissions to points.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(project(":window"))
    implementation(project(":reader"))
    implementation(libs.kotlinx.serialization.json)
    implementation(libs.kotlinx.html)

    testImplementation(project(":scene", "testing"))
    testImplementation(libs.ktlint.rule.engine)
    testRuntimeOnly(libs.slf4j.nop)
}
