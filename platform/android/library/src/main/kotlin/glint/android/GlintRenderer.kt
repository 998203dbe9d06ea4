// Pictures of a scene, rendered into memory.
package glint.android

import android.graphics.Bitmap
import java.nio.ByteBuffer

/**
 * How a picture is rendered.
 *
 * @property depth recursive rays in a row after the primary one; null = what the scene asks for
 * @property samplesPerPixel 1 to 4096; null = what the scene asks for
 * @property srgb whether bytes are made by sRGB's transfer curve, as displays expect, or straight from linear light, as
 *     the SDL family's programs did
 */
public data class GlintRenderOptions @JvmOverloads constructor(
    val depth: Int? = null,
    val samplesPerPixel: Int? = null,
    val srgb: Boolean = false,
)

/**
 * What one render did.
 *
 * @property seconds that it took
 * @property primaryRays from the eye
 * @property shadowRays to lights
 * @property secondaryRays mirrored and transmitted
 */
public data class GlintStatistics(
    val seconds: Double,
    val primaryRays: Long,
    val shadowRays: Long,
    val secondaryRays: Long,
)

/**
 * Traces pictures of a scene on all of the device's cores. The pixels depend on scene and options alone: not on the
 * threads, not on the processor. One render at a time; another waits. Any thread may call it.
 *
 * @param scene may be closed once the renderer is there
 * @param threads that trace; 0 = one a core
 * @param instructionSet one of [GlintLibrary.instructionSets]; null = the best
 * @throws GlintException where there is no such instruction set
 */
public class GlintRenderer @JvmOverloads constructor(
    scene: GlintScene,
    threads: Int = 0,
    instructionSet: String? = null,
) : AutoCloseable {
    private val native = NativeHandle(nativeOpen(scene.handle, threads, instructionSet)) { nativeClose(it) }

    /** Threads that trace. */
    public val threads: Int = nativeThreads(native.get())

    /** Instruction set that traces. */
    public val instructionSet: String = nativeInstructionSet(native.get())

    /**
     * Begins to render, and returns at once.
     *
     * @param target a direct buffer that can be written to. The picture lies in it from byte 0 on, whatever its position
     *     and limit: R, G, B, A bytes, the top row first. It may be read before the job is done, and holds whatever it
     *     held where nothing is rendered yet
     * @param strideBytes from a row to the next; what lies between rows is never written
     * @throws IllegalArgumentException where the buffer is not direct, read-only or too small
     */
    @JvmOverloads
    public fun start(
        target: ByteBuffer,
        widthPx: Int,
        heightPx: Int,
        options: GlintRenderOptions = GlintRenderOptions(),
        strideBytes: Int = widthPx * 4,
    ): GlintJob {
        require(!target.isReadOnly) { "the buffer is read-only" }
        require(options.depth == null || options.depth >= 0) { "a depth of less than 0" }
        require(options.samplesPerPixel == null || options.samplesPerPixel >= 1) { "less than one sample a pixel" }
        return GlintJob(
            nativeStart(
                native.get(), target, widthPx, heightPx, strideBytes,
                options.depth ?: -1, options.samplesPerPixel ?: -1, options.srgb,
            ),
        )
    }

    /** As [start], and waits for the picture: not for the main thread. */
    @JvmOverloads
    public fun render(
        target: ByteBuffer,
        widthPx: Int,
        heightPx: Int,
        options: GlintRenderOptions = GlintRenderOptions(),
        strideBytes: Int = widthPx * 4,
    ): GlintStatistics = start(target, widthPx, heightPx, options, strideBytes).use { it.await() }

    /** Renders a bitmap of configuration `ARGB_8888` that can be written to: not for the main thread. */
    @JvmOverloads
    public fun render(target: Bitmap, options: GlintRenderOptions = GlintRenderOptions()): GlintStatistics {
        require(target.config == Bitmap.Config.ARGB_8888 && target.isMutable) { "not a mutable bitmap of ARGB_8888" }
        val stride = target.rowBytes
        val pixels = ByteBuffer.allocateDirect(stride * target.height)
        val done = render(pixels, target.width, target.height, options, stride)
        target.copyPixelsFromBuffer(pixels)
        return done
    }

    /** Frees the native memory and threads, once jobs that use them are closed. More than once does nothing. */
    override fun close(): Unit = native.close()

    private companion object {
        init {
            GlintLibrary.load()
        }

        @JvmStatic private external fun nativeOpen(scene: Long, threads: Int, instructionSet: String?): Long

        @JvmStatic
        private external fun nativeStart(
            handle: Long,
            target: ByteBuffer,
            widthPx: Int,
            heightPx: Int,
            strideBytes: Int,
            depth: Int,
            samplesPerPixel: Int,
            srgb: Boolean,
        ): Long

        @JvmStatic private external fun nativeThreads(handle: Long): Int

        @JvmStatic private external fun nativeInstructionSet(handle: Long): String

        @JvmStatic private external fun nativeClose(handle: Long)
    }
}
