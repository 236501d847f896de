rootProject.name = "tron"
