pluginManagement {
    // Not the plugin portal: machines that reach Maven Central only build too.
    repositories { mavenCentral() }
}

dependencyResolutionManagement {
    repositories { mavenCentral() }
}

rootProject.name = "cga-lights"
