// A picture on its way.
package glint.android

/**
 * A render that goes on while its caller does other things; any thread may call it. The buffer it renders into stays
 * alive until the job is closed. Close every job: that cancels it, and waits until nothing writes any more.
 */
public class GlintJob internal constructor(handle: Long) : AutoCloseable {
    private val native = NativeHandle(handle) { nativeClose(it) }

    /** Finished share of the picture, from 0 to 1. */
    public val progress: Double get() = nativeProgress(native.get())

    /** Whether [await] returns at once. */
    public val isDone: Boolean get() = nativeIsDone(native.get())

    /** Stops the render within a tile's work, and does not wait for that. */
    public fun cancel(): Unit = nativeCancel(native.get())

    /**
     * Waits for the picture: not for the main thread.
     *
     * @throws GlintException with [GlintException.Code.CANCELLED] where the job was cancelled: then the buffer holds
     *     whole tiles, the rest untouched
     */
    public fun await(): GlintStatistics {
        val done = nativeAwait(native.get())
        return GlintStatistics(done[0], done[1].toLong(), done[2].toLong(), done[3].toLong())
    }

    /** Cancels the render, waits until nothing of it works any more, and lets go of the buffer. */
    override fun close(): Unit = native.close()

    private companion object {
        @JvmStatic private external fun nativeProgress(handle: Long): Double

        @JvmStatic private external fun nativeIsDone(handle: Long): Boolean

        @JvmStatic private external fun nativeCancel(handle: Long)

        @JvmStatic private external fun nativeAwait(handle: Long): DoubleArray

        @JvmStatic private external fun nativeClose(handle: Long)
    }
}
