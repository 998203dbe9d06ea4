// The native library behind all classes of this package.
package glint.android

import java.util.concurrent.atomic.AtomicLong

/** What the native library is and can do on this device. */
public object GlintLibrary {
    init {
        System.loadLibrary("glint_android")
    }

    /** Of the native library, `"0.1.0"` for instance. */
    @JvmStatic
    public val version: String get() = nativeVersion()

    /**
     * Names of the instruction sets that [GlintRenderer] may choose from, slowest first. The last is the one that is
     * used where nobody chooses; pictures are the same with all of them, to the bit.
     */
    @JvmStatic
    public val instructionSets: List<String> get() = nativeInstructionSets().split(' ')

    /**
     * Native objects that are open: scenes, renderers, jobs and views that were not closed. What grows for ever is a
     * leak.
     */
    @JvmStatic
    public val openHandles: Int get() = nativeOpenHandles()

    /** Loads the library where that has not happened yet. */
    internal fun load() = Unit

    @JvmStatic private external fun nativeVersion(): String

    @JvmStatic private external fun nativeInstructionSets(): String

    @JvmStatic private external fun nativeOpenHandles(): Int
}

/** A native object that is closed once, whoever asks how often. */
internal class NativeHandle(value: Long, private val free: (Long) -> Unit) {
    private val value = AtomicLong(value)

    /** Throws [IllegalStateException] where it is closed. */
    fun get(): Long = value.get().also { check(it != 0L) { "the object is closed" } }

    fun close() {
        val last = value.getAndSet(0L)
        if (last != 0L) free(last)
    }
}
