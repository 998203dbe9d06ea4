// A ray-traced room in an app. Fingers orbit, pan and zoom; cornell.sdl and its meshes are in the app's assets.
package examples

import android.app.Activity
import android.os.Bundle
import glint.android.GlintScene
import glint.android.GlintView

class RoomActivity : Activity() {
    private val scene by lazy { GlintScene.fromAssets(this, "cornell.sdl") }
    private val view by lazy { GlintView(this).apply { setScene(scene) } }

    override fun onCreate(state: Bundle?) = super.onCreate(state).also { setContentView(view) }
    override fun onResume() = super.onResume().also { view.onResume() }
    override fun onPause() = super.onPause().also { view.onPause() }
    override fun onDestroy() = super.onDestroy().also { scene.close() }
}
