import org.gradle.api.tasks.testing.logging.TestExceptionFormat
import org.jetbrains.kotlin.gradle.dsl.JvmTarget
import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension

// What all parts have in common, and the program that they make. pom.xml says the same for machines that cannot reach a Gradle
// distribution. BuildParityTest reads both; it knows exactly the forms of line used here, and fails on one that it does not know.
plugins {
    application
    alias(libs.plugins.kotlin.jvm) apply false
}

// All of them, whatever machine builds: an installation runs anywhere.
val nativePlatforms = listOf("linux", "linux-arm64", "windows", "macos", "macos-arm64")

// Newer JDKs warn about the native access and the Unsafe that LWJGL is made of; older ones do not know the words.
val nativeAccess = buildList {
    val jdk = Runtime.version().feature()
    if (jdk >= 22) add("--enable-native-access=ALL-UNNAMED")
    if (jdk >= 23) add("--sun-misc-unsafe-memory-access=allow")
}

// Whose commands the program has; they bring what they are made of.
val programs = listOf("window", "grader", "lab")

dependencies {
    for (part in programs) runtimeOnly(project(":$part"))
}

application {
    mainClass = "cga.cli.MainKt"
    applicationDefaultJvmArgs = nativeAccess + "-Djava.awt.headless=true"
}

// An installation finds these beside its lib folder.
distributions.main {
    contents {
        for (folder in listOf("shaders", "assets")) from(folder) { into(folder) }
    }
}

tasks.named<JavaExec>("run") {
    // `--args` replaces it.
    args("run")
    // Mesa hands out 4.5 when 3.3 is asked for; so it rejects what a student's 3.3 driver rejects.
    environment("MESA_GL_VERSION_OVERRIDE", "3.3")
    environment("MESA_GLSL_VERSION_OVERRIDE", "330")
    // GLFW wants the process's first thread there.
    if (System.getProperty("os.name").startsWith("Mac")) jvmArgs("-XstartOnFirstThread")
    standardInput = System.`in`
}

allprojects {
    group = "cga"
    version = "1.0"
}

subprojects {
    apply(plugin = "java-library")
    apply(plugin = rootProject.libs.plugins.kotlin.jvm.get().pluginId)

    layout.buildDirectory = rootProject.layout.buildDirectory.dir(name)
    base.archivesName = "cga-$name"
    val tests = rootDir.resolve("tests/$name")

    configure<KotlinJvmProjectExtension> {
        explicitApi()
        compilerOptions {
            jvmTarget = JvmTarget.fromTarget(rootProject.libs.versions.jvmTarget.get())
            allWarningsAsErrors = true
            // Plain classes and calls, which an archive of classes keeps; what is linked by invokedynamic is made anew at every start.
            freeCompilerArgs.addAll("-Xstring-concat=inline", "-Xlambdas=class", "-Xsam-conversions=class")
        }
        sourceSets.getByName("main") {
            kotlin.setSrcDirs(listOf("kotlin"))
            resources.setSrcDirs(listOf("resources"))
        }
        sourceSets.getByName("test") {
            kotlin.setSrcDirs(listOf(tests.resolve("kotlin")))
            resources.setSrcDirs(listOf(tests.resolve("resources")))
        }
    }

    configure<JavaPluginExtension> {
        sourceCompatibility = JavaVersion.toVersion(rootProject.libs.versions.jvmTarget.get())
        targetCompatibility = sourceCompatibility
    }

    // "natives"(library): its native code for every platform.
    val natives = configurations.create("natives")
    configurations["runtimeOnly"].dependencies.addAllLater(
        provider {
            natives.dependencies.flatMap { library ->
                nativePlatforms.map { dependencies.create("${library.group}:${library.name}:${library.version}:natives-$it") }
            }
        },
    )

    dependencies {
        "testImplementation"(rootProject.libs.junit.jupiter)
        "testRuntimeOnly"(rootProject.libs.junit.platform.launcher)
    }

    // By one name in either build.
    tasks.named<Jar>("jar") { archiveVersion = "" }

    tasks.named<Test>("test") {
        useJUnitPlatform {
            // What one runs before every commit: -Pcga.tests=fast.
            if (providers.gradleProperty("cga.tests").orNull == "fast") excludeTags("slow")
        }
        workingDir = rootDir
        // They read shaders, assets, goldens, docs and the build files as well: never up to date.
        outputs.upToDateWhen { false }
        // Two cores are what the tests are planned for, and most of them use one.
        maxParallelForks = 2
        maxHeapSize = "2g"
        // Most tests are over before the optimising compiler has paid. Without it there is room for 48 MB of code only.
        jvmArgs(nativeAccess + listOf("-XX:TieredStopAtLevel=1", "-XX:ReservedCodeCacheSize=240m", "-XX:+UseSerialGC"))
        systemProperty("java.awt.headless", "true")
        systemProperties(providers.systemPropertiesPrefixedBy("cga.").get())
        // A JVM cannot set its own environment: software rendering, and no more GL than the course asks for.
        environment("LIBGL_ALWAYS_SOFTWARE", "1")
        environment("LC_ALL", "C.UTF-8")
        environment("MESA_GL_VERSION_OVERRIDE", "3.3")
        environment("MESA_GLSL_VERSION_OVERRIDE", "330")
        testLogging {
            events("failed", "skipped")
            exceptionFormat = TestExceptionFormat.FULL
        }
    }

    // What ./cga starts: the jars of a part and all that it runs with, in the folder that the parts share.
    if (name in programs) {
        tasks.register<Copy>("installCga") {
            description = "Puts this part and all it needs into build/cga/lib."
            group = "distribution"
            from(tasks.named("jar"), configurations.named("runtimeClasspath"))
            // Gradle names some jars without their version: never let one silently replace another.
            duplicatesStrategy = DuplicatesStrategy.FAIL
            into(rootProject.layout.buildDirectory.dir("cga/lib"))
        }
    }
}
