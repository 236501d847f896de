import org.gradle.api.tasks.testing.logging.TestExceptionFormat
import org.jetbrains.kotlin.gradle.dsl.JvmTarget

// pom.xml says the same for machines that cannot reach a Gradle distribution. BuildParityTest reads both; it knows
// exactly the forms of line used here, and fails on one that it does not know.
plugins {
    application
    alias(libs.plugins.kotlin.jvm)
}

group = "cga"
version = "1.0"

// All of them, whatever machine builds: an installation runs anywhere.
val nativePlatforms = listOf("linux", "linux-arm64", "windows", "macos", "macos-arm64")

dependencies {
    implementation(libs.lwjgl.core)
    implementation(libs.lwjgl.glfw)
    implementation(libs.lwjgl.opengl)
    implementation(libs.lwjgl.egl)
    implementation(libs.lwjgl.nuklear)
    implementation(libs.lwjgl.stb)
    implementation(libs.lwjgl.assimp)
    implementation(libs.lwjgl.tinyexr)
    implementation(libs.joml)
    implementation(libs.clikt)
    implementation(libs.mordant)
    implementation(libs.kotlinx.serialization.json)
    implementation(libs.kotlinx.html)
    implementation(libs.xchart)
    implementation(libs.vectorgraphics2d)
    implementation(libs.jmh.core)
    implementation(libs.jmh.generator.reflection)

    // EGL has none: it is part of the graphics driver.
    for (platform in nativePlatforms) {
        runtimeOnly(variantOf(libs.lwjgl.core) { classifier("natives-$platform") })
        runtimeOnly(variantOf(libs.lwjgl.glfw) { classifier("natives-$platform") })
        runtimeOnly(variantOf(libs.lwjgl.opengl) { classifier("natives-$platform") })
        runtimeOnly(variantOf(libs.lwjgl.nuklear) { classifier("natives-$platform") })
        runtimeOnly(variantOf(libs.lwjgl.stb) { classifier("natives-$platform") })
        runtimeOnly(variantOf(libs.lwjgl.assimp) { classifier("natives-$platform") })
        runtimeOnly(variantOf(libs.lwjgl.tinyexr) { classifier("natives-$platform") })
    }

    testImplementation(libs.junit.jupiter)
    testImplementation(libs.ktlint.rule.engine)
    testImplementation(libs.ktlint.ruleset.standard)
    testRuntimeOnly(libs.junit.platform.launcher)
    testRuntimeOnly(libs.slf4j.nop)
}

kotlin {
    explicitApi()
    compilerOptions {
        jvmTarget = JvmTarget.fromTarget(libs.versions.jvmTarget.get())
        allWarningsAsErrors = true
        // Plain classes and calls, which an archive of classes keeps; what is linked by invokedynamic is made anew at every start.
        freeCompilerArgs.addAll("-Xstring-concat=inline", "-Xlambdas=class", "-Xsam-conversions=class")
    }
    sourceSets {
        main { kotlin.setSrcDirs(listOf("src/main/kotlin")) }
        test { kotlin.setSrcDirs(listOf("tests/kotlin")) }
    }
}

java {
    sourceCompatibility = JavaVersion.toVersion(libs.versions.jvmTarget.get())
    targetCompatibility = sourceCompatibility
}

// Newer JDKs warn about the native access and the Unsafe that LWJGL is made of; older ones do not know the words.
val nativeAccess = buildList {
    val jdk = Runtime.version().feature()
    if (jdk >= 22) add("--enable-native-access=ALL-UNNAMED")
    if (jdk >= 23) add("--sun-misc-unsafe-memory-access=allow")
}

application {
    mainClass = "cga.cli.MainKt"
}

tasks.named<JavaExec>("run") {
    // `--args` replaces it.
    args("run")
    jvmArgs(nativeAccess)
    systemProperty("java.awt.headless", "true")
    // Mesa hands out 4.5 when 3.3 is asked for; so it rejects what a student's 3.3 driver rejects.
    environment("MESA_GL_VERSION_OVERRIDE", "3.3")
    environment("MESA_GLSL_VERSION_OVERRIDE", "330")
    // GLFW wants the process's first thread there.
    if (System.getProperty("os.name").startsWith("Mac")) jvmArgs("-XstartOnFirstThread")
    standardInput = System.`in`
}

tasks.test {
    useJUnitPlatform()
    // They read shaders, assets, goldens, docs and the build files as well: never up to date.
    outputs.upToDateWhen { false }
    // Two cores are what the tests are planned for, and most of them use one.
    maxParallelForks = 2
    maxHeapSize = "2g"
    jvmArgs(nativeAccess)
    systemProperty("java.awt.headless", "true")
    systemProperties(providers.systemPropertiesPrefixedBy("cga.").get())
    // A JVM cannot set its own environment: software rendering, and no more GL than the course asks for.
    environment("LIBGL_ALWAYS_SOFTWARE", "1")
    environment("MESA_GL_VERSION_OVERRIDE", "3.3")
    environment("MESA_GLSL_VERSION_OVERRIDE", "330")
    testLogging {
        events("failed", "skipped")
        exceptionFormat = TestExceptionFormat.FULL
    }
}

// What ./cga starts: our jar and all runtime jars in one folder, and nothing else.
tasks.register<Sync>("installCga") {
    description = "Puts the program and all it needs into build/cga/lib."
    group = "distribution"
    from(tasks.jar, configurations.runtimeClasspath)
    // Gradle names some jars without their version: never let one silently replace another.
    duplicatesStrategy = DuplicatesStrategy.FAIL
    into(layout.buildDirectory.dir("cga/lib"))
}
