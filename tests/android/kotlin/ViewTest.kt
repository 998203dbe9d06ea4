package glint.test

import android.app.Activity
import android.app.Application
import android.content.ComponentCallbacks2
import android.content.Context
import android.view.MotionEvent
import android.view.ViewGroup
import glint.android.GlintLibrary
import glint.android.GlintScene
import glint.android.GlintView
import java.io.File
import org.junit.After
import org.junit.Assert.assertEquals
import org.junit.Assert.assertFalse
import org.junit.Assert.assertNotEquals
import org.junit.Assert.assertNull
import org.junit.Assert.assertTrue
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.Robolectric
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.android.controller.ActivityController

private const val SIZE = 128

/** A view whose drawing the test does, in a context of its own: Robolectric has no OpenGL. */
class DrawnView(context: Context) : GlintView(context) {
    lateinit var drawing: Renderer // without an initializer: set while the superclass is being made

    override fun setRenderer(renderer: Renderer) {
        drawing = renderer
        super.setRenderer(renderer)
    }

    fun surface() {
        Native.openSurface(SIZE, SIZE)
        drawing.onSurfaceCreated(null, null)
        drawing.onSurfaceChanged(null, SIZE, SIZE)
    }

    /** Until nothing better will come. */
    fun drawToTheEnd() {
        val deadline = System.nanoTime() + 30_000_000_000
        do {
            drawing.onDrawFrame(null)
            check(System.nanoTime() < deadline) { "it never comes to rest" }
        } while (figures?.isFinal != true)
    }

    /** Until there is a picture: on a busy machine one call does not wait for it. */
    fun drawAPicture() {
        val before = figures!!.frames
        val deadline = System.nanoTime() + 30_000_000_000
        do {
            drawing.onDrawFrame(null)
            check(System.nanoTime() < deadline) { "nothing comes" }
        } while (figures!!.frames == before)
    }

    /** Moves one finger, or lifts it and puts it down. */
    fun touch(action: Int, x: Float, y: Float) {
        val event = MotionEvent.obtain(0, 0, action, x, y, 0)
        assertTrue(dispatchTouchEvent(event))
        event.recycle()
    }
}

class ViewActivity : Activity() {
    lateinit var scene: GlintScene
    lateinit var view: DrawnView

    override fun onCreate(state: android.os.Bundle?) {
        super.onCreate(state)
        scene = GlintScene.fromAssets(this, "cornell.sdl")
        view = DrawnView(this)
        view.setScene(scene)
        setContentView(view)
    }

    override fun onResume() {
        super.onResume()
        view.onResume()
    }

    override fun onPause() {
        super.onPause()
        view.onPause()
    }

    override fun onDestroy() {
        super.onDestroy()
        scene.close()
    }
}

@RunWith(RobolectricTestRunner::class)
class ViewTest {
    @After fun nothingStaysOpen() {
        Native.closeSurface()
        assertEquals(0, GlintLibrary.openHandles)
    }

    private fun <A : Activity> run(type: Class<A>, body: (ActivityController<A>) -> Unit) {
        val controller = Robolectric.buildActivity(type).create().start().resume().visible()
        body(controller)
        end(controller)
    }

    /** As the system does it: the window goes when the activity is destroyed. */
    private fun end(controller: ActivityController<out Activity>) {
        controller.pause().stop()
        val decor = controller.get().window.decorView
        controller.destroy()
        if (decor.isAttachedToWindow) controller.get().windowManager.removeViewImmediate(decor)
    }

    private fun atRest() = Native.renderHash("$scenes/cornell.sdl", SIZE, SIZE, 1, 0)

    @Test fun comes_to_rest_with_the_picture_that_cpp_refines(): Unit = run(ViewActivity::class.java) { controller ->
        val view = controller.get().view
        view.surface()
        view.drawToTheEnd()
        assertEquals(atRest(), Native.surfaceHash())
        val figures = view.figures!!
        assertEquals(listOf(SIZE, SIZE, 1, 16), figures.run { listOf(widthPx, heightPx, depth, samplesPerPixel) })
    }

    @Test fun shows_the_same_after_a_pause_and_in_a_new_context(): Unit = run(ViewActivity::class.java) { controller ->
        val view = controller.get().view
        view.surface()
        view.drawToTheEnd()
        controller.pause().resume()
        view.drawing.onDrawFrame(null)
        assertEquals(atRest(), Native.surfaceHash())
        val frames = view.figures!!.frames
        repeat(3) {
            view.surface()
            view.drawing.onDrawFrame(null)
            assertEquals(atRest(), Native.surfaceHash())
        }
        assertEquals(3L, view.figures!!.contextLosses)
        assertEquals(frames, view.figures!!.frames)
    }

