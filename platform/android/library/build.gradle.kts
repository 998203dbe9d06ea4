// The library: an AAR with the Kotlin classes, libglint_android.so for each processor, and Prefab modules for C++.
plugins {
    id("com.android.library")
    id("org.jetbrains.kotlin.android")
    `maven-publish`
}

val glint = rootDir.resolve("../..")

version = "0.1.0"

kotlin {
    explicitApi()
    jvmToolchain(17)
}

android {
    namespace = "glint.android"
    compileSdk = 35
    ndkVersion = "27.2.12479018"

    defaultConfig {
        minSdk = 24
        consumerProguardFiles("consumer-rules.pro")
        ndk {
            abiFilters += listOf("arm64-v8a", "x86_64", "armeabi-v7a")
        }
        externalNativeBuild {
            cmake {
                // The C++ runtime is shared, as an app with several native libraries must have it.
                arguments += listOf(
                    "-DANDROID_STL=c++_shared",
                    "-DANDROID_SUPPORT_FLEXIBLE_PAGE_SIZES=ON", // pages of 16 KiB; jni/CMakeLists.txt says so too
                    "-DCMAKE_BUILD_TYPE=Release", // a ray tracer without optimisation is of no use to anybody
                    "-DGLINT_BUILD_APPS=OFF",
                    "-DGLINT_BUILD_TESTS=OFF",
                    "-DGLINT_BUILD_IMAGEIO=OFF",
                    "-DGLINT_INSTALL=OFF",
                )
                // Where the header-only libraries are: see README.md.
                providers.gradleProperty("glint.dependencies").orNull?.let { arguments += "-DGLINT_DEPENDENCIES=$it" }
                targets += listOf("glint_android", "glint_core", "glint_gles")
            }
        }
    }

    externalNativeBuild {
        cmake {
            path = glint.resolve("CMakeLists.txt")
            version = "3.30.5"
        }
    }

    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_11
        targetCompatibility = JavaVersion.VERSION_11
    }
    kotlinOptions {
        jvmTarget = "11"
    }

    buildFeatures {
        prefabPublishing = true
    }
    prefab {
        create("glint_core") {
            libraryName = "libglint"
            headers = glint.resolve("core/include").path
        }
        create("glint_gles") {
            headers = glint.resolve("platform/gles/include").path
        }
    }

    publishing {
        singleVariant("release") {
            withSourcesJar()
        }
    }
}

publishing {
    publications {
        register<MavenPublication>("release") {
            groupId = "glint"
            artifactId = "glint-android"
            afterEvaluate { from(components["release"]) }
        }
    }
}
