import org.jetbrains.kotlin.gradle.dsl.JvmTarget

plugins {
    application
    alias(libs.plugins.kotlin.jvm)
}

// The native libraries of this machine.
val os: String = System.getProperty("os.name")
val arm = if (System.getProperty("os.arch") == "aarch64") "-arm64" else ""
val platform = if (os.startsWith("Windows")) "windows" else if (os.startsWith("Mac")) "macos$arm" else "linux$arm"

dependencies {
    for (library in listOf(libs.lwjgl.core, libs.lwjgl.glfw, libs.lwjgl.opengl, libs.lwjgl.stb, libs.lwjgl.assimp, libs.lwjgl.tinyexr)) {
        implementation(library)
        runtimeOnly(variantOf(library) { classifier("natives-$platform") })
    }
    implementation(libs.lwjgl.egl)
    implementation(libs.joml)
}

kotlin {
    compilerOptions { jvmTarget = JvmTarget.fromTarget(libs.versions.jvmTarget.get()) }
}

java {
    sourceCompatibility = JavaVersion.toVersion(libs.versions.jvmTarget.get())
    targetCompatibility = sourceCompatibility
}

application {
    mainClass = "cga.exercise.MainKt"
}

tasks.named<JavaExec>("run") {
    // Newer JDKs warn about the native access and the Unsafe that LWJGL is made of; older ones do not know the words.
    val jdk = Runtime.version().feature()
    if (jdk >= 22) jvmArgs("--enable-native-access=ALL-UNNAMED")
    if (jdk >= 23) jvmArgs("--sun-misc-unsafe-memory-access=allow")
    // GLFW wants the process's first thread there.
    if (os.startsWith("Mac")) jvmArgs("-XstartOnFirstThread")
}
