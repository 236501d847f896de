// Framework and exercise: what students get.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    api(libs.lwjgl.core)
    api(libs.lwjgl.glfw)
    api(libs.lwjgl.opengl)
    api(libs.lwjgl.stb)
    api(libs.joml)
    implementation(libs.lwjgl.egl)
    implementation(libs.lwjgl.assimp)
    implementation(libs.lwjgl.tinyexr)

    "natives"(libs.lwjgl.core)
    "natives"(libs.lwjgl.glfw)
    "natives"(libs.lwjgl.opengl)
    "natives"(libs.lwjgl.stb)
    "natives"(libs.lwjgl.assimp)
    "natives"(libs.lwjgl.tinyexr)

    testImplementation(libs.kotlinx.serialization.json)
}

// What the tests of all parts share lies with these.
val testJar by tasks.registering(Jar::class) {
    archiveClassifier = "tests"
    from(sourceSets.test.get().output)
}
configurations.consumable("testing")
artifacts.add("testing", testJar)
