pluginManagement {
    repositories {
        google()
        mavenCentral()
        gradlePluginPortal()
    }
}

dependencyResolutionManagement {
    repositoriesMode.set(RepositoriesMode.FAIL_ON_PROJECT_REPOS)
    repositories {
        google()
        mavenCentral()
    }
}

rootProject.name = "glint-android"

// The library's name is also that of its Prefab package: find_package(glint).
include(":glint")
project(":glint").projectDir = file("library")
include(":sample")
