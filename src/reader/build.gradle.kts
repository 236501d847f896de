// What a shader computes, step by step.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(project(":scene"))
    implementation(libs.lwjgl.shaderc)

    "natives"(libs.lwjgl.shaderc)

    testImplementation(project(":scene", "testing"))
}
