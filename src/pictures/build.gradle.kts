// Imaging and reference: comparing pictures, and the truth.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(project(":scene"))
    implementation(libs.kotlinx.serialization.json)
    implementation(libs.kotlinx.html)

    testImplementation(project(":scene", "testing"))
}
