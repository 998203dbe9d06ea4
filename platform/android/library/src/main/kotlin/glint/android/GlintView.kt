// A scene on the screen, moved with fingers.
package glint.android

import android.annotation.SuppressLint
import android.content.ComponentCallbacks2
import android.content.Context
import android.content.res.Configuration
import android.opengl.GLSurfaceView
import android.util.AttributeSet
import android.util.Log
import android.view.MotionEvent
import javax.microedition.khronos.egl.EGLConfig
import javax.microedition.khronos.opengles.GL10

/**
 * What the picture on the screen was like, and how fast pictures come.
 *
 * @property frames shown so far
 * @property framesPerSecond lately, while something moved; 0 before
 * @property renderMs tracing the last picture took
 * @property widthPx of the picture, which fills the view
 * @property heightPx likewise
 * @property depth recursive rays in a row
 * @property samplesPerPixel of the picture, which gets smoother at rest
 * @property isFinal whether it is at rest and will not get better
 * @property contextLosses how often the OpenGL context was lost
 */
public data class GlintFigures(
    val frames: Long,
    val framesPerSecond: Double,
    val renderMs: Double,
    val widthPx: Int,
    val heightPx: Int,
    val depth: Int,
    val samplesPerPixel: Int,
    val isFinal: Boolean,
    val contextLosses: Long,
)

/**
 * Shows a scene and lets a person move in it: one finger orbits, two move the picture and zoom. While the camera moves, the
 * picture gets coarser where it must so that the display's rate is held; at rest it comes back in full and gets smoother, up
 * to 16 samples a pixel. Then nothing is drawn or traced until somebody touches it.
 *
 * Give it a scene with [setScene] and forward the activity's `onPause` and `onResume`, as for every [GLSurfaceView]. It frees
 * its native memory when it leaves its window, and gives up what can be made again when memory is low. Methods are for the
 * main thread.
 */
