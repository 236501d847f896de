import org.jetbrains.kotlin.gradle.dsl.JvmTarget

plugins {
    application
    alias(libs.plugins.kotlin.jvm)
}

// The native libraries of this machine.
val os: String = System.getProperty("os.name")
val arm = if (System.getProperty("os.arch") == "aarch64") "-arm64" else ""
val platform = if (os.startsWith("Windows")) "windows" else if (os.startsWith("Mac")) "macos$arm" else "linux$arm"

// What ./cga run compiles with.
val compiler = configurations.create("compiler")

dependencies {
    implementation(files("libs/cga-coach.jar"))
    for (library in listOf(libs.lwjgl.core, libs.lwjgl.glfw, libs.lwjgl.opengl, libs.lwjgl.stb, libs.lwjgl.assimp, libs.lwjgl.nuklear)) {
        implementation(library)
        runtimeOnly(variantOf(library) { classifier("natives-$platform") })
    }
    implementation(libs.joml)
    compiler("org.jetbrains.kotlin:kotlin-compiler-embeddable:${libs.plugins.kotlin.jvm.get().version}")
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

tasks.withType<JavaExec>().configureEach {
    // Newer JDKs warn about the native access and the Unsafe that LWJGL is made of; older ones do not know the words.
    val jdk = Runtime.version().feature()
    if (jdk >= 22) jvmArgs("--enable-native-access=ALL-UNNAMED")
    if (jdk >= 23) jvmArgs("--sun-misc-unsafe-memory-access=allow", "-Djdk.util.jar.enableMultiRelease=false")
    // GLFW wants the process's first thread there.
    if (os.startsWith("Mac")) jvmArgs("-XstartOnFirstThread")
}

// For ./cga run.
tasks.register<Sync>("libraries") {
    from(configurations.runtimeClasspath) { exclude("cga-coach.jar") }
    into(layout.buildDirectory.dir("cga/lib"))
}
tasks.register<Sync>("compiler") {
    from(compiler)
    into(layout.buildDirectory.dir("cga/compiler"))
}
