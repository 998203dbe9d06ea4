package glint.test

import android.graphics.Bitmap
import glint.android.GlintException
import glint.android.GlintLibrary
import glint.android.GlintRenderOptions
import glint.android.GlintRenderer
import glint.android.GlintScene
import java.io.File
import java.nio.ByteBuffer
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertThrows
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner

@RunWith(RobolectricTestRunner::class)
class RendererTest {
    private lateinit var scene: GlintScene

    @Before fun open() {
        scene = GlintScene.fromFile(File(scenes, "cornell.sdl"))
    }

    @After fun nothingStaysOpen() {
        scene.close()
        assertEquals(0, GlintLibrary.openHandles)
    }

    @Test fun every_instruction_set_and_number_of_threads_gives_the_golden_picture() {
        assertTrue(GlintLibrary.instructionSets.contains("scalar"))
        for (isa in GlintLibrary.instructionSets) for (threads in 1..3) {
            GlintRenderer(scene, threads, isa).use { renderer ->
                assertEquals(isa, renderer.instructionSet)
                assertEquals(threads, renderer.threads)
                val pixels = ByteBuffer.allocateDirect(128 * 128 * 4)
                val done = renderer.render(pixels, 128, 128, GlintRenderOptions(depth = 1))
                assertEquals(128L * 128, done.primaryRays)
                assertEquals(goldenHash("cornell", 128, 128, 1), Native.hash(pixels, 128, 128))
            }
        }
    }

    @Test fun options_are_the_renderers(): Unit = GlintRenderer(scene).use { renderer ->
        val pixels = ByteBuffer.allocateDirect(40 * 30 * 4)
        renderer.render(pixels, 40, 30, GlintRenderOptions(depth = 2, samplesPerPixel = 4))
        assertEquals(Native.renderHash("$scenes/cornell.sdl", 40, 30, 2, 4), Native.hash(pixels, 40, 30))
        renderer.render(pixels, 40, 30, GlintRenderOptions(depth = 2, samplesPerPixel = 4, srgb = true))
        assertFalse(Native.renderHash("$scenes/cornell.sdl", 40, 30, 2, 4) == Native.hash(pixels, 40, 30))
    }

    @Test fun nothing_is_written_between_rows(): Unit = GlintRenderer(scene).use { renderer ->
        val stride = 128 * 4 + 12
        val pixels = ByteBuffer.allocateDirect(stride * 128 - 12)
        for (i in 0 until pixels.capacity()) pixels.put(i, 77)
        renderer.render(pixels, 128, 128, GlintRenderOptions(depth = 1), stride)
        val packed = ByteBuffer.allocateDirect(128 * 128 * 4)
        for (y in 0 until 128) for (x in 0 until stride) {
            if (x < 128 * 4) packed.put(pixels.get(y * stride + x))
            else if (y < 127) assertEquals(77.toByte(), pixels.get(y * stride + x))
        }
        assertEquals(goldenHash("cornell", 128, 128, 1), Native.hash(packed, 128, 128))
    }

    @Test fun a_bitmap_is_a_target(): Unit = GlintRenderer(scene).use { renderer ->
        val bitmap = Bitmap.createBitmap(20, 10, Bitmap.Config.ARGB_8888)
        renderer.render(bitmap)
        val pixels = ByteBuffer.allocateDirect(20 * 10 * 4)
        renderer.render(pixels, 20, 10)
        // Robolectric's bitmaps have their channels in another order, so getPixel() would tell nothing.
        val back = ByteBuffer.allocateDirect(20 * 10 * 4)
        bitmap.copyPixelsToBuffer(back)
        assertEquals(Native.hash(pixels, 20, 10), Native.hash(back, 20, 10))
        assertThrows(IllegalArgumentException::class.java) {
            renderer.render(Bitmap.createBitmap(20, 10, Bitmap.Config.RGB_565))
        }
    }

    @Test fun a_job_can_be_watched_and_ends_with_the_picture(): Unit = GlintRenderer(scene).use { renderer ->
        val pixels = ByteBuffer.allocateDirect(512 * 512 * 4)
        renderer.start(pixels, 512, 512, GlintRenderOptions(depth = 2)).use { job ->
            var last = 0.0
            while (!job.isDone) {
                assertTrue(job.progress in last..1.0)
                last = job.progress
            }
            assertTrue(job.await().seconds > 0.0)
            assertEquals(1.0, job.progress, 0.0)
        }
        assertEquals(goldenHash("cornell", 512, 512, 2), Native.hash(pixels, 512, 512))
    }

    @Test fun a_job_that_is_cancelled_says_so(): Unit = GlintRenderer(scene, 1, "scalar").use { renderer ->
        val pixels = ByteBuffer.allocateDirect(2048 * 2048 * 4)
        renderer.start(pixels, 2048, 2048, GlintRenderOptions(depth = 9, samplesPerPixel = 64)).use { job ->
            job.cancel()
            val error = assertThrows(GlintException::class.java) { job.await() }
            assertEquals(GlintException.Code.CANCELLED, error.code)
        }
        // Closing cancels, too, and whoever waits is let go.
        val job = renderer.start(pixels, 2048, 2048, GlintRenderOptions(depth = 9, samplesPerPixel = 64))
        var told: Throwable? = null
        val waiting = Thread { told = runCatching { job.await() }.exceptionOrNull() }
        waiting.start()
        Thread.sleep(20)
        job.close()
        waiting.join()
        assertTrue("$told", told is GlintException || told is IllegalStateException)
        assertThrows(IllegalStateException::class.java) { job.progress }
    }

    @Test fun a_job_outlives_its_renderer_and_its_buffer() {
        val renderer = GlintRenderer(scene)
        val job = renderer.start(ByteBuffer.allocateDirect(256 * 256 * 4), 256, 256)
        renderer.close()
        System.gc()
        assertEquals(256L * 256, job.await().primaryRays)
        job.close()
    }

    @Test fun a_target_that_is_none_is_refused(): Unit = GlintRenderer(scene).use { renderer ->
        fun refused(what: () -> Unit) = assertThrows(IllegalArgumentException::class.java) { what() }
        refused { renderer.render(ByteBuffer.allocate(400), 10, 10) }
        refused { renderer.render(ByteBuffer.allocateDirect(399), 10, 10) }
        refused { renderer.render(ByteBuffer.allocateDirect(400).asReadOnlyBuffer(), 10, 10) }
        refused { renderer.render(ByteBuffer.allocateDirect(400), 10, 10, strideBytes = 39) }
        refused { renderer.render(ByteBuffer.allocateDirect(400), 0, 10) }
        refused { renderer.render(ByteBuffer.allocateDirect(400), 10, Int.MAX_VALUE) }
        refused { renderer.render(ByteBuffer.allocateDirect(400), Int.MAX_VALUE, 1) }
        refused { renderer.render(ByteBuffer.allocateDirect(400), 10, 10, GlintRenderOptions(depth = -1)) }
        val error = assertThrows(GlintException::class.java) { GlintRenderer(scene, 0, "mmx") }
        assertTrue(error.message, error.message!!.contains("scalar"))
        val samples = assertThrows(GlintException::class.java) {
            renderer.render(ByteBuffer.allocateDirect(400), 10, 10, GlintRenderOptions(samplesPerPixel = 5000))
        }
        assertEquals(GlintException.Code.BAD_INPUT, samples.code)
    }
}
