// Inspect: the window's look into the formula.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(project(":cli"))
    api(libs.lwjgl.nuklear)

    "natives"(libs.lwjgl.nuklear)

    testImplementation(project(":scene", "testing"))
}
