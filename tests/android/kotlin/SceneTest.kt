package glint.test

import android.app.Activity
import glint.android.GlintException
import glint.android.GlintLibrary
import glint.android.GlintRenderOptions
import glint.android.GlintRenderer
import glint.android.GlintScene
import java.io.File
import java.nio.ByteBuffer
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner

@RunWith(RobolectricTestRunner::class)
class SceneTest {
    @After fun nothingStaysOpen() = assertEquals(0, GlintLibrary.openHandles)

    private fun hashOf(scene: GlintScene): Long = GlintRenderer(scene).use { renderer ->
        val pixels = ByteBuffer.allocateDirect(33 * 77 * 4)
        renderer.render(pixels, 33, 77, GlintRenderOptions(depth = 5))
        Native.hash(pixels, 33, 77)
    }

    private val golden = goldenHash("cornell", 33, 77, 5)

    @Test fun a_scene_in_a_file_is_the_scene(): Unit = GlintScene.fromFile(File(scenes, "cornell.sdl")).use {
        assertEquals(golden, hashOf(it))
        assertEquals(32, it.triangleCount)
        assertEquals(listOf(256, 256), listOf(it.widthPx, it.heightPx))
        assertEquals(emptyList<String>(), it.warnings)
    }

    @Test fun a_scene_in_the_assets_is_the_scene() {
        val activity = Robolectric.buildActivity(Activity::class.java).get()
        GlintScene.fromAssets(activity, "cornell.sdl").use { assertEquals(golden, hashOf(it)) }
    }

    @Test fun a_scene_in_memory_is_the_scene() {
        val files = File(scenes).listFiles()!!.filter { it.extension == "obj" }.associate { it.name to it.readBytes() }
        GlintScene.fromBytes(File(scenes, "cornell.sdl").readBytes(), files).use { assertEquals(golden, hashOf(it)) }
    }

    @Test fun a_missing_asset_is_named() {
        val assets = Robolectric.buildActivity(Activity::class.java).get().assets
        val error = assertThrows(GlintException::class.java) { GlintScene.fromAssets(assets, "gone.sdl") }
        assertEquals(GlintException.Code.NOT_FOUND, error.code)
        assertTrue(error.message, error.message!!.contains("gone.sdl"))
    }

    @Test fun a_bad_scene_is_told_with_line_and_column_and_whatever_bytes_it_has() {
        val text = "size 16 16\neye 0 0,5 5.7 \u00e4\n".toByteArray(Charsets.ISO_8859_1)
        val error = assertThrows(GlintException::class.java) { GlintScene.fromBytes(text) }
        assertEquals(GlintException.Code.BAD_INPUT, error.code)
        assertTrue(error.message, error.message!!.contains("scene.sdl:2:15: error:"))
        assertTrue(error.message, error.message!!.contains("eye 0 0,5 5.7 \ufffd"))
    }

    @Test fun names_outside_the_basic_plane_are_found() {
        val folder = java.nio.file.Files.createTempDirectory("glint").toFile()
        try {
            val file = File(folder, "\ud83c\udfe0.sdl")
            File(scenes, "cornell.sdl").copyTo(file)
            File(scenes).listFiles()!!.filter { it.extension == "obj" }.forEach { it.copyTo(File(folder, it.name)) }
            GlintScene.fromFile(file).use { assertEquals(32, it.triangleCount) }
            file.delete()
            val error = assertThrows(GlintException::class.java) { GlintScene.fromFile(file) }
            assertTrue(error.message, error.message!!.contains("\ud83c\udfe0.sdl"))
        } finally {
            folder.deleteRecursively()
        }
    }

    @Test fun closing_twice_is_closing_once_and_a_closed_scene_says_so() {
        val scene = GlintScene.fromFile(File(scenes, "cornell.sdl"))
        val renderer = GlintRenderer(scene)
        assertEquals(2, GlintLibrary.openHandles)
        repeat(3) { scene.close() }
        assertEquals(1, GlintLibrary.openHandles)
        assertThrows(IllegalStateException::class.java) { GlintRenderer(scene) }
        // What uses the scene keeps it.
        val pixels = ByteBuffer.allocateDirect(4)
        renderer.render(pixels, 1, 1)
        renderer.close()
        assertThrows(IllegalStateException::class.java) { renderer.render(pixels, 1, 1) }
    }
}
