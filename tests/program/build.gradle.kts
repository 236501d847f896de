// Tests of the whole: the launcher, the documents, the build itself.
plugins {
    alias(libs.plugins.kotlin.jvm)
    `java-library`
}

dependencies {
    implementation(project(":reader"))
    implementation(project(":window"))
    implementation(project(":grader"))
    implementation(project(":lab"))

    testImplementation(project(":scene", "testing"))
    testImplementation(libs.ktlint.rule.engine)
    testImplementation(libs.ktlint.ruleset.standard)
    testRuntimeOnly(libs.slf4j.nop)
}

kotlin.sourceSets.main { kotlin.setSrcDirs(emptyList<String>()) }
