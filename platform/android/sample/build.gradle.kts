// The sample: the Cornell room, and how fast it comes.
plugins {
    id("com.android.application")
    id("org.jetbrains.kotlin.android")
}

// The scene and its meshes are the source tree's own, copied when the app is built.
val copyScene = tasks.register<Sync>("copyScene") {
    from(rootDir.resolve("../../scenes/sdl")) {
        include("cornell.sdl", "*.obj")
    }
    into(layout.buildDirectory.dir("scene"))
}

kotlin {
    jvmToolchain(17)
}

android {
    namespace = "glint.sample"
    compileSdk = 35

    defaultConfig {
        applicationId = "glint.sample"
        minSdk = 24
        targetSdk = 35
        versionCode = 1
        versionName = "0.1.0"
    }

    buildTypes {
        release {
            isMinifyEnabled = true
            proguardFiles(getDefaultProguardFile("proguard-android-optimize.txt"))
            signingConfig = signingConfigs.getByName("debug")
        }
    }

    compileOptions {
        sourceCompatibility = JavaVersion.VERSION_11
        targetCompatibility = JavaVersion.VERSION_11
    }
    kotlinOptions {
        jvmTarget = "11"
    }

    sourceSets["main"].assets.srcDir(copyScene)
}

dependencies {
    implementation(project(":glint"))
}