@SuppressLint("ClickableViewAccessibility") // there is nothing to click on
public open class GlintView @JvmOverloads constructor(
    context: Context,
    attributes: AttributeSet? = null,
) : GLSurfaceView(context, attributes) {
    /** Told of failures, on the main thread. */
    public fun interface ErrorListener {
        /** Nothing is drawn until there is another scene, or a new context. */
        public fun onError(error: GlintException)
    }

    /** Gets the failures; without, they are logged. */
    public var errorListener: ErrorListener? = null

    private var scene: GlintScene? = null
    private var depth: Int? = null
    private var targetFps: Double? = null
    private var srgb = false
    private var isAttached = false

    private val frames = Frames()
    private val draw = Runnable { requestRender() }

    private val memoryCallbacks = object : ComponentCallbacks2 {
        override fun onConfigurationChanged(configuration: Configuration) = Unit

        @Deprecated("as onTrimMemory")
        override fun onLowMemory() = trim()

        override fun onTrimMemory(level: Int) {
            if (level >= ComponentCallbacks2.TRIM_MEMORY_UI_HIDDEN || level == RUNNING_CRITICAL) trim()
        }
    }

    init {
        setEGLContextClientVersion(2)
        setEGLConfigChooser(8, 8, 8, 0, 0, 0)
        preserveEGLContextOnPause = true
        setRenderer(frames)
        renderMode = RENDERMODE_WHEN_DIRTY
    }

    /**
     * Shows the scene, from its own camera.
     *
     * @param scene stays open as long as the view is to show it; null = nothing
     * @param depth recursive rays in a row; null = what the scene asks for
     * @param targetFps frames a second to hold while something moves; null = the display's
     * @param srgb as in [GlintRenderOptions.srgb]
     */
    @JvmOverloads
    public fun setScene(scene: GlintScene?, depth: Int? = null, targetFps: Double? = null, srgb: Boolean = false) {
        require(depth == null || depth >= 0) { "a depth of less than 0" }
        this.scene = scene
        this.depth = depth
        this.targetFps = targetFps
        this.srgb = srgb
        open()
    }

    /** What is on the screen; null while there is no scene. */
    public val figures: GlintFigures?
        get() = frames.session?.let { session ->
            val all = nativeFigures(session.get())
            GlintFigures(
                all[0].toLong(), all[1], all[2], all[3].toInt(), all[4].toInt(), all[5].toInt(), all[6].toInt(),
                all[7] != 0.0, all[8].toLong(),
            )
        }

    /** Back to the scene's own camera. */
    public fun resetCamera(): Unit = move { nativeResetCamera(it) }

    /** Moves, without turning, so that all of the scene is in the picture. */
    public fun frameScene(): Unit = move { nativeFrameScene(it) }

    /** Gives up all native memory that can be made again, as happens by itself when memory is low. */
    public fun trim() {
        frames.session?.let { nativeTrim(it.get()) }
    }

    override fun onTouchEvent(event: MotionEvent): Boolean {
        val session = frames.session ?: return super.onTouchEvent(event)
        fun finger(what: Int, index: Int) =
            nativeFinger(session.get(), what, event.getPointerId(index), event.getX(index), event.getY(index))
        when (event.actionMasked) {
            MotionEvent.ACTION_DOWN, MotionEvent.ACTION_POINTER_DOWN -> finger(FINGER_DOWN, event.actionIndex)
            MotionEvent.ACTION_MOVE -> repeat(event.pointerCount) { finger(FINGER_MOVED, it) }
            MotionEvent.ACTION_UP, MotionEvent.ACTION_POINTER_UP -> finger(FINGER_UP, event.actionIndex)
            MotionEvent.ACTION_CANCEL -> repeat(event.pointerCount) { finger(FINGER_UP, it) }
            else -> return super.onTouchEvent(event)
        }
        requestRender()
        return true
    }

    override fun onAttachedToWindow() {
        super.onAttachedToWindow()
        isAttached = true
        context.applicationContext.registerComponentCallbacks(memoryCallbacks)
        open()
    }

    override fun onDetachedFromWindow() {
        isAttached = false
        context.applicationContext.unregisterComponentCallbacks(memoryCallbacks)
        removeCallbacks(draw)
        super.onDetachedFromWindow() // ends the thread that draws
        frames.show(null)
        frames.closeAll()
    }

    /** Makes the native session anew, where there is something to show and a window to show it in. */
    private fun open() {
        val scene = scene
        if (scene == null || !isAttached) return frames.show(null)
        val fps = targetFps ?: display?.refreshRate?.toDouble()?.takeIf { it > 0.0 } ?: USUAL_FPS
        val handle = nativeOpen(scene.handle, fps, depth ?: -1, 0, srgb)
        frames.show(NativeHandle(handle) { nativeClose(it) })
        requestRender()
    }

    private fun move(how: (Long) -> Unit) {
        frames.session?.let { how(it.get()) }
        requestRender()
    }

    /** What the drawing thread calls. */
    private inner class Frames : Renderer {
        /** Written by the main thread; the drawing thread may find one that is closed meanwhile. */
        @Volatile var session: NativeHandle? = null
            private set

        /** The drawing thread's: which session the context and the size were told. */
        private var told: NativeHandle? = null
        private var hasFailed = false
        private var widthPx = 0
        private var heightPx = 0

        /** The main thread's: sessions that may not be closed yet. */
        private val retired = mutableListOf<NativeHandle>()

        /** The last session is closed where its context is current, so that nothing of it stays there. */
        fun show(next: NativeHandle?) {
            val last = session
            session = next
            if (last != null) {
                retired += last
                queueEvent { last.close() }
            }
        }

        /** There is no drawing thread any more. */
        fun closeAll() {
            retired.forEach { it.close() }
            retired.clear()
        }

        override fun onSurfaceCreated(gl: GL10?, config: EGLConfig?) {
            told = null
        }

        override fun onSurfaceChanged(gl: GL10?, width: Int, height: Int) {
            widthPx = width
            heightPx = height
            guarded { handle -> nativeResize(handle, width, height) }
        }

        override fun onDrawFrame(gl: GL10?) {
            if (hasFailed && told === session) return
            guarded { handle ->
                if (told !== session) {
                    nativeContextCreated(handle)
                    nativeResize(handle, widthPx, heightPx)
                    told = session
                    hasFailed = false
                }
                val again = nativeDraw(handle)
                if (again <= 0.0) {
                    requestRender()
                } else if (again < Double.POSITIVE_INFINITY) {
                    postDelayed(draw, (again * 1000.0).toLong() + 1)
                }
            }
        }

        private fun guarded(what: (Long) -> Unit) {
            val session = session ?: return
            try {
                what(session.get())
            } catch (error: GlintException) {
                hasFailed = true
                post { errorListener?.onError(error) ?: Log.e("GlintView", "nothing can be shown", error) }
            } catch (closed: IllegalStateException) {
                if (session === this.session) throw closed
            }
        }
    }

    private companion object {
        init {
            GlintLibrary.load()
        }

        const val USUAL_FPS = 60.0
        const val FINGER_DOWN = 0
        const val FINGER_MOVED = 1
        const val FINGER_UP = 2
        const val RUNNING_CRITICAL = 15 // ComponentCallbacks2.TRIM_MEMORY_RUNNING_CRITICAL, deprecated

        @JvmStatic
        private external fun nativeOpen(scene: Long, targetFps: Double, depth: Int, threads: Int, srgb: Boolean): Long

        @JvmStatic private external fun nativeContextCreated(handle: Long)

        @JvmStatic private external fun nativeResize(handle: Long, widthPx: Int, heightPx: Int)

        @JvmStatic private external fun nativeDraw(handle: Long): Double

        @JvmStatic private external fun nativeFinger(handle: Long, what: Int, finger: Int, xPx: Float, yPx: Float)

        @JvmStatic private external fun nativeResetCamera(handle: Long)

        @JvmStatic private external fun nativeFrameScene(handle: Long)

        @JvmStatic private external fun nativeTrim(handle: Long)

        @JvmStatic private external fun nativeFigures(handle: Long): DoubleArray

        @JvmStatic private external fun nativeClose(handle: Long)
    }
}
