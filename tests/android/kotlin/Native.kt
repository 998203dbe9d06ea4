// What the tests have of C++.
package glint.test

import java.nio.ByteBuffer

object Native {
    init {
        System.loadLibrary("glint_android_test")
    }

    /** A new context without a window, current in this thread; the one before is gone. */
    @JvmStatic external fun openSurface(widthPx: Int, heightPx: Int)

    @JvmStatic external fun closeSurface()

    /** Of what is on the surface. */
    @JvmStatic external fun surfaceHash(): Long

    /** Of pixels in a direct buffer, without gaps. */
    @JvmStatic external fun hash(pixels: ByteBuffer, widthPx: Int, heightPx: Int): Long

    /** Of the picture that the C++ renderer makes; with no samples that which refinement ends with. */
    @JvmStatic external fun renderHash(scene: String, widthPx: Int, heightPx: Int, depth: Int, samples: Int): Long
}

/** The folder of our scenes. */
val scenes: String = System.getProperty("glint.scenes")

/** The golden table's hash of a picture. */
fun goldenHash(scene: String, widthPx: Int, heightPx: Int, depth: Int): Long {
    val line = java.io.File(System.getProperty("glint.golden")).readLines()
        .first { it.startsWith("$scene $widthPx $heightPx $depth ") }
    return java.lang.Long.parseUnsignedLong(line.split(' ')[4], 16)
}