    @Test fun fingers_move_the_camera_and_the_camera_goes_back(): Unit = run(ViewActivity::class.java) { controller ->
        val view = controller.get().view
        view.surface()
        view.touch(MotionEvent.ACTION_DOWN, 50f, 50f)
        view.touch(MotionEvent.ACTION_MOVE, 70f, 55f)
        view.touch(MotionEvent.ACTION_CANCEL, 70f, 55f)
        view.drawToTheEnd()
        val orbited = Native.surfaceHash()
        assertNotEquals(atRest(), orbited)

        val properties = Array(2) { MotionEvent.PointerProperties().apply { id = it } }
        fun pinch(action: Int, spread: Float) {
            val places = Array(2) { i -> MotionEvent.PointerCoords().apply { x = 64f + (2 * i - 1) * spread; y = 64f } }
            val event = MotionEvent.obtain(0, 0, action, 2, properties, places, 0, 0, 1f, 1f, 0, 0, 0, 0)
            assertTrue(view.dispatchTouchEvent(event))
        }
        view.touch(MotionEvent.ACTION_DOWN, 54f, 64f)
        pinch(MotionEvent.ACTION_POINTER_DOWN or (1 shl MotionEvent.ACTION_POINTER_INDEX_SHIFT), 10f)
        pinch(MotionEvent.ACTION_MOVE, 14f)
        pinch(MotionEvent.ACTION_CANCEL, 14f)
        view.drawToTheEnd()
        assertNotEquals(orbited, Native.surfaceHash())

        view.resetCamera()
        view.drawToTheEnd()
        assertEquals(atRest(), Native.surfaceHash())
    }

    @Test fun takes_another_scene_and_none(): Unit = run(ViewActivity::class.java) { controller ->
        val view = controller.get().view
        view.surface()
        GlintScene.fromFile(File(scenes, "cornell.sdl")).use { other ->
            view.setScene(other, depth = 2)
            view.drawToTheEnd()
            assertEquals(2, view.figures!!.depth)
            assertEquals(Native.renderHash("$scenes/cornell.sdl", SIZE, SIZE, 2, 0), Native.surfaceHash())
        }
        view.setScene(null)
        assertNull(view.figures)
        view.drawing.onDrawFrame(null)
        assertFalse(view.dispatchTouchEvent(MotionEvent.obtain(0, 0, MotionEvent.ACTION_DOWN, 1f, 1f, 0)))
        view.setScene(controller.get().scene)
        view.drawToTheEnd()
        assertEquals(atRest(), Native.surfaceHash())
    }

    @Test fun tells_what_goes_wrong_and_goes_on_in_a_new_context(): Unit = run(ViewActivity::class.java) { controller ->
        val view = controller.get().view
        val told = mutableListOf<String>()
        view.errorListener = GlintView.ErrorListener { told += it.message!! }
        view.surface()
        view.drawToTheEnd()
        Native.closeSurface()
        repeat(3) { view.drawing.onDrawFrame(null) }
        shadowOf(android.os.Looper.getMainLooper()).idle()
        assertEquals(told.toString(), 1, told.size)
        assertTrue(told[0], told[0].contains("not current"))
        view.surface()
        view.drawToTheEnd()
        assertEquals(atRest(), Native.surfaceHash())
    }

    @Test fun lives_through_a_hundred_lives_and_leaves_nothing() {
        fun threads() = File("/proc/self/task").list()!!.size
        fun live(type: Class<out ViewActivity>) {
            val controller = Robolectric.buildActivity(type).create().start().resume().visible()
            val view = controller.get().view
            view.surface()
            view.drawAPicture()
            assertEquals(2, GlintLibrary.openHandles)
            controller.pause().stop()
            controller.get().application.onTrimMemory(ComponentCallbacks2.TRIM_MEMORY_COMPLETE)
            controller.start().resume()
            view.drawing.onDrawFrame(null)
            // A rotation: here the activity is made anew.
            RuntimeEnvironment.setQualifiers("+land")
            val decor = controller.get().window.decorView
            controller.recreate()
            if (decor.isAttachedToWindow) controller.get().windowManager.removeViewImmediate(decor)
            RuntimeEnvironment.setQualifiers("+port")
            val second = controller.get().view
            assertNotEquals(view, second)
            second.surface()
            second.drawAPicture()
            controller.get().application.onLowMemory()
            second.drawAPicture()
            end(controller)
            assertEquals(0, GlintLibrary.openHandles)
        }
        live(ViewActivity::class.java)
        System.gc()
        val before = threads()
        repeat(100) { live(ViewActivity::class.java) }
        assertTrue("${threads()} threads after $before", threads() <= before + 5)
    }

    @Test fun the_sample_shows_its_figures(): Unit = run(glint.sample.RoomActivity::class.java) { controller ->
        controller.pause().resume()
        shadowOf(android.os.Looper.getMainLooper()).idle()
        val texts = generateSequence(controller.get().window.decorView as android.view.View?) { view ->
            (view as? ViewGroup)?.takeIf { it.childCount > 0 }?.run { getChildAt(childCount - 1) }
        }
        val overlay = texts.last() as android.widget.TextView
        assertTrue(overlay.text.toString(), overlay.text.contains("frames a second"))
    }

    @Test fun the_example_opens_and_closes_a_scene(): Unit = run(examples.RoomActivity::class.java) {
        assertEquals(2, GlintLibrary.openHandles)
    }
}
