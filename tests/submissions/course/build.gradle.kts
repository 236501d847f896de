import org.gradle.internal.os.OperatingSystem

plugins {
    kotlin("jvm") version "1.4.32"
    application
}

group = "cga"
version = "1.0"

val lwjglVersion = "3.2.3"
val jomlVersion = "1.9.24"
val lwjglNatives = when (OperatingSystem.current()) {
    OperatingSystem.LINUX -> "natives-linux"
    OperatingSystem.MAC_OS -> "natives-macos"
    else -> "natives-windows"
}

repositories {
    mavenCentral()
}

dependencies {
    implementation(kotlin("stdlib"))
    implementation(platform("org.lwjgl:lwjgl-bom:$lwjglVersion"))
    for (module in listOf("lwjgl", "lwjgl-assimp", "lwjgl-glfw", "lwjgl-opengl", "lwjgl-stb")) {
        implementation("org.lwjgl", module)
        runtimeOnly("org.lwjgl", module, classifier = lwjglNatives)
    }
    implementation("org.joml:joml:$jomlVersion")
}

application {
    mainClass.set("cga.exercise.MainKt")
}
