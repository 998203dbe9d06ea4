// A scene, read and ready to be traced.
package glint.android

import android.content.Context
import android.content.res.AssetManager
import java.io.File

/**
 * A scene of an SDL file and the meshes that it names, checked and with the structure that rays need. It never changes,
 * and any number of [GlintRenderer]s and [GlintView]s, in any threads, may share it.
 *
 * Reading takes milliseconds for small scenes and a second for a million triangles: keep large ones off the main
 * thread. [close] frees the native memory; renderers and views that use the scene keep what they need.
 */
public class GlintScene private constructor(handle: Long) : AutoCloseable {
    private val native = NativeHandle(handle) { nativeClose(it) }
    internal val handle: Long get() = native.get()

    /** Width in pixels of the picture that the scene's author wants. */
    public val widthPx: Int

    /** Height in pixels of that picture. */
    public val heightPx: Int

    /** Recursive rays in a row that the author wants. */
    public val depth: Int

    /** Triangles of all objects and lights. */
    public val triangleCount: Int

    /** What the reader found odd and took all the same, a text for each. */
    public val warnings: List<String>

    init {
        val facts = nativeFacts(handle)
        widthPx = facts[0]
        heightPx = facts[1]
        depth = facts[2]
        triangleCount = facts[3]
        warnings = nativeWarnings(handle).asList()
    }

    /** Frees the native memory. Once is enough; more does nothing. */
    override fun close(): Unit = native.close()

    public companion object {
        init {
            GlintLibrary.load()
        }

        /**
         * Reads a scene from the app's assets, `"scenes/cornell.sdl"` for instance, and its meshes from beside it.
         *
         * @throws GlintException where the scene is missing or not valid
         */
        @JvmStatic
        public fun fromAssets(assets: AssetManager, path: String): GlintScene = GlintScene(nativeFromAssets(assets, path))

        /** As [fromAssets] with the context's assets. */
        @JvmStatic
        public fun fromAssets(context: Context, path: String): GlintScene = fromAssets(context.assets, path)

        /**
         * Reads a scene from the file system, and its meshes from beside it.
         *
         * @throws GlintException where the scene is missing or not valid
         */
        @JvmStatic
        public fun fromFile(file: File): GlintScene = GlintScene(nativeFromFile(file.path))

        /**
         * Reads a scene that is in memory.
         *
         * @param scene the SDL file's bytes
         * @param files the bytes of the meshes, by the names that the scene has for them
         * @throws GlintException where the scene is not valid
         */
        @JvmStatic
        @JvmOverloads
        public fun fromBytes(scene: ByteArray, files: Map<String, ByteArray> = emptyMap()): GlintScene {
            val others = files.filterKeys { it != SCENE_NAME }
            val names = arrayOf(SCENE_NAME) + others.keys
            return GlintScene(nativeFromBytes(names, arrayOf(scene) + others.values))
        }

        private const val SCENE_NAME = "scene.sdl"

        @JvmStatic private external fun nativeFromAssets(assets: AssetManager, path: String): Long

        @JvmStatic private external fun nativeFromFile(path: String): Long

        @JvmStatic private external fun nativeFromBytes(names: Array<String>, contents: Array<ByteArray>): Long

        @JvmStatic private external fun nativeFacts(handle: Long): IntArray

        @JvmStatic private external fun nativeWarnings(handle: Long): Array<String>

        @JvmStatic private external fun nativeClose(handle: Long)
    }
}
